// How far a way to compute is from the reference, pair by pair.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "plan/planner.h"
#include "report/rows.h"

namespace metamer {

/// A way to compute: which method, with what.
struct Way {
    MethodChoice method; ///< none: as planned
    int taps = 0;        ///< of method reduced
    Precision precision = Precision::fp32;
    Levels levels = Levels::unquantized;
};

/// CIEDE2000 of one pixel against the reference.
struct PairDifference {
    double delta_e = 0;
    std::string lamp, material; ///< through a medium, with its name and thickness
};

/// A result that is no number at all counts as this many CIEDE2000.
inline constexpr double kNotANumber = 1000;

/// An exhibit with its spectra in every form that ways take them.
///
/// Pixels are those of plan/object_pixels.h, lamp by lamp: every material that an object may show, through
/// its media at all thicknesses, beside its second wall in all mixtures. The reference is exact_xyz() of the
/// spectra at 1 nm, whatever the way knows. Levels::eight_bit: the atlas's rows are all that is known.
/// Levels::unquantized: `folded`, `reduced` and the planner have the spectra at 1 nm; the loops and the
/// products have rows of 64 doubles, as they are before their levels are chosen (atlas/lamp_fit.h,
/// material_fit.h; for atlases in the thesis's way, the samples); what is planned has the atlas's rows
/// wherever it reads rows. Of a lamp or material that only an atlas file knows, its row is all there is, and
/// the reference of its pairs.
class AccuracyProbe {
public:
    /// `exhibit` is copied; its halves and what it asks of methods are dropped (drawn_by()).
    explicit AccuracyProbe(const Exhibit& exhibit);
    AccuracyProbe(AccuracyProbe&&) noexcept;
    AccuracyProbe& operator=(AccuracyProbe&&) noexcept;
    ~AccuracyProbe();

    /// The plan of the whole frame drawn this way; `fragment_bits` as plan_exhibit() takes them. Throws what
    /// plan_exhibit() throws.
    Plan plan(const Way& way, int fragment_bits) const;

    /// One for each pixel with one lamp, in the order of objects, each pixel once. Throws as plan() does.
    std::vector<PairDifference> differences(const Way& way) const;

    /// The mantissa bits that stand for a precision: 10 or 23.
    static int bits_of(Precision precision);

private:
    struct Stock;

    const Stock& stock(Levels levels) const;

    std::unique_ptr<Stock> full_, rows_;
    std::vector<std::vector<Xyz>> exact_; ///< [object][pixel]
};

} // namespace metamer
