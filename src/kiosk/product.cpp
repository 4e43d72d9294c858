#include "kiosk/product.h"

#include <algorithm>
#include <cmath>

#include "color/difference.h"
#include "color/resample.h"
#include "methods/three_numbers.h"

namespace metamer {

namespace {

using Values = std::array<double, kIntervals>;

Bars bars(const Values& values, double greatest) {
    Bars out;
    for (const double value : values)
        out.push_back(static_cast<float>(greatest > 0 ? std::clamp(value / greatest, 0.0, 1.0) : 0));
    return out;
}

double greatest(const Values& values) {
    return *std::ranges::max_element(values);
}

/// The mean of each interval's five samples; `values` on kReferenceGrid.
Values binned(const std::vector<double>& values) {
    constexpr std::size_t kWidth = 5;
    static_assert(kThesisGrid.step_nm == kWidth * kReferenceGrid.step_nm);
    constexpr auto kFirst =
        static_cast<std::size_t>(kThesisGrid.first_nm - kReferenceGrid.first_nm) - kWidth / 2;
    Values out{};
    for (std::size_t i = 0; i < kWidth * kIntervals; ++i)
        out[i / kWidth] += values[kFirst + i] / kWidth;
    return out;
}

/// The light that a pixel's lamps send out together, each with its share of what the eye gets (equation
/// 7.10's I_source over k').
Values light_of(const Pixel& pixel, const GridObserver& observer) {
    const bool full = std::ranges::all_of(pixel.lamps, [](const PixelLamp& lamp) { return lamp.full; });
    Values sum{};
    for (const PixelLamp& lamp : pixel.lamps) {
        const Values own = full ? binned(lamp.full->power) : lamp.row->value;
        const double k = full ? lamp.full->k : grid_k(*lamp.row, observer);
        for (std::size_t i = 0; i < kIntervals && k > 0; ++i)
            sum[i] += lamp.strength / k * own[i];
    }
    return sum;
}

/// The share of light that a pixel sends on: reflectance times transmittance (Beer-Lambert law).
Values share_of(const Pixel& pixel) {
    const Layer& material = pixel.material;
    const auto through = [&](double transmittance) {
        return std::pow(std::max(transmittance, kLeastTransmittance), pixel.thickness);
    };
    if (!material.full || (pixel.medium && !pixel.medium->full)) {
        Values out = material.row->value;
        for (std::size_t i = 0; i < kIntervals && pixel.medium; ++i)
            out[i] *= through(pixel.medium->row->value[i]);
        return out;
    }
    std::vector<double> out = *material.full;
    for (std::size_t i = 0; i < out.size() && pixel.medium; ++i)
        out[i] *= through((*pixel.medium->full)[i]);
    return binned(out);
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

// The booth's cards are made, and have names of their own; glass is what is tapped, not what is behind it.
std::string material_words(const Exhibit& exhibit, const ObjectSetting& object, const std::string& name,
                           const Words& words, const std::string& language) {
    if (exhibit.scene == SceneKind::booth && object.name == "card-a")
        return words.text(language, "booth.card_a");
    if (exhibit.scene == SceneKind::booth && object.name == "card-b")
        return words.text(language, "booth.card_b");
    return words.name_of(language, "material", object.medium ? object.medium->material.name : name);
}

bool has_several_lamps(const HalfView& view) {
    return std::ranges::any_of(view.lamps,
                               [&](const HalfLamp& lamp) { return lamp.key != view.lamps[0].key; });
}

std::string lamp_words(const HalfView& view, const Words& words, const std::string& language) {
    return has_several_lamps(view) ? words.text(language, "panel.all_lamps")
                                   : words.name_of(language, "lamp", view.lamps[0].name);
}

/// As the panel's colors see it: the half's lamps as bright as one in sum.
Pixel even_pixel(const Exhibit& exhibit, const HalfPlan& plan, const ExhibitSpectra& spectra,
                 std::size_t object, const MaterialSetting& material) {
    Pixel pixel = pixel_of(exhibit, plan.view, spectra, exhibit.objects[object], material);
    double strength = 0;
    for (const PixelLamp& lamp : pixel.lamps)
        strength += lamp.strength;
    for (PixelLamp& lamp : pixel.lamps)
        lamp.strength = strength > 0 ? lamp.strength / strength : 0;
    return pixel;
}

struct HalfColor {
    std::array<std::uint8_t, 3> rgb;
    Xyz xyz;
};

HalfColor color_in(const Exhibit& exhibit, const HalfPlan& plan, const ExhibitSpectra& spectra,
                   std::size_t object, const MaterialSetting& material) {
    const Pixel pixel = even_pixel(exhibit, plan, spectra, object, material);
    const ObjectPlan& planned = plan.objects[object];
    const Sight sight = sight_of(plan.view, spectra, &planned.taps);
    const EncodedRgb8 rgb = shade_rgb8<double>(planned.method, pixel, sight);
    return {{rgb.r, rgb.g, rgb.b}, shade_xyz<double>(planned.method, pixel, sight)};
}

/// lamp x material = eye: the names, and the three plots.
void fill_in_plots(const Pixel& pixel, bool several, const GridObserver& observer, const Words& words,
                   const std::string& language, ProductPanel& panel) {
    panel.lamp_name = words.text(language, several ? "panel.lamps" : "panel.lamp");
    panel.material_name = words.text(language, pixel.medium ? "panel.medium" : "panel.material");
    panel.product_name = words.text(language, "panel.product");
    const Values light = light_of(pixel, observer), share = share_of(pixel);
    Values product;
    for (std::size_t i = 0; i < kIntervals; ++i)
        product[i] = light[i] * share[i];
    panel.lamp = bars(light, greatest(light));
    panel.material = bars(share, 1);
    panel.product = bars(product, greatest(light));
}

// Whether most of what a half draws multiplies three numbers.
bool by_numbers(const HalfPlan& plan) {
    const auto products =
        std::count_if(plan.objects.begin(), plan.objects.end(),
                      [](const ObjectPlan& object) { return object.asked && is_product(object.method); });
    return 2 * products > static_cast<long>(plan.objects.size());
}

// What most of a half's objects are drawn by.
Method method_of(const HalfPlan& plan) {
    const auto count = [&](const ObjectPlan& object) {
        return std::ranges::count(plan.objects, object.method, &ObjectPlan::method);
    };
    return std::ranges::max_element(plan.objects, {}, count)->method;
}

double strength_of(const HalfView& view) {
    double sum = 0;
    for (const HalfLamp& lamp : view.lamps)
        sum += lamp.strength;
    return sum;
}

bool same_lamps(const HalfView& a, const HalfView& b) {
    return std::ranges::equal(a.lamps, b.lamps, {}, &HalfLamp::key, &HalfLamp::key);
}

} // namespace

Bars lamp_bars(const LampSetting& lamp, const Atlas& atlas) {
    const Values values = lamp.full_resolution ? binned(resample(lamp.lamp.spectrum, kReferenceGrid))
                                               : emission(atlas, lamp.key).value;
    return bars(values, greatest(values));
}

std::string factor_words(double factor, const Words& words, const std::string& language) {
    return words.number(language, factor, factor < 0.995 ? 2 : factor < 9.95 ? 1 : 0);
}

std::string half_name(const Exhibit& exhibit, const Plan& plan, std::size_t half, HalfName kind,
                      const Words& words, const std::string& language) {
    const HalfPlan& own = plan.halves[half];
    const HalfPlan& other = plan.halves[plan.halves.size() - 1 - half];
    const bool brief = kind == HalfName::brief;
    // What they differ in.
    if (plan.halves.size() > 1 && by_numbers(own) == by_numbers(other)) {
        if (!same_lamps(own.view, other.view)) {
            const std::string name = lamp_words(own.view, words, language);
            return brief ? name : words.text(language, "half.lamp", {{"lamp", name}});
        }
        if (exhibit.compare->left.working_space || exhibit.compare->right.working_space) {
            const WorkingSpace* set =
                half == 0 ? exhibit.compare->left.working_space : exhibit.compare->right.working_space;
            const std::string name((set ? set : exhibit.display.working_space)->name);
            return brief ? name : words.text(language, "half.space", {{"space", name}});
        }
        const double strength = strength_of(own.view), others = strength_of(other.view);
        if (std::abs(strength - others) > 1e-6 * std::max(strength, others))
            return words.text(language, "slider.strength",
                              {{"factor", factor_words(strength, words, language)}});
        if (method_of(own) != method_of(other)) {
            const std::string name(method_name(method_of(own)));
            return brief ? name : words.text(language, "method." + name);
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
    const HalfPlan& first = plan.halves.front();
    ProductPanel panel;
    const std::string material_name =
        material_words(exhibit, exhibit.objects[seen.object], material->material.name, words, language);
    panel.title =
        words.text(language, "panel.title",
                   {{"material", material_name}, {"lamp", lamp_words(first.view, words, language)}});
    fill_in_plots(even_pixel(exhibit, first, spectra, seen.object, *material), has_several_lamps(first.view),
                  spectra.exact(), words, language, panel);
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

bool cards_match(const Exhibit& booth, const Plan& plan, const ExhibitSpectra& spectra, std::size_t half) {
    std::vector<Xyz> cards;
    for (std::size_t i = 0; i < booth.objects.size(); ++i)
        if (booth.objects[i].name == "card-a" || booth.objects[i].name == "card-b")
            cards.push_back(color_in(booth, plan.halves[half], spectra, i, booth.objects[i].material).xyz);
    return cards.size() == 2 && difference_key(delta_e_2000(cards[0], cards[1])) == "difference.same";
}

} // namespace metamer
