#include "report/geometry.h"

namespace metamer {

bool crosses(const Box& box, Px a, Px b) {
    double enter = 0, leave = 1;
    const auto cut = [&](double delta, double to_low, double to_high) {
        if (delta == 0)
            return to_low < 0 && to_high > 0;
        const double first = (delta > 0 ? to_low : to_high) / delta;
        const double last = (delta > 0 ? to_high : to_low) / delta;
        enter = std::max(enter, first);
        leave = std::min(leave, last);
        return true;
    };
    return cut(b.x - a.x, box.left - a.x, box.right - a.x) &&
           cut(b.y - a.y, box.top - a.y, box.bottom - a.y) && enter < leave;
}

} // namespace metamer
