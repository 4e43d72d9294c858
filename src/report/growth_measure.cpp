#include "report/growth_measure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "base/error.h"
#include "exhibit/load.h"
#include "exhibit/scene_kinds.h"
#include "gles/info.h"
#include "report/chart_exhibits.h"
#include "report/chart_measure.h"
#include "report/frame_timing.h"
#include "report/statistics.h"

namespace metamer {

namespace {

constexpr std::array kLampNames{"A2800", "F11", "D65", "E", "F2", "F7", "C", "B"};
constexpr int kOrdinaryTaps = 8; // of reduced where something else is swept
constexpr int kBallMaterials = 8;

/// One frame of a panel.
struct Point {
    Entry entry;
    double x = 0;
    Exhibit exhibit;
};

struct Panel {
    std::string title, swept;
    bool log_x = true;
    std::vector<Point> points; ///< the first is rgb-pow at the sweep's start
};

/// Names of materials, those that the still-life's objects wear first: they are in its atlas anyway.
std::vector<std::string> material_names() {
    std::vector<std::string> out;
    const auto add = [&](const std::string& name) {
        if (!name.empty() && std::find(out.begin(), out.end(), name) == out.end())
            out.push_back(name);
    };
    for (const ObjectDefault& object : scene_objects(SceneKind::still_life, {}))
        add(object.material);
    for (const Material& material : library_materials())
        add(material.name);
    return out;
}

std::string materials_text(int count) {
    const auto names = material_names();
    std::string out;
    for (int i = 0; i < count; ++i)
        out += (i > 0 ? ", " : "") + names[static_cast<std::size_t>(i)];
    return out;
}

std::string lamps_text(int count) {
    std::string out;
    for (int i = 0; i < count; ++i)
        out += "[lamp." + std::to_string(i + 1) + "]\nspectrum = " + kLampNames[static_cast<std::size_t>(i)] +
               "\nstrength = " + std::to_string(1.0 / count) + "\n";
    return out;
}

/// A picture in whose columns the keys 1 .. count follow one another.
Image key_map(int count) {
    constexpr int width = 256, height = 64;
    Image map{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, 255)};
    for (std::size_t i = 0; i < map.rgba.size(); i += 4)
        map.rgba[i] = static_cast<std::uint8_t>(1 + static_cast<int>(i / 4 % width) * count / width);
    return map;
}

Exhibit parsed(const std::string& text, const Display& display) {
    Exhibit exhibit = parse_exhibit(text, "growth", ".");
    exhibit.display = display;
    return exhibit;
}

/// The still-life with `materials` on its ball, under `lamps`.
Exhibit still_life(const Display& display, int lamps, int materials) {
    Exhibit exhibit = parsed("[scene]\nkind = still-life\nmaterials = " + materials_text(materials) + "\n" +
                                 lamps_text(lamps),
                             display);
    for (ObjectSetting& object : exhibit.objects)
        if (object.name == "ball")
            object.key_map = key_map(materials);
    return exhibit;
}

Exhibit loaf(const Display& display, int slices) {
    return parsed("[scene]\nkind = loaf\nmaterials = " + materials_text(slices) + "\n" + lamps_text(1),
                  display);
}

Curve with_samples(const Curve& curve, int count) {
    Curve out;
    const double first = kThesisGrid.first_nm,
                 last = kThesisGrid.wavelength_nm(static_cast<std::size_t>(kThesisGrid.count - 1));
    for (int i = 0; i < count; ++i) {
        out.wavelength_nm.push_back(std::lerp(first, last, i / (count - 1.0)));
        out.value.push_back(value_at_held(curve, out.wavelength_nm.back()));
    }
    return out;
}

/// The exhibit as if its spectra were known at this many wavelengths.
Exhibit sampled_at(Exhibit exhibit, int wavelengths) {
    for (auto& [key, material] : exhibit.materials)
        material.spectrum.curve = with_samples(material.spectrum.curve, wavelengths);
    for (LampSetting& lamp : exhibit.lamps)
        if (!lamp.lamp.spectrum.continuum.value.empty())
            lamp.lamp.spectrum.continuum = with_samples(lamp.lamp.spectrum.continuum, wavelengths);
    Atlas atlas = empty_atlas(exhibit.atlas.quantization);
    for (const auto& [key, material] : exhibit.materials)
        add_material(atlas, material);
    for (const LampSetting& lamp : exhibit.lamps)
        add_lamp(atlas, lamp.lamp);
    exhibit.atlas = atlas;
    return exhibit;
}

/// rgb-pow, each method once, planned.
std::vector<Entry> one_of_each() {
    std::vector<Entry> out;
    for (const Entry& entry : chart_entries())
        if (entry.method != Method::reduced || entry.taps == kOrdinaryTaps)
            out.push_back(entry);
    return out;
}

template <class Make>
Panel swept(const std::string& title, const std::string& unit, bool log_x, std::span<const int> xs,
            const Make& make) {
    Panel panel{title, unit, log_x, {}};
    for (const int x : xs) {
        const Exhibit exhibit = make(x);
        for (const Entry& entry : one_of_each())
            panel.points.push_back({entry, static_cast<double>(x), exhibit});
    }
    return panel;
}

Panel wavelengths_panel(const Display& display) {
    const Exhibit exhibit = still_life(display, 1, kBallMaterials);
    Panel panel{"wavelengths", "wavelengths", true, {}};
    for (const Entry& entry : chart_entries())
        if (entry.method == Method::reduced || entry.everybody || entry.sums() == kIntervals)
            panel.points.push_back(
                {entry, static_cast<double>(entry.everybody ? kTapCounts[0] : entry.sums()), exhibit});
    const Entry planned{std::string(kPlannedName), std::nullopt};
    for (const int count : {8, 16, 32, 64})
        panel.points.push_back({planned, static_cast<double>(count), sampled_at(exhibit, count)});
    return panel;
}

std::vector<Panel> panels(const Display& display) {
    constexpr std::array lamps{1, 2, 3, 4, 6, 8};
    constexpr std::array counts{1, 2, 4, 8, 16, 32, 63};
    std::vector<int> widths;
    for (int width = 160; width <= display.width_px; width *= 2)
        widths.push_back(width);
    const auto sized = [&](int width) {
        Display out = display;
        out.width_px = width;
        out.height_px = std::max(1, width * 9 / 16);
        return out;
    };
    std::vector<Panel> out{
        wavelengths_panel(display),
        swept("lamps", "lamps", false, lamps, [&](int n) { return still_life(display, n, kBallMaterials); }),
        swept("materials on one object", "materials", true, counts,
              [&](int n) { return still_life(display, 1, n); }),
        swept("objects, the same pixels", "objects", true, counts, [&](int n) { return loaf(display, n); }),
        swept("pixels", "pixels", true, widths,
              [&](int width) { return still_life(sized(width), 1, kBallMaterials); })};
    for (Point& point : out.back().points)
        point.x *= point.exhibit.display.height_px;
    return out;
}

/// The rows of one panel.
void measure(const Panel& panel, Growth& growth, const StopWatch& watch) {
    std::vector<std::unique_ptr<TimedFrame>> frames;
    std::vector<std::function<void()>> draws;
    std::vector<const Point*> drawn;
    for (const Point& point : panel.points)
        try {
            frames.push_back(
                std::make_unique<TimedFrame>(drawn_by(point.exhibit, point.entry.method, point.entry.taps),
                                             DrawStyle{.everybody = point.entry.everybody}));
            draws.push_back([frame = frames.back().get()] { frame->draw(); });
            drawn.push_back(&point);
        } catch (const Error& error) {
            std::string& left_out = growth.context.left_out;
            left_out +=
                (left_out.empty() ? "" : "; ") + panel.title + ", " + point.entry.name + ": " + error.cause();
        }
    const auto ms = time_rounds(draws, growth.context.rounds, watch);
    std::map<double, std::size_t> base; // rgb-pow by x
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (drawn[i]->entry.everybody)
            base[drawn[i]->x] = i;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const Point& point = *drawn[i];
        const auto here = base.contains(point.x) ? base[point.x] : base.begin()->second;
        const Summary ratio =
            summarize(ratios(ms[i], ms[base.begin()->second]), "ratios of " + point.entry.name);
        growth.rows.push_back(
            {.panel = panel.title,
             .swept = panel.swept,
             .log_x = panel.log_x,
             .method = point.entry.name,
             .x = point.x,
             .ms = summarize(ms[i], "times of " + point.entry.name).median,
             .cost_ratio = ratio.median,
             .cost_ratio_q1 = ratio.q1,
             .cost_ratio_q3 = ratio.q3,
             .cost_ratio_here = summarize(ratios(ms[i], ms[here]), "ratios of " + point.entry.name).median});
    }
}

} // namespace

Growth measure_growth(const Display& display, int rounds) {
    const FrameClock clock = frame_clock();
    Growth growth;
    growth.context = {.gl_renderer = gl_renderer(),
                      .timer = clock.name,
                      .width_px = display.width_px,
                      .height_px = display.height_px,
                      .rounds = rounds};
    for (const Panel& panel : panels(display))
        measure(panel, growth, clock.watch);
    return growth;
}

} // namespace metamer
