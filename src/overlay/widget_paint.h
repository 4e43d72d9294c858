// How each kind of widget looks. The picture is the widget's box; `whole` is all of it.
#pragma once

#include "overlay/brush.h"
#include "overlay/widget.h"

namespace metamer {

inline constexpr double kCorner = 1.6; ///< radius of round corners, units

void paint_lamp(Brush& brush, const Widget& widget, const Rect& whole);
void paint_slider(Brush& brush, const Widget& widget, const Rect& whole);
void paint_button(Brush& brush, const Widget& widget, const Rect& whole);
void paint_next(Brush& brush, const Rect& whole);
void paint_close(Brush& brush, const Widget& widget, const Rect& whole);

void paint_half_label(Brush& brush, const Widget& widget, const Rect& whole);
void paint_handle(Brush& brush, const Rect& whole);
void paint_caption(Brush& brush, const Widget& widget, const Rect& whole);
void paint_hint(Brush& brush, const Widget& widget, const Rect& whole);
void paint_notice(Brush& brush, const Widget& widget, const Rect& whole);

void paint_product(Brush& brush, const ProductPanel& product, const Rect& whole);
void paint_expert(Brush& brush, const ExpertPanel& expert, const std::string& title, const Rect& whole);

} // namespace metamer
