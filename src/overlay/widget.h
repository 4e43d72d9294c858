// What stands over the scene: plain data that says how it looks, so that it is painted again only when that
// changes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "overlay/box.h"

namespace metamer {

enum class Part {
    left_label, ///< what the left half is
    right_label,
    split,        ///< the handle on the split
    lamp,         ///< a tile of the shelf; index: of KioskSetting::lamps
    lamp_right,   ///< mode booth: the tile for the right side
    strength,     ///< slider
    mode,         ///< button: methods <-> booth
    language,     ///< button of a language; index: of Words::languages()
    expert,       ///< button
    panel,        ///< lamp x material = eye, of one object
    next,         ///< the panel of the next object
    close,        ///< closes the panel
    expert_panel, ///< method, space, N, tolerance, reason, frame time
    caption,      ///< the tour's words
    hint,         ///< "touch something"
    notice,       ///< for the technician: an error, in a corner
};

/// A spectrum to be painted in its own colors: values 0 .. 1 on the 5 nm grid (385 + 5 i nm, kIntervals).
using Bars = std::vector<float>;

/// The three plots and two colors of Part::panel.
struct ProductPanel {
    std::string title;                                  ///< the object's material
    std::string lamp_name, material_name, product_name; ///< over the plots
    Bars lamp, material, product;
    std::array<std::uint8_t, 3> left{}, right{}; ///< sRGB codes of the two resulting colors
    std::string left_name, right_name;
    std::string difference; ///< `clearly another color`
    std::string number;     ///< `ΔE 12.3`
    bool operator==(const ProductPanel&) const = default;
};

/// Rows of Part::expert_panel; its title is the widget's text.
struct ExpertPanel {
    std::vector<std::array<std::string, 2>> rows; ///< name, value
    bool operator==(const ExpertPanel&) const = default;
};

struct Widget {
    Part part{};
    int index = 0;
    PxBox box;
    std::string text;      ///< as it is read, or said by a screen reader
    bool on = false;       ///< chosen, pressed
    bool focused = false;  ///< by the keyboard
    double value = 0;      ///< sliders: 0 .. 1
    bool touchable = true; ///< false: touches go through to the scene
    Bars bars;             ///< lamp tiles
    std::optional<ProductPanel> product;
    std::optional<ExpertPanel> expert;
    bool right_to_left = false;

    bool operator==(const Widget&) const = default;
};

} // namespace metamer
