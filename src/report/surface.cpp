#include "report/surface.h"

#include <new>
#include <string_view>

#include <cairo-svg.h>

#include "image/cairo.h"
#include "image/png.h"

namespace metamer {

namespace {

void check(cairo_status_t status, const SurfaceText& text) {
    check_cairo(status, "draw", text.title);
}

void draw_on(cairo_surface_t* surface, const SurfaceText& text, const std::function<void(Canvas&)>& draw) {
    const CairoContext context(cairo_create(surface));
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());
    Canvas canvas(context.get());
    draw(canvas);
    check(cairo_status(context.get()), text);
}

// Called through C: nothing may be thrown.
cairo_status_t append(void* out, const unsigned char* bytes, unsigned length) noexcept {
    try {
        static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(bytes), length);
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
}

// XML 1.0 section 2.4.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : drawable(text))
        out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return out;
}

// Cairo 1.16 counts its surfaces over the whole process and writes the count.
void drop_surface_number(std::string& svg) {
    constexpr std::string_view kBefore = "<g id=\"surface";
    const std::size_t at = svg.find(kBefore);
    if (at == std::string::npos)
        return;
    const std::size_t digits = at + kBefore.size();
    svg.erase(digits, svg.find('"', digits) - digits);
}

// SVG 1.1 section 5.4: a title is the first child of what it names.
void add_text(std::string& svg, const SurfaceText& text) {
    const std::size_t root = svg.find("<svg");
    svg.insert(svg.find('>', root) + 1, "\n<title>" + escaped(text.title) + "</title>\n<desc>" +
                                            escaped(text.description) + "</desc>");
    svg.insert(root + 4, " role=\"img\"");
}

} // namespace

std::string draw_svg(int width_px, int height_px, const SurfaceText& text,
                     const std::function<void(Canvas&)>& draw) {
    std::string bytes;
    const CairoSurface surface(cairo_svg_surface_create_for_stream(append, &bytes, width_px, height_px));
    check(cairo_surface_status(surface.get()), text);
    cairo_svg_surface_restrict_to_version(surface.get(), CAIRO_SVG_VERSION_1_1);
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
    draw_on(surface.get(), text, draw);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()), text);
    drop_surface_number(bytes);
    add_text(bytes, text);
    return bytes;
}

std::string draw_png(int width_px, int height_px, const SurfaceText& text,
                     const std::function<void(Canvas&)>& draw) {
    const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px));
    check(cairo_surface_status(surface.get()), text);
    draw_on(surface.get(), text, draw);
    Png png;
    png.image = {width_px, height_px, rgba_of(surface.get())};
    png.color.srgb = true;
    png.text = {{"Title", drawable(text.title)}, {"Description", drawable(text.description)}};
    return encode_png(png, false);
}

} // namespace metamer
