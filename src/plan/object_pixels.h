// The pixels that an object may show, as samples: what a plan is tried on.
#pragma once

#include <string>
#include <vector>

#include "methods/shade.h"
#include "plan/exhibit_spectra.h"
#include "plan/half_view.h"
#include "plan/reason.h"

namespace metamer {

/// How an object tells its material to a shader: one key; maps of keys, luminance and normals; a ramp between
/// two materials, mixed linearly; a ramp mixed in code values (method rgb only); a medium of varying
/// thickness before it; a second wall that lights it.
enum class Surface { plain, maps, ramp, ramp_codes, medium, bounce };

/// Of an object when drawn by this method.
Surface surface_of(const Exhibit& exhibit, const ObjectSetting& object, Method method);

/// The wall that an object gets light from; nullptr where there is none.
const ObjectSetting* other_wall(const Exhibit& exhibit, const ObjectSetting& object);

/// A pixel of an object with one of its materials, lit by all of the half's lamps at diffuse 1; behind the
/// object's medium where it is thickest; with the wall that the object gets light from.
Pixel pixel_of(const Exhibit& exhibit, const HalfView& view, const ExhibitSpectra& spectra,
               const ObjectSetting& object, const MaterialSetting& material);

/// What a half's pixels are computed with; `taps`: of an object's plan, read by method `reduced` alone. All
/// three must outlive it.
Sight sight_of(const HalfView& view, const ExhibitSpectra& spectra, const Taps* taps = nullptr);

/// A pixel with names for people: its lamps and material.
struct NamedPixel {
    Pixel pixel;
    PixelName name;
    std::vector<std::size_t> lamps; ///< which of the half's lamps the pixel's are
};

/// Every material that the object may show, under each lamp alone at strength 1, and under all together at
/// their strengths, divided by the sum of these: on a ramp both ends and three mixtures, in a medium at
/// kThicknesses thicknesses, on a wall with all mixtures of direct light and the other wall's.
std::vector<NamedPixel> pixels_of(const Exhibit& exhibit, const HalfView& view, const ExhibitSpectra& spectra,
                                  const ObjectSetting& object);

inline constexpr int kThicknesses = 23; ///< not a multiple of what taps are fitted to

} // namespace metamer
