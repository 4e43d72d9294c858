#include "kiosk/overlay_textures.h"

#include <GLES2/gl2.h>
#include <algorithm>
#include <cstring>

namespace metamer {

namespace {

/// The picture in the lower left corner of power-of-two sides; its rows stay from the top. Filtered as scenes
/// are: drivers compile what is laid once, not once for each filter.
Texture upload(const Picture& picture) {
    const int width = texture_side(picture.width_px), height = texture_side(picture.height_px);
    const auto row = static_cast<std::size_t>(picture.width_px) * 4;
    std::vector<std::uint8_t> padded(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height_px); ++y)
        std::memcpy(&padded[y * static_cast<std::size_t>(width) * 4], &picture.rgba[y * row], row);
    return {width, height, padded, {Filter::linear, Wrap::clamp, false}};
}

int greatest_side() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    return std::min<GLint>(most, kMostTexturePx);
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

OverlayTextures::Painted OverlayTextures::painted(const Widget& widget, double unit_px) {
    const int side = std::max(widget.box.width, widget.box.height), most = greatest_side();
    const double scale = std::min(1.0, static_cast<double>(most) / side);
    Widget small = widget;
    small.box.width = std::max(1, static_cast<int>(scale * widget.box.width));
    small.box.height = std::max(1, static_cast<int>(scale * widget.box.height));
    Texture texture = upload(paint(small, scale * unit_px));
    const float width = static_cast<float>(small.box.width) / static_cast<float>(texture.width_px()),
                height = static_cast<float>(small.box.height) / static_cast<float>(texture.height_px());
    // Rows from the top: the patch runs downwards.
    return {widget, unit_px, std::move(texture), {0, height, width, -height}};
}

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
        painted_.insert_or_assign({widget.part, widget.index}, painted(widget, unit_px));
        ++paintings_;
    }
}

void OverlayTextures::lay(Compositor& compositor, std::span<const Widget> widgets) const {
    for (const Widget& widget : widgets) {
        const Painted& shown = painted_.at({widget.part, widget.index});
        shown.texture.bind(kPictureUnit);
        compositor.lay(widget.box, shown.patch);
    }
}

} // namespace metamer
