#include "overlay/controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace metamer {

namespace {

/// A range from tight to comfortable, units.
struct Range {
    double least, most;
    double at(double comfort) const { return least + comfort * (most - least); }
};

constexpr Range kGap{0.7, 1.6};
constexpr Range kTileHeight{12, 15};
constexpr Range kBarHeight{9, 11};
constexpr double kWidestTile = 40;

// Widths in the bar: the least that their words need, the most that look like buttons.
constexpr Range kSlider{26, 70}, kMode{24, 40}, kExpert{15, 26}, kLanguage{12, 18};

// Where the screen is narrow, the expert's panel has to stand among the other things over the scene.
constexpr double kNarrow = 120, kLeastNarrowScene = 92;

/// What labels, notice, caption, hint and handle need above each other.
double least_scene(double width, double gap) {
    const double all =
        kLabelHeight + kNoticeHeight + kCaptionHeight + kHintHeight + kHandleHeight + kCloseInset + 6 * gap;
    return width < kNarrow ? std::max(all, kLeastNarrowScene) : all;
}

// Letters of 2.5 units keep 10 px, and a whole screen's shorter side is so many units.
constexpr double kLeastUnit_px = 4, kMostUnits = 170, kFewestUnits = 60;
constexpr double kAssumedDiagonal_mm = 10.1 * 25.4;

double full_unit_px(const ScreenSize& screen) {
    const double width = screen.width_px, height = screen.height_px;
    const double known = std::isfinite(screen.px_per_mm) && screen.px_per_mm > 0
                             ? screen.px_per_mm
                             : std::hypot(width, height) / kAssumedDiagonal_mm;
    const double shorter = std::min(width, height);
    return std::clamp(known, std::max(kLeastUnit_px, shorter / kMostUnits),
                      std::max(kLeastUnit_px, shorter / kFewestUnits));
}

int ceil_div(int a, int b) {
    return (a + b - 1) / b;
}

/// How many boxes of this least width stand in a row.
int fitting(double width, double least, double gap) {
    return std::max(1, static_cast<int>((width + gap) / (least + gap)));
}

/// Widths of the controls in the bar, in their order.
struct Bar {
    std::vector<Range> all;
    std::size_t languages_from;
};

Bar bar_of(const Contents& contents) {
    Bar bar{{kSlider}, 0};
    if (contents.lamps > 1)
        bar.all.push_back(kMode);
    bar.all.push_back(kExpert);
    bar.languages_from = bar.all.size();
    if (contents.languages > 1)
        bar.all.insert(bar.all.end(), static_cast<std::size_t>(contents.languages), kLanguage);
    return bar;
}

double least_width(const Range* from, const Range* to, double gap) {
    double width = -gap;
    for (; from != to; ++from)
        width += from->least + gap;
    return width;
}

/// The fewest rows that hold the bar; false where even three do not.
bool arrange_bar(const Contents& contents, double width, Controls& controls) {
    const Bar bar = bar_of(contents);
    const Range *first = bar.all.data(), *language = first + bar.languages_from,
                *last = first + bar.all.size();
    controls.languages_in_row = fitting(width, kLanguage.least, controls.gap);
    if (least_width(first, last, controls.gap) <= width)
        controls.bar_rows = 1;
    else if (least_width(first, language, controls.gap) <= width)
        controls.bar_rows = 2;
    else
        controls.bar_rows = 3;
    return controls.bar_rows < 3 || least_width(first + 1, language, controls.gap) <= width;
}

/// From comfortable to tight: everything else first, then the width that a lamp's name has.
struct Tightness {
    double comfort, tile_width;
};
constexpr std::array<Tightness, 4> kTightnesses{{{1, 16}, {0.5, 15.5}, {0, 15}, {0, 12}}};

std::optional<Controls> arrange(const ScreenSize& screen, const Contents& contents, double unit_px,
                                const Tightness& tightness) {
    const auto& [comfort, tile_width] = tightness;
    Controls c{unit_px, kGap.at(comfort), kTileHeight.at(comfort), kBarHeight.at(comfort), 0, 0, 1, 1, 0};
    const double width = screen.width_px / unit_px - 2 * c.gap, height = screen.height_px / unit_px;
    if (!arrange_bar(contents, width, c))
        return {};
    if (contents.lamps > 0) {
        const double shelf = contents.booth ? (width - c.gap) / 2 : width;
        c.rows = ceil_div(contents.lamps, fitting(shelf, tile_width, c.gap));
        c.columns = ceil_div(contents.lamps, c.rows);
        if (shelf < tile_width)
            return {};
    }
    const int bars = c.bar_rows == 1 ? 1 : c.bar_rows - 1 + c.language_rows(contents.languages);
    c.height = c.gap + c.rows * (c.tile + c.gap) + bars * (c.bar + c.gap);
    const bool fits =
        c.height + kCloseHeight + kCloseInset <= height / 2 && height - c.height >= least_scene(width, c.gap);
    return fits ? std::optional(c) : std::nullopt;
}

struct Row {
    double left, top, bottom;
};

/// Places boxes of these ranges side by side over the whole width; what is over when all are at their widest
/// lies before `pushed`, which starts the group at the far end.
std::vector<PxBox> place_row(const Controls& controls, Row row, double width, std::span<const Range> boxes,
                             std::size_t pushed) {
    double least = -controls.gap, most = -controls.gap;
    for (const Range& box : boxes) {
        least += box.least + controls.gap;
        most += box.most + controls.gap;
    }
    const double share = most > least ? std::clamp((width - least) / (most - least), 0.0, 1.0) : 0.0;
    const double over = std::max(width - most, 0.0);
    std::vector<PxBox> placed;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (i == pushed)
            row.left += over;
        const double right = row.left + boxes[i].at(share);
        placed.push_back(px_box(controls.unit_px, row.left, row.top, right, row.bottom));
        row.left = right + controls.gap;
    }
    return placed;
}

