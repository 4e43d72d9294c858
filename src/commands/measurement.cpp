#include "commands/measurement.h"

#include "color/colorimetry.h"
#include "color/difference.h"
#include "methods/shade.h"
#include "plan/object_pixels.h"
#include "render/frame.h"

namespace metamer {

namespace {

/// A patch of this size is read in its middle.
constexpr int kPatchPx = 16;

EncodedRgb8 middle(const Image& image) {
    const auto at = static_cast<std::size_t>(4 * (image.height / 2 * image.width + image.width / 2));
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
}

} // namespace

Exhibit pair_exhibit(const Lamp& lamp, const Material& material, const Display& display, Method method) {
    Exhibit exhibit;
    exhibit.place = lamp.name + " on " + material.name;
    exhibit.display = display;
    exhibit.display.width_px = exhibit.display.height_px = kPatchPx;
    exhibit.display.supersample = 1;
    exhibit.scene = SceneKind::patches;
    exhibit.accuracy.method = method;
    exhibit.atlas = empty_atlas();
    LampSetting& lamp_setting = exhibit.lamps.emplace_back();
    lamp_setting.lamp = lamp;
    lamp_setting.key = add_lamp(exhibit.atlas, lamp);
    ObjectSetting& object = exhibit.objects.emplace_back();
    object.name = "patch-1";
    object.material.material = material;
    object.material.key = add_material(exhibit.atlas, material, {&lamp, 1});
    exhibit.materials.emplace(object.material.key, material);
    return exhibit;
}

Measurement measure(const Lamp& lamp, const Material& material, const Display& display) {
    Measurement out{lamp.name, material.name, reference_xyz(lamp.spectrum, material.spectrum), {}};
    for (const MethodInfo& info : kMethods) {
        const Exhibit exhibit = pair_exhibit(lamp, material, display, info.method);
        const ExhibitSpectra spectra(exhibit);
        const HalfView view = half_views(exhibit).front();
        const ObjectSetting& object = exhibit.objects.front();
        const Pixel pixel = pixel_of(exhibit, view, spectra, object, object.material);
        const Sight sight = sight_of(view, spectra);
        const Xyz xyz = shade_xyz<double>(info.method, pixel, sight);
        out.methods.push_back({info.method, xyz, delta_e_2000(xyz, out.reference),
                               shade_rgb8<float>(info.method, pixel, sight), middle(render_frame(exhibit))});
    }
    return out;
}

} // namespace metamer
