#include "overlay/painter.h"

#include <algorithm>
#include <cmath>

#include "image/cairo.h"
#include "overlay/widget_paint.h"

namespace metamer {

namespace {

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
    case Part::next:
        return paint_next(brush, whole);
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

} // namespace

Picture paint(const Widget& widget, double unit_px) {
    Picture picture{std::max(widget.box.width, 0), std::max(widget.box.height, 0), {}, false};
    if (picture.width_px == 0 || picture.height_px == 0)
        return picture;
    const CairoSurface surface(
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, picture.width_px, picture.height_px));
    check_cairo(cairo_surface_status(surface.get()), "paint", "a widget");
    const CairoContext context(cairo_create(surface.get()));
    Brush brush(context.get(), unit_px, widget.right_to_left);
    const Rect whole{0, 0, static_cast<double>(picture.width_px), static_cast<double>(picture.height_px)};
    paint_part(brush, widget, whole);
    if (widget.focused)
        brush.focus(whole, kCorner * unit_px);
    check_cairo(cairo_status(context.get()), "paint", "a widget");
    picture.rgba = rgba_of(surface.get());
    picture.text_cut = brush.text_cut();
    return picture;
}

} // namespace metamer
