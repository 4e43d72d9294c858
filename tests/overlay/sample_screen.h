// A whole screen of widgets with the words of a language: for looking at, and for tests of what fits.
#pragma once

#include <string>
#include <vector>

#include "overlay/layout.h"
#include "overlay/words.h"

namespace metamer {

struct Sample {
    ScreenSize screen;
    std::string language = "en";
    Contents contents; ///< languages and right_to_left are filled in
    double split = 0.5;
    int chosen = 4;                  ///< the chosen lamp
    std::string method = "folded";   ///< of the right half, that the expert's panel tells of
    std::string ground = "constant"; ///< that it gives for it: the words `reason.GROUND`
    std::string difference = "difference.other";
    bool glass = false; ///< the panel is of glass under several lamps
};

/// The shelf's lamps, in the order that samples take them.
const std::vector<std::string>& sample_lamps();

/// Shapes that stand for lamps and materials: a lamp's index gives bulbs, tubes with lines, LEDs.
Bars sample_bars(int kind);

struct SampleScreen {
    Layout layout;
    std::vector<Widget> widgets; ///< in the order of painting
};
SampleScreen sample_screen(const Words& words, const Sample& sample);

} // namespace metamer
