// [kiosk], [tour.N], and what of [display] is for `metamer run` alone.
#include <algorithm>
#include <map>

#include "base/names.h"
#include "base/numbers.h"
#include "exhibit/load_parts.h"
#include "exhibit/values.h"
#include "methods/three_numbers.h"

namespace metamer {

namespace {

std::optional<int> minute_of_day(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || text.size() != colon + 3)
        return std::nullopt;
    const auto hours = parse_whole(text.substr(0, colon)), minutes = parse_whole(text.substr(colon + 1));
    const bool fits = hours && minutes && *hours >= 0 && *hours <= 23 && *minutes >= 0 && *minutes <= 59;
    return fits ? std::optional(60 * *hours + *minutes) : std::nullopt;
}

NightHours night_hours(const Setting& setting) {
    const std::vector<std::string> ends = split(setting.value, '-');
    const bool two = ends.size() == 2;
    const auto from = two ? minute_of_day(ends[0]) : std::nullopt,
               to = two ? minute_of_day(ends[1]) : std::nullopt;
    if (!from || !to)
        throw refused(setting, "is not " + range_text(*setting.info));
    if (*from == *to)
        throw refused(setting, "would be dark all day");
    return {*from, *to};
}

// A language's code becomes a file's name.
std::string language(const Setting& setting, std::string_view code) {
    const bool plain = !code.empty() && code.size() <= 16 && std::ranges::all_of(code, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-';
    });
    if (!plain)
        throw refused(setting, "names no language: letters and -, as in pt-BR");
    return std::string(code);
}

std::vector<LampSetting> shelf(const Setting& setting, Rows& rows) {
    std::vector<LampSetting> lamps;
    for (const std::string& piece : split(setting.value, ',')) {
        const std::string name(trimmed(piece));
        if (name.empty())
            throw refused(setting, "has nothing between two commas");
        lamps.push_back(rows.lamp(setting, name));
        const auto same = [&](const LampSetting& other) { return other.key == lamps.back().key; };
        if (std::count_if(lamps.begin(), lamps.end(), same) > 1)
            throw refused(setting, "has " + name + " twice");
    }
    if (lamps.size() > kMostShelfLamps)
        throw refused(setting, "is " + std::to_string(lamps.size()) + " lamps; at most " +
                                   std::to_string(kMostShelfLamps) + " fit on the shelf");
    return lamps;
}

/// A visitor may light all of a half with any of them; half_views() would refuse it only then.
void check_adaptation(const Settings& settings, const Setting& shelf, const KioskSetting& kiosk,
                      const Atlas& atlas) {
    if (load_display(settings).adaptation != Adaptation::bradford)
        return;
    const Setting& adaptation = *settings.find("display", "adaptation");
    const GridObserver eye = observer(atlas);
    for (const LampSetting& lamp : kiosk.lamps)
        try {
            const Xyz white = lamp_xyz(emission(atlas, lamp.key), eye);
            if (white.y > 0)
                bradford(white, white);
        } catch (const Error& inner) {
            throw bad_input("read", shelf.place,
                            shelf.key + ": " + lamp.lamp.name + " does not go with adaptation = " +
                                adaptation.value + " (" + adaptation.place + "): " + inner.cause());
        }
}

std::size_t on_shelf(const Setting& setting, const KioskSetting& kiosk, Rows& rows) {
    const int key = rows.lamp(setting, setting.value).key;
    const auto found = std::ranges::find(kiosk.lamps, key, &LampSetting::key);
    if (found == kiosk.lamps.end())
        throw refused(setting, "is not on the shelf; add it to [kiosk] lamps");
    return static_cast<std::size_t>(found - kiosk.lamps.begin());
}

/// A side of the booth that nobody wrote: where it would start, or beside that where the other side is.
std::size_t booth_side(std::size_t usual, std::size_t last, std::optional<std::size_t> other) {
    const std::size_t side = std::min(usual, last);
    return side == other && side > 0 ? side - 1 : side;
}

void load_booth(const Settings& settings, KioskSetting& kiosk, Rows& rows) {
    const std::size_t last = kiosk.lamps.size() - 1;
    const auto written = [&](const char* key) {
        const Setting* s = settings.find("kiosk", key);
        return s ? std::optional(on_shelf(*s, kiosk, rows)) : std::nullopt;
    };
    const std::optional<std::size_t> left = written("booth.left"), right = written("booth.right");
    kiosk.booth_right = right ? *right : booth_side(3, last, left);
    kiosk.booth_left = left ? *left : booth_side(1, last, kiosk.booth_right);
}

