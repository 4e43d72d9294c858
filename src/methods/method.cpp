#include "methods/method.h"

#include "base/names.h"

namespace metamer {

std::optional<Method> find_method(std::string_view name) {
    for (const MethodInfo& info : kMethods)
        if (same_name(info.name, name))
            return info.method;
    return std::nullopt;
}

} // namespace metamer
