#include "render/frame.h"

#include <algorithm>

#include "color/colorimetry.h"
#include "render/frame_renderer.h"
#include "render/supersample.h"

namespace metamer {

ColorBuffer color_buffer_of(const Display& display) {
    return display.color_depth_bits == 16 ? ColorBuffer::target_rgb565 : ColorBuffer::target;
}

Framebuffer framebuffer_of(const Display& display) {
    return {display.width_px * display.supersample, display.height_px * display.supersample,
            DepthBuffer::depth16, color_buffer_of(display)};
}

Image render_frame(const Exhibit& exhibit) {
    const int scale = exhibit.display.supersample;
    FrameRenderer renderer(exhibit);
    const Framebuffer target = framebuffer_of(exhibit.display);
    target.bind();
    renderer.draw(target.width_px(), target.height_px(), scale);
    return averaged({target.width_px(), target.height_px(), target.read_rgba()}, scale,
                    exhibit.display.transfer);
}

// Exhibits hold no singular matrix: the loader refuses it.
Matrix3 xyz_from_display_rgb(const Display& display) {
    return inverse(display.matrix ? *display.matrix : rgb_from_xyz(*display.working_space)).value();
}

ColorChunks color_chunks(const Display& display) {
    ColorChunks chunks;
    const WorkingSpace& space = *display.working_space;
    if (!display.matrix && display.transfer == Transfer::srgb && space.name == working_spaces()[0].name) {
        chunks.srgb = true;
        return chunks;
    }
    chunks.gamma = display.transfer == Transfer::srgb ? 1 / 2.2 : 1.0;
    const Matrix3 xyz_from = xyz_from_display_rgb(display);
    std::array<double, 8> xy{};
    const LinearRgb corners[]{{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Chromaticity c = chromaticity(to_xyz(xyz_from, corners[i]));
        xy[2 * i] = c.x;
        xy[2 * i + 1] = c.y;
    }
    if (std::all_of(xy.begin(), xy.end(), [](double v) { return v > 0 && v < 1; }))
        chunks.xy = xy;
    return chunks;
}

std::string encode_frame(const Image& image, const Exhibit& exhibit) {
    return encode_png(
        {image, {{"Software", "Metamer"}, {"Title", exhibit.place}}, color_chunks(exhibit.display)}, false);
}

} // namespace metamer
