#include "exhibit/kiosk_setting.h"

namespace metamer {

std::string TourStep::caption(const std::string& language) const {
    const auto own = captions.find(language), common = captions.find("");
    return own != captions.end() ? own->second : common != captions.end() ? common->second : std::string();
}

} // namespace metamer
