// What a call was refused with: "STATUS: MESSAGE" of the metamer::Error, or "no error".
#pragma once

#include <string>

#include "base/error.h"

namespace metamer {

template <class Call>
std::string error_of(const Call& call) {
    try {
        call();
    } catch (const Error& e) {
        return std::to_string(static_cast<int>(e.status())) + ": " + e.what();
    }
    return "no error";
}

} // namespace metamer