TourStep load_step(const Settings& settings, const std::string& section, const KioskSetting& kiosk,
                   Rows& rows) {
    TourStep step;
    if (const Setting* s = settings.find(section, "lamp"))
        step.lamp = on_shelf(*s, kiosk, rows);
    if (const Setting* s = settings.find(section, "split"))
        step.split = number(*s);
    if (const Setting* s = settings.find(section, "seconds"))
        step.seconds = number(*s);
    for (const Setting* s : settings.of(section)) {
        if (s->key == "caption")
            step.captions[""] = s->value;
        else if (s->key.starts_with("caption."))
            step.captions[language(*s, std::string_view(s->key).substr(8))] = s->value;
    }
    return step;
}

/// The sections of the tour by number, without gaps.
std::vector<std::string> tour_sections(const Settings& settings) {
    const std::vector<Settings::Section> written = settings.sections("tour.N");
    std::vector<std::string> sections;
    for (std::size_t i = 0; i < written.size(); ++i) {
        sections.push_back("tour." + std::to_string(i + 1));
        if (std::ranges::find(written, sections.back(), &Settings::Section::name) == written.end())
            throw bad_input("read", written[0].place,
                            "there is no [" + sections.back() +
                                "]; steps of the tour are numbered from 1 without gaps");
    }
    return sections;
}

void load_tour(const Settings& settings, Rows& rows, KioskSetting& kiosk,
               const std::function<std::shared_ptr<const Exhibit>(const Setting&)>& with_materials) {
    std::map<std::string, std::shared_ptr<const Exhibit>> scenes;
    for (const std::string& section : tour_sections(settings)) {
        kiosk.tour.push_back(load_step(settings, section, kiosk, rows));
        if (const Setting* s = settings.find(section, "materials")) {
            auto& scene = scenes[s->value];
            if (!scene)
                scene = with_materials(*s);
            kiosk.tour.back().scene = scene;
        }
    }
}

void load_screen(const Settings& settings, KioskSetting& kiosk) {
    if (const Setting* s = settings.find("display", "fullscreen"))
        kiosk.fullscreen = yes_no(*s);
    if (const Setting* s = settings.find("display", "rotation"))
        kiosk.rotation_deg = 90 * static_cast<int>(choice(*s));
    if (const Setting* s = settings.find("display", "diagonal"))
        kiosk.diagonal_in = number(*s);
}

} // namespace

KioskSetting load_kiosk(const Settings& settings, Rows& rows, bool with_shelf, const std::string& place,
                        const std::function<std::shared_ptr<const Exhibit>(const Setting&)>& with_materials) {
    KioskSetting kiosk;
    load_screen(settings, kiosk);
    if (const Setting* s = settings.find("kiosk", "idle_s"))
        kiosk.idle_s = number(*s);
    if (const Setting* s = settings.find("kiosk", "language")) {
        kiosk.language = language(*s, s->value);
        kiosk.language_place = s->place;
    }
    if (const Setting* s = settings.find("kiosk", "strings"))
        kiosk.strings = s->folder / s->value;
    if (const Setting* s = settings.find("kiosk", "night"))
        kiosk.night = night_hours(*s);
    if (const Setting* s = settings.find("kiosk", "pixel_shift"))
        kiosk.pixel_shift_px = whole(*s);
    if (const Setting* s = settings.find("kiosk", "watch_s"))
        kiosk.watch_s = number(*s);
    if (!with_shelf && settings.sections("kiosk").empty() && settings.sections("tour.N").empty())
        return kiosk;
    const Setting* written = settings.find("kiosk", "lamps");
    const Setting ours =
        unwritten("kiosk", "lamps", std::string(find_key("kiosk", "lamps")->fallback), place);
    kiosk.lamps = shelf(written ? *written : ours, rows);
    if (with_shelf)
        check_adaptation(settings, written ? *written : ours, kiosk, rows.atlas());
    load_booth(settings, kiosk, rows);
    load_tour(settings, rows, kiosk, with_materials);
    return kiosk;
}

} // namespace metamer
