#include "overlay/painter.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "overlay/widget_paint.h"

#ifdef __SANITIZE_ADDRESS__
// Fontconfig keeps its pointers as offsets, where LeakSanitizer does not find them. Weak: report/surface.cpp,
// where it is linked too, says the same.
extern "C" [[gnu::weak]] const char* __lsan_default_suppressions() {
    return "leak:libfontconfig";
}
extern "C" [[gnu::weak]] const char* __lsan_default_options() {
    return "print_suppressions=0";
}
#endif

namespace metamer {

namespace {

struct FreeSurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct FreeContext {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, FreeSurface>;
using Context = std::unique_ptr<cairo_t, FreeContext>;

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw failure("paint", "a widget", cairo_status_to_string(status));
}

void paint_part(Brush& brush, const Widget& widget, const Rect& whole) {
    switch (widget.part) {
    case Part::left_label:
    case Part::right_label:
        return paint_half_label(brush, widget, whole);
    case Part::split:
        return paint_handle(brush, whole);
    case Part::lamp:
    case Part::lamp_right:
        return paint_lamp(brush, widget, whole);
    case Part::strength:
        return paint_slider(brush, widget, whole);
    case Part::mode:
    case Part::language:
    case Part::expert:
        return paint_button(brush, widget, whole);
    case Part::panel:
        return paint_product(brush, widget.product.value_or(ProductPanel{}), whole);
    case Part::close:
        return paint_close(brush, widget, whole);
    case Part::expert_panel:
        return paint_expert(brush, widget.expert.value_or(ExpertPanel{}), widget.text, whole);
    case Part::caption:
        return paint_caption(brush, widget, whole);
    case Part::hint:
        return paint_hint(brush, widget, whole);
    case Part::notice:
        return paint_notice(brush, widget, whole);
    }
}

/// Cairo's native 0xAARRGGBB as bytes R, G, B, A.
std::vector<std::uint8_t> rgba_of(cairo_surface_t* surface, int width_px, int height_px) {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) * 4);
    cairo_surface_flush(surface);
    const unsigned char* row = cairo_image_surface_get_data(surface);
    for (int y = 0; y < height_px; ++y, row += cairo_image_surface_get_stride(surface)) {
        const auto* pixels = reinterpret_cast<const std::uint32_t*>(row);
        for (int x = 0; x < width_px; ++x)
            for (const int shift : {16, 8, 0, 24})
                rgba.push_back(static_cast<std::uint8_t>(pixels[x] >> shift & 255u));
    }
    return rgba;
}

} // namespace

Picture paint(const Widget& widget, double unit_px) {
    Picture picture{std::max(widget.box.width, 0), std::max(widget.box.height, 0), {}, false};
    if (picture.width_px == 0 || picture.height_px == 0)
        return picture;
    const Surface surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, picture.width_px, picture.height_px));
    check(cairo_surface_status(surface.get()));
    const Context context(cairo_create(surface.get()));
    Brush brush(context.get(), unit_px, widget.right_to_left);
    const Rect whole{0, 0, static_cast<double>(picture.width_px), static_cast<double>(picture.height_px)};
    paint_part(brush, widget, whole);
    if (widget.focused)
        brush.focus(whole, kCorner * unit_px);
    check(cairo_status(context.get()));
    picture.rgba = rgba_of(surface.get(), picture.width_px, picture.height_px);
    picture.text_cut = brush.text_cut();
    return picture;
}

bool text_fits(const Widget& widget, double unit_px) {
    return !paint(widget, unit_px).text_cut;
}

} // namespace metamer