std::vector<PxBox> place_shelf(const Controls& c, int lamps, double left, double top, double width) {
    const double tile = std::min(kWidestTile, (width - (c.columns - 1) * c.gap) / c.columns);
    const double start = left + (width - c.columns * tile - (c.columns - 1) * c.gap) / 2;
    std::vector<PxBox> tiles;
    for (int i = 0; i < lamps; ++i) {
        const double x = start + i % c.columns * (tile + c.gap);
        const double y = top + i / c.columns * (c.tile + c.gap);
        tiles.push_back(px_box(c.unit_px, x, y, x + tile, y + c.tile));
    }
    return tiles;
}

void place_languages(const Controls& c, int languages, double top, double width, Layout& layout) {
    for (int done = 0; done < languages; done += c.languages_in_row) {
        const auto count = static_cast<std::size_t>(std::min(c.languages_in_row, languages - done));
        const std::vector<Range> row(count, kLanguage);
        for (const PxBox& box : place_row(c, {c.gap, top, top + c.bar}, width, row, count))
            layout.languages.push_back(box);
        top += c.bar + c.gap;
    }
}

void place_bar(const Controls& c, const Contents& contents, double top, double width, Layout& layout) {
    const Bar bar = bar_of(contents);
    std::span<const Range> rest = bar.all;
    std::vector<PxBox> boxes;
    const auto next_row = [&](std::size_t count, std::size_t pushed) {
        for (const PxBox& box : place_row(c, {c.gap, top, top + c.bar}, width, rest.first(count), pushed))
            boxes.push_back(box);
        rest = rest.subspan(count);
        top += c.bar + c.gap;
    };
    if (c.bar_rows == 3)
        next_row(1, 1);
    const std::size_t before_languages = bar.languages_from - boxes.size();
    next_row(c.bar_rows == 1 ? rest.size() : before_languages, before_languages);
    if (c.bar_rows > 1 && !rest.empty())
        place_languages(c, contents.languages, top, width, layout);
    auto box = boxes.begin();
    layout.strength = *box++;
    if (contents.lamps > 1)
        layout.mode = *box++;
    layout.expert = *box++;
    layout.languages.insert(layout.languages.end(), box, boxes.end());
}

} // namespace

int Controls::language_rows(int languages) const {
    return languages > 1 ? ceil_div(languages, languages_in_row) : 0;
}

Controls arrange_controls(const ScreenSize& screen, const Contents& contents) {
    constexpr double kStep = 0.98, kSmallest_px = 0.1;
    double unit_px = full_unit_px(screen);
    while (unit_px > kSmallest_px) {
        for (const Tightness& tightness : kTightnesses)
            if (const auto found = arrange(screen, contents, unit_px, tightness))
                return *found;
        unit_px *= kStep;
    }
    return {unit_px, 0, 0, 0, 1, 0, 1, 1, 0};
}

void place_controls(const Controls& c, const ScreenSize& screen, const Contents& contents, Layout& layout) {
    const double width = screen.width_px / c.unit_px - 2 * c.gap;
    double top = screen.height_px / c.unit_px - c.height + c.gap;
    if (contents.lamps > 0) {
        const double half = (width - c.gap) / 2;
        layout.lamps = place_shelf(c, contents.lamps, c.gap, top, contents.booth ? half : width);
        if (contents.booth)
            layout.lamps_right = place_shelf(c, contents.lamps, c.gap + width - half, top, half);
        top += c.rows * (c.tile + c.gap);
    }
    place_bar(c, contents, top, width, layout);
}

PxBox px_box(double unit_px, double left, double top, double right, double bottom) {
    const auto px = [&](double units) { return static_cast<int>(std::lround(units * unit_px)); };
    return {px(left), px(top), px(right) - px(left), px(bottom) - px(top)};
}

} // namespace metamer
