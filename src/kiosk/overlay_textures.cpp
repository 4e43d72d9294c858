#include "kiosk/overlay_textures.h"

#include <algorithm>
#include <cstring>

namespace metamer {

namespace {

/// The picture in the lower left corner of power-of-two sides; its rows stay from the top.
Texture upload(const Picture& picture) {
    const int width = texture_side(picture.width_px), height = texture_side(picture.height_px);
    const auto row = static_cast<std::size_t>(picture.width_px) * 4;
    std::vector<std::uint8_t> padded(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height_px); ++y)
        std::memcpy(&padded[y * static_cast<std::size_t>(width) * 4], &picture.rgba[y * row], row);
    return {width, height, padded, {Filter::nearest, Wrap::clamp, false}};
}

bool looks_the_same(const Widget& a, const Widget& b) {
    if (a.box.width != b.box.width || a.box.height != b.box.height)
        return false;
    // Places aside; the copy is only made where a widget moved.
    if (a.box == b.box)
        return a == b;
    Widget moved = a;
    moved.box = b.box;
    return moved == b;
}

} // namespace

void OverlayTextures::update(std::span<const Widget> widgets, double unit_px) {
    std::erase_if(painted_, [&](const auto& entry) {
        return std::none_of(widgets.begin(), widgets.end(), [&](const Widget& widget) {
            return std::pair(widget.part, widget.index) == entry.first;
        });
    });
    for (const Widget& widget : widgets) {
        const auto found = painted_.find({widget.part, widget.index});
        if (found != painted_.end() && found->second.unit_px == unit_px &&
            looks_the_same(found->second.widget, widget))
            continue;
        painted_.insert_or_assign({widget.part, widget.index},
                                  Painted{widget, unit_px, upload(paint(widget, unit_px))});
        ++paintings_;
    }
}

void OverlayTextures::lay(Compositor& compositor, std::span<const Widget> widgets) const {
    for (const Widget& widget : widgets) {
        const Texture& texture = painted_.at({widget.part, widget.index}).texture;
        texture.bind(kPictureUnit);
        // Rows from the top: the patch runs downwards.
        const float height = static_cast<float>(widget.box.height) / static_cast<float>(texture.height_px());
        compositor.lay(widget.box,
                       {0, height,
                        static_cast<float>(widget.box.width) / static_cast<float>(texture.width_px()),
                        -height});
    }
}

} // namespace metamer
