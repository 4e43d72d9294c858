#include "report/picture.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "report/panel.h"
#include "report/surface.h"

namespace metamer {

namespace {

constexpr int kLeastWidth = 320, kLeastHeight = 240, kMostSide = 4096;

void check(const Picture& picture) {
    const auto refuse = [&](const std::string& cause) { throw bad_input("draw", picture.title, cause); };
    if (picture.width_px < kLeastWidth || picture.height_px < kLeastHeight || picture.width_px > kMostSide ||
        picture.height_px > kMostSide)
        refuse("its size is " + std::to_string(picture.width_px) + "x" + std::to_string(picture.height_px) +
               ", outside 320x240 .. 4096x4096");
    if (picture.columns < 1)
        refuse("it has " + std::to_string(picture.columns) + " columns");
}

// Text grows with the picture, slower than its sides: 13 px at 1200x800, 17 at 1600x1000.
double em_of(const Picture& picture) {
    return std::clamp(std::sqrt(static_cast<double>(picture.width_px) * picture.height_px) / 75, 9.0, 24.0);
}

// Draws lines from the top of `free` and takes their height off it.
void draw_lines(Canvas& canvas, Box& free, std::span<const std::string> lines, const Font& font,
                Paint paint) {
    for (const std::string& line : lines) {
        canvas.text({free.left, free.top + canvas.ascent(font)}, line, font, paint);
        free.top += canvas.line_height(font) * 1.1;
    }
}

void draw_sign(Canvas& canvas, const KeyItem& item, Px at, double em) {
    const Pen pen{kFaded, em * 0.11};
    const auto level = [&](double above, double half) {
        canvas.line({at.x - em * half, at.y - em * above}, {at.x + em * half, at.y - em * above}, pen);
    };
    switch (item.sign) {
    case KeyItem::Sign::line:
        return canvas.line({at.x - em * 0.5, at.y}, {at.x + em * 0.5, at.y},
                           {series_paint(kColors - 1), em * 0.2});
    case KeyItem::Sign::bar:
        canvas.line({at.x, at.y - em * 0.55}, {at.x, at.y + em * 0.4}, pen);
        level(0.55, 0.3);
        level(0.1, 0.2);
        return canvas.marker(item.marker, item.hollow, {at.x, at.y + em * 0.4}, em * 0.27, kFaded);
    case KeyItem::Sign::marker:
        return canvas.marker(item.marker, item.hollow, at, em * 0.34, kFaded);
    }
}

void draw_key(Canvas& canvas, Box& free, const Picture& picture, double em) {
    if (picture.key.empty())
        return;
    const Font font{em * 0.85};
    const double sign = em * 1.25, between = em * 1.6, line = canvas.line_height(font) * 1.25;
    double x = free.left;
    for (const KeyItem& item : picture.key) {
        const std::string text = canvas.fitted(item.text, font, free.width() - sign);
        const double width = sign + canvas.width(text, font);
        if (x > free.left && x + width > free.right) {
            x = free.left;
            free.top += line;
        }
        draw_sign(canvas, item, {x + em * 0.4, free.top + line / 2}, em);
        canvas.text({x + sign, free.top + line / 2 + canvas.ascent(font) * 0.38}, text, font, kFaded);
        x += width + between;
    }
    free.top += line;
}

void draw_head(Canvas& canvas, Box& free, const Picture& picture, double em) {
    const Font title{em * 1.5, true}, subtitle{em};
    draw_lines(canvas, free, canvas.wrapped(picture.title, title, free.width(), 2), title, kInk);
    draw_lines(canvas, free, canvas.wrapped(picture.subtitle, subtitle, free.width(), 3), subtitle, kFaded);
    free.top += em * 0.3;
    draw_key(canvas, free, picture, em);
    free.top += em * 0.4;
}

// The space for the note is set aside before the plots are drawn, so that nothing shifts with what they leave
// out.
void draw_note(Canvas& canvas, const Box& corner, const Picture& picture, int left_out, double em) {
    const Font font{em * 0.75};
    std::string note = picture.note;
    if (left_out > 0)
        note += (note.empty() ? "" : "; ") + std::to_string(left_out) + " labels found no room";
    double y = corner.top + canvas.ascent(font);
    for (const std::string& line : canvas.wrapped(note, font, corner.width(), 2)) {
        canvas.text({corner.right - canvas.width(line, font), y}, line, font, kFaded);
        y += canvas.line_height(font);
    }
}

int draw(Canvas& canvas, const Picture& picture) {
    const double em = em_of(picture);
    Box free =
        grown({0, 0, static_cast<double>(picture.width_px), static_cast<double>(picture.height_px)}, -em);
    draw_head(canvas, free, picture, em);
    const double note_height = 2 * canvas.line_height({em * 0.75});
    const Box corner{free.left, free.bottom - note_height, free.right, free.bottom};
    free.bottom = corner.top - em * 0.3;

    const int columns = std::min(picture.columns, std::max(1, static_cast<int>(picture.plots.size())));
    const int rows = (static_cast<int>(picture.plots.size()) + columns - 1) / columns;
    const double between = em * 1.2;
    const double width = (free.width() - between * (columns - 1)) / columns;
    const double height = rows == 0 ? 0 : (free.height() - between * (rows - 1)) / rows;
    int left_out = 0;
    for (std::size_t i = 0; i < picture.plots.size(); ++i) {
        const double left =
            free.left + (width + between) * static_cast<double>(static_cast<int>(i) % columns);
        const double top = free.top + (height + between) * static_cast<double>(static_cast<int>(i) / columns);
        // Small plots have small text, as far as it can be read.
        const double small = std::clamp(std::sqrt(std::max(0.0, width * height)) / 38, std::min(9.0, em), em);
        left_out += draw_panel(canvas, picture.plots[i], {left, top, left + width, top + height}, small);
    }
    draw_note(canvas, corner, picture, left_out, em);
    return left_out;
}

SurfaceText text_of(const Picture& picture) {
    return {picture.title, picture.subtitle + (picture.note.empty() ? "" : " (" + picture.note + ")")};
}

} // namespace

std::string picture_svg(const Picture& picture) {
    check(picture);
    return draw_svg(picture.width_px, picture.height_px, text_of(picture),
                    [&](Canvas& canvas) { draw(canvas, picture); });
}

std::string picture_png(const Picture& picture) {
    check(picture);
    return draw_png(picture.width_px, picture.height_px, text_of(picture),
                    [&](Canvas& canvas) { draw(canvas, picture); });
}

int unplaced_labels(const Picture& picture) {
    check(picture);
    int count = 0;
    draw_svg(picture.width_px, picture.height_px, text_of(picture),
             [&](Canvas& canvas) { count = draw(canvas, picture); });
    return count;
}

void write_picture(const std::filesystem::path& path, const Picture& picture) {
    const std::string ending = lower_case(path.extension().string());
    if (ending != ".svg" && ending != ".png")
        throw bad_input("write", path.string(), "a picture ends in .svg or .png");
    write_file(path, ending == ".svg" ? picture_svg(picture) : picture_png(picture));
}

} // namespace metamer
