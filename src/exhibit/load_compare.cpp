// [compare]
#include "base/numbers.h"
#include "exhibit/load_parts.h"
#include "exhibit/values.h"

namespace metamer {

namespace {

void load_split(const Setting& setting, const Display& display, Compare& compare) {
    if (!setting.value.ends_with("px")) {
        compare.split = number(setting);
        return;
    }
    const auto column = parse_whole(std::string_view(setting.value).substr(0, setting.value.size() - 2));
    if (!column || *column < 0 || *column > display.width_px)
        throw refused(setting, "is no column of the picture; it may be 0px .. " +
                                   std::to_string(display.width_px) + "px");
    compare.split_px = column;
}

Half load_half(const Settings& settings, const std::string& side, Rows& rows) {
    Half half;
    if (const Setting* s = settings.find("compare", side + ".method"))
        half.method = method_choice(*s);
    if (const Setting* s = settings.find("compare", side + ".lamp"))
        half.lamp = rows.lamp(*s, s->value);
    if (const Setting* s = settings.find("compare", side + ".working_space"))
        half.working_space = &working_spaces()[choice(*s)];
    if (const Setting* s = settings.find("compare", side + ".strength"))
        half.strength = number(*s);
    return half;
}

} // namespace

std::optional<Compare> load_compare(const Settings& settings, const Display& display, Rows& rows) {
    if (settings.sections("compare").empty())
        return std::nullopt;
    Compare compare;
    if (const Setting* s = settings.find("compare", "split"))
        load_split(*s, display, compare);
    if (const Setting* s = settings.find("compare", "line"))
        compare.line_px = whole(*s);
    compare.left = load_half(settings, "left", rows);
    compare.right = load_half(settings, "right", rows);
    return compare;
}

} // namespace metamer
