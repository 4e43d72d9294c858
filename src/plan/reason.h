// Why an object is drawn by its method: facts, to be said in any language.
#pragma once

#include <optional>
#include <string>

#include "methods/method.h"

namespace metamer {

/// What tells a pixel from others of its exhibit, by the names of lamps and materials.
struct PixelName {
    std::string lamp; ///< empty: all of the half's lamps together
    std::string material;
    std::string medium;   ///< before the material; empty: none
    double thickness = 0; ///< of the medium

    /// `crayon-red`, `white through glass-blue, thickness 2.5`.
    std::string surface() const;
};
/// `F11 on crayon-red`, `all lamps on white through glass-blue, thickness 2.5`.
std::string in_english(const PixelName& name);

/// What speaks for a method.
enum class Ground {
    asked,     ///< the exhibit says so
    constant,  ///< folded: one color per lamp
    table,     ///< folded: one color per lamp and key of its maps
    product,   ///< three numbers do
    taps,      ///< a few wavelengths do
    thickness, ///< they do, for a medium whose thickness varies
    all,       ///< nothing less than all wavelengths does
};

struct Reason {
    /// The last of the cheaper ways that do not keep the tolerance.
    struct Rejected {
        Method method = Method::rgb;
        int taps = 0;     ///< of method reduced
        double error = 0; ///< CIEDE2000, or more
    };

    Ground ground = Ground::constant;
    double error = 0; ///< CIEDE2000 at most
    int taps = 0;     ///< of taps and thickness
    PixelName worst;  ///< of asked: the pixel of that error
    std::optional<Rejected> rejected;
};

/// One sentence, without a full stop.
std::string in_english(const Reason& reason);

/// An error as people read it: two decimals, three below 0.01; what nobody could see (below 0.001) is 0.001.
struct ToldError {
    double value;
    int decimals;
};
ToldError told_error(double error);
/// In English: `0.12`.
std::string error_text(double error);

} // namespace metamer
