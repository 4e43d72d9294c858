#include "report/surface.h"

#include <cstdint>
#include <memory>
#include <new>
#include <string_view>

#include <cairo-svg.h>

#include "base/error.h"
#include "image/png.h"

#ifdef __SANITIZE_ADDRESS__
// Fontconfig keeps its pointers as offsets, where LeakSanitizer does not find them.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig";
}
extern "C" const char* __lsan_default_options() {
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

void check(cairo_status_t status, const SurfaceText& text) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw failure("draw", text.title, cairo_status_to_string(status));
}

void draw_on(cairo_surface_t* surface, const SurfaceText& text, const std::function<void(Canvas&)>& draw) {
    const std::unique_ptr<cairo_t, FreeContext> context(cairo_create(surface));
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
    const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, width_px, height_px));
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
    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px));
    check(cairo_surface_status(surface.get()), text);
    draw_on(surface.get(), text, draw);
    cairo_surface_flush(surface.get());
    Png png;
    png.image = {width_px, height_px, {}};
    png.image.rgba.reserve(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) * 4);
    const auto* row = cairo_image_surface_get_data(surface.get());
    const int stride = cairo_image_surface_get_stride(surface.get());
    for (int y = 0; y < height_px; ++y, row += stride) {
        // Cairo keeps a pixel as a native 32-bit number 0xXXRRGGBB.
        const auto* pixels = reinterpret_cast<const std::uint32_t*>(row);
        for (int x = 0; x < width_px; ++x)
            for (const std::uint32_t channel : {pixels[x] >> 16, pixels[x] >> 8, pixels[x], 255u})
                png.image.rgba.push_back(static_cast<std::uint8_t>(channel & 255u));
    }
    png.color.srgb = true;
    png.text = {{"Title", drawable(text.title)}, {"Description", drawable(text.description)}};
    return encode_png(png, false);
}

} // namespace metamer
