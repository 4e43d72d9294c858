#include "image/cairo.h"

#include "base/error.h"

#ifdef __SANITIZE_ADDRESS__
// Fontconfig, which Cairo finds its fonts with, keeps its pointers as offsets, where LeakSanitizer does not
// find them.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig";
}
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";
}
#endif

namespace metamer {

void check_cairo(cairo_status_t status, const char* verb, const std::string& object) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw failure(verb, object, cairo_status_to_string(status));
}

std::vector<std::uint8_t> rgba_of(cairo_surface_t* surface) {
    const int width = cairo_image_surface_get_width(surface),
              height = cairo_image_surface_get_height(surface);
    const std::uint32_t opaque =
        cairo_image_surface_get_format(surface) == CAIRO_FORMAT_RGB24 ? 0xFF000000u : 0;
    std::vector<std::uint8_t> rgba;
    rgba.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    cairo_surface_flush(surface);
    const unsigned char* row = cairo_image_surface_get_data(surface);
    for (int y = 0; y < height; ++y, row += cairo_image_surface_get_stride(surface)) {
        // A pixel is a native 32-bit number 0xAARRGGBB.
        const auto* pixels = reinterpret_cast<const std::uint32_t*>(row);
        for (int x = 0; x < width; ++x)
            for (const int shift : {16, 8, 0, 24})
                rgba.push_back(static_cast<std::uint8_t>((pixels[x] | opaque) >> shift & 255u));
    }
    return rgba;
}

} // namespace metamer
