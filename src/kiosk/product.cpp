#include "kiosk/product.h"

#include <algorithm>

#include "color/difference.h"

namespace metamer {

namespace {

Bars bars(const std::array<double, kIntervals>& values, double greatest) {
    Bars out;
    for (const double value : values)
        out.push_back(static_cast<float>(greatest > 0 ? std::clamp(value / greatest, 0.0, 1.0) : 0));
    return out;
}

std::optional<MaterialSetting> material_of(const Exhibit& exhibit, const ObjectSetting& object,
                                           const std::string& name) {
    if (object.material.material.name == name)
        return object.material;
    const int key = find_material_key(exhibit.atlas, name);
    if (key == 0)
        return std::nullopt;
    MaterialSetting setting;
    setting.key = key;
    setting.material.name = exhibit.atlas.materials[static_cast<std::size_t>(key)].name;
    setting.full_resolution = exhibit.materials.contains(key);
    return setting;
}

// The booth's cards are made, and have names of their own.
std::string material_words(const Exhibit& exhibit, const ObjectSetting& object, const std::string& name,
                           const Words& words, const std::string& language) {
    if (exhibit.scene == SceneKind::booth && object.name == "card-a")
        return words.text(language, "booth.card_a");
    if (exhibit.scene == SceneKind::booth && object.name == "card-b")
        return words.text(language, "booth.card_b");
    return words.name_of(language, "material", name);
}

struct HalfColor {
    std::array<std::uint8_t, 3> rgb;
    Xyz xyz;
};

HalfColor color_in(const Exhibit& exhibit, const HalfPlan& plan, const ExhibitSpectra& spectra,
                   std::size_t object, const MaterialSetting& material) {
    Pixel pixel = pixel_of(exhibit, plan.view, spectra, exhibit.objects[object], material);
    double strength = 0;
    for (const PixelLamp& lamp : pixel.lamps)
        strength += lamp.strength;
    for (PixelLamp& lamp : pixel.lamps)
        lamp.strength = strength > 0 ? lamp.strength / strength : 0;
    const ObjectPlan& planned = plan.objects[object];
    const Sight sight = sight_of(plan.view, spectra, &planned.taps);
    const EncodedRgb8 rgb = shade_rgb8<double>(planned.method, pixel, sight);
    return {{rgb.r, rgb.g, rgb.b}, shade_xyz<double>(planned.method, pixel, sight)};
}

// Whether most of what a half draws multiplies three numbers.
bool by_numbers(const HalfPlan& plan) {
    const auto products =
        std::count_if(plan.objects.begin(), plan.objects.end(),
                      [](const ObjectPlan& object) { return object.asked && is_product(object.method); });
    return 2 * products > static_cast<long>(plan.objects.size());
}

} // namespace

Bars lamp_bars(const Atlas& atlas, int key) {
    const Emission row = emission(atlas, key);
    return bars(row.value, *std::max_element(row.value.begin(), row.value.end()));
}

std::string half_name(const Exhibit& exhibit, const Plan& plan, std::size_t half, HalfName kind,
                      const Words& words, const std::string& language) {
    const HalfPlan& own = plan.halves[half];
    const HalfPlan& other = plan.halves[plan.halves.size() - 1 - half];
    const bool brief = kind == HalfName::brief;
    const auto lamp = [](const HalfPlan& p) { return p.view.lamps[p.view.dominant].name; };
    if (plan.halves.size() > 1 && by_numbers(own) == by_numbers(other)) {
        if (lamp(own) != lamp(other)) {
            const std::string name = words.name_of(language, "lamp", lamp(own));
            return brief ? name : words.text(language, "half.lamp", {{"lamp", name}});
        }
        if (exhibit.compare->left.working_space || exhibit.compare->right.working_space) {
            const WorkingSpace* set =
                half == 0 ? exhibit.compare->left.working_space : exhibit.compare->right.working_space;
            const std::string name((set ? set : exhibit.display.working_space)->name);
            return brief ? name : words.text(language, "half.space", {{"space", name}});
        }
    }
    const std::string how = by_numbers(own) ? "numbers" : "wavelengths";
    return words.text(language, (brief ? "panel." : "half.") + how);
}

std::optional<ProductPanel> product_panel(const Exhibit& exhibit, const Plan& plan,
                                          const ExhibitSpectra& spectra, const Seen& seen, const Words& words,
                                          const std::string& language) {
    if (seen.object >= exhibit.objects.size())
        return std::nullopt;
    const auto material = material_of(exhibit, exhibit.objects[seen.object], seen.material);
    if (!material)
        return std::nullopt;
    const HalfView& view = plan.halves.front().view;
    const HalfLamp& lamp = view.lamps[view.dominant];
    ProductPanel panel;
    const std::string lamp_name = words.name_of(language, "lamp", lamp.name),
                      material_name = material_words(exhibit, exhibit.objects[seen.object],
                                                     material->material.name, words, language);
    panel.title = words.text(language, "panel.title", {{"material", material_name}, {"lamp", lamp_name}});
    panel.lamp_name = words.text(language, "panel.lamp");
    panel.material_name = words.text(language, "panel.material");
    panel.product_name = words.text(language, "panel.product");
    const double peak = *std::max_element(lamp.emission.value.begin(), lamp.emission.value.end());
    const Reflectance& row = *spectra.material(material->key).row;
    std::array<double, kIntervals> product;
    for (std::size_t i = 0; i < kIntervals; ++i)
        product[i] = lamp.emission.value[i] * row.value[i];
    panel.lamp = bars(lamp.emission.value, peak);
    panel.material = bars(row.value, 1);
    panel.product = bars(product, peak);
    const HalfColor left = color_in(exhibit, plan.halves.front(), spectra, seen.object, *material),
                    right = color_in(exhibit, plan.halves.back(), spectra, seen.object, *material);
    panel.left = left.rgb;
    panel.right = right.rgb;
    panel.left_name = half_name(exhibit, plan, 0, HalfName::brief, words, language);
    panel.right_name = half_name(exhibit, plan, plan.halves.size() - 1, HalfName::brief, words, language);
    const double difference = delta_e_2000(left.xyz, right.xyz);
    panel.number =
        words.text(language, "difference.number", {{"number", words.number(language, difference, 1)}});
    panel.difference = words.text(language, difference_key(difference));
    return panel;
}

} // namespace metamer
