// Cairo's objects, owned; and its pictures as bytes.
#pragma once

#include <cairo.h>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace metamer {

struct DestroyCairo {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, DestroyCairo>;
using CairoContext = std::unique_ptr<cairo_t, DestroyCairo>;

/// Throws failure `cannot VERB OBJECT: ` and Cairo's word where the status is no success.
void check_cairo(cairo_status_t status, const char* verb, const std::string& object);

/// An image surface of CAIRO_FORMAT_ARGB32 (premultiplied, as it is) or CAIRO_FORMAT_RGB24 (opaque): R, G, B,
/// A, rows from the top.
std::vector<std::uint8_t> rgba_of(cairo_surface_t* surface);

} // namespace metamer
