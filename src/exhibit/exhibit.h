// An exhibit: what an INI file describes, as plain data with every name resolved. No GL here.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "atlas/atlas.h"
#include "color/adaptation.h"
#include "color/gamut.h"
#include "color/matrix3.h"
#include "color/transfer.h"
#include "color/working_space.h"
#include "exhibit/kiosk_setting.h"
#include "exhibit/lamp_setting.h"
#include "image/png.h"
#include "methods/method.h"

namespace metamer {

inline constexpr int kMostLamps = 8;   ///< lamps a frame may have
inline constexpr int kMostShadows = 4; ///< of them may cast shadows (varyings, DESIGN.md section 5)

/// [display]
struct Display {
    int width_px = 1280;
    int height_px = 720;
    const WorkingSpace* working_space = &working_spaces()[0];
    /// Own linear RGB of XYZ instead of the working space's; a half's working space beats it.
    std::optional<Matrix3> matrix;
    Transfer transfer = Transfer::srgb;
    Adaptation adaptation = Adaptation::none;
    int supersample = 1; ///< each pixel from this many squared: 1, 2
    Gamut gamut = Gamut::clip;
    int color_depth_bits = 24; ///< of the framebuffer: 24, or 16 (RGB565)
    bool dither = false;       ///< ordered dithering to that depth
};

/// [accuracy]
struct Accuracy {
    MethodChoice method;    ///< where neither object nor half says another
    double tolerance = 0.5; ///< CIEDE2000 that the planner keeps
    int taps = 8;           ///< wavelengths where a method `reduced` was asked for; the planner finds its own
};

/// A material in use.
struct MaterialSetting {
    Material material;           ///< its spectrum; one of the atlas file is known by its row only
    bool full_resolution = true; ///< as a lamp's
    int key = 0;                 ///< its row in Exhibit::atlas
};

/// An object of the scene with everything that [object.NAME] may change; defaults come from the scene's kind.
struct ObjectSetting {
    std::string name;
    MaterialSetting material;
    std::optional<MethodChoice> method; ///< its own choice beats the half's and [accuracy]'s
    /// Ramps: the material at the far end. Their method says what is mixed: `rgb` code values, as a paint
    /// program does, `tristimulus` XYZ, all others reflectances.
    std::optional<MaterialSetting> material_end;
    /// Glass or liquid: its internal transmittance at thickness 1. The material is what is seen through it.
    std::optional<MaterialSetting> medium;
    double thickness = 1;               ///< of the medium where it is thickest
    std::optional<Image> key_map;       ///< R of a pixel = key of its material; power of two, at most 2048
    std::optional<Image> luminance_map; ///< R of a pixel / 255 scales the reflectance
    std::optional<Image> bump_map;      ///< R = height 0 .. 1
    double bump = 0;                    ///< height of the map's white over its black, in map widths; 0: flat
    double specular = 0;                ///< share of the lamp's light mirrored unfiltered, 0 .. 1
    double shininess = 32;              ///< Blinn-Phong exponent, 1 .. 1000
};

enum class SceneKind { loaf, crayons, still_life, ramp, patches, media, corner, booth };

/// What one half overrides; what it does not override it shares.
struct Half {
    std::optional<MethodChoice> method;
    std::optional<LampSetting> lamp; ///< spectrum for every lamp of the half (only lamp and key count)
    const WorkingSpace* working_space = nullptr; ///< nullptr: the display's
    std::optional<double> strength;              ///< for every lamp of the half
};

/// [compare]
struct Compare {
    double split = 0.5;          ///< where the right half begins, as a share of the width
    std::optional<int> split_px; ///< or as a column, if written `640px`
    int line_px = 0;             ///< width of a gray line drawn over the split
    Half left, right;
};

struct Exhibit {
    std::string place; ///< the INI file, for messages
    Display display;
    Accuracy accuracy;
    SceneKind scene = SceneKind::loaf;
    std::vector<ObjectSetting> objects;
    std::vector<LampSetting> lamps;
    std::optional<Compare> compare;
    KioskSetting kiosk;
    Atlas atlas; ///< every lamp and material in use; the file's own rows where [atlas] file names one
    std::map<int, Material> materials; ///< by key: those whose spectrum is at hand at full resolution
};

} // namespace metamer
