#include "commands/measurement.h"

#include "color/colorimetry.h"
#include "color/difference.h"
#include "methods/pair.h"
#include "render/frame.h"
#include "render/half_view.h"

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
    exhibit.method = method;
    exhibit.atlas = empty_atlas();
    LampSetting& lamp_setting = exhibit.lamps.emplace_back();
    lamp_setting.lamp = lamp;
    lamp_setting.key = add_lamp(exhibit.atlas, lamp);
    ObjectSetting& object = exhibit.objects.emplace_back();
    object.name = "patch-1";
    object.material = {material, add_material(exhibit.atlas, material)};
    return exhibit;
}

Measurement measure(const Lamp& lamp, const Material& material, const Display& display) {
    Measurement out{lamp.name, material.name, reference_xyz(lamp.spectrum, material.spectrum), {}};
    for (const MethodInfo& info : kMethods) {
        const Exhibit exhibit = pair_exhibit(lamp, material, display, info.method);
        const HalfView view = half_views(exhibit, build_scene(exhibit)).front();
        const Emission& emitted = view.lamps.front().emission;
        const Reflectance reflected = reflectance(exhibit.atlas, exhibit.objects.front().material.key);
        const GridObserver seen_by = observer(exhibit.atlas);
        const Xyz xyz = pair_xyz(info.method, emitted, reflected, seen_by, view.output);
        out.methods.push_back({info.method, xyz, delta_e_2000(xyz, out.reference),
                               pair_rgb8<float>(info.method, emitted, 1, reflected, seen_by, view.output),
                               middle(render_frame(exhibit))});
    }
    return out;
}

} // namespace metamer
