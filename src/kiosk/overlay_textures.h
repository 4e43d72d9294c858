// Widgets on the GPU: each is painted again only when it looks different. What is larger than a texture may
// be is painted smaller, and stretched.
#pragma once

#include <map>
#include <span>
#include <utility>

#include "gles/texture.h"
#include "kiosk/compositor.h"
#include "overlay/painter.h"

namespace metamer {

class OverlayTextures {
public:
    /// Paints what changed since the last call and forgets what is no longer there.
    void update(std::span<const Widget> widgets, double unit_px);

    /// Lays all of them, in their order.
    void lay(Compositor& compositor, std::span<const Widget> widgets) const;

    long paintings() const { return paintings_; } ///< so far: for tests

private:
    struct Painted {
        Widget widget;
        double unit_px = 0;
        Texture texture;
        Patch patch; ///< of the texture that is painted
    };
    static Painted painted(const Widget& widget, double unit_px);

    std::map<std::pair<Part, int>, Painted> painted_;
    long paintings_ = 0;
};

} // namespace metamer
