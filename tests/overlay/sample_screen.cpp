#include "overlay/sample_screen.h"

#include <algorithm>
#include <cmath>

#include "color/grid.h"

namespace metamer {

namespace {

double bump(double nm, double center, double width) {
    return std::exp(-std::pow((nm - center) / width, 2));
}

double sample_power(int kind, double nm) {
    switch (kind % 4) {
    case 0:
        return 0.75 + 0.25 * std::sin(nm / 40);
    case 1:
        return std::pow((nm - 300) / 400, 2);
    case 2:
        return bump(nm, 450, 12) * 0.9 + bump(nm, 590, 60);
    default:
        return bump(nm, 435, 4) * 0.6 + bump(nm, 545, 5) + bump(nm, 612, 5) * 0.9 + 0.08;
    }
}

class Builder {
public:
    Builder(const Words& words, const Sample& sample) : words_(words), sample_(sample) {
        Contents contents = sample.contents;
        contents.languages = static_cast<int>(words.languages().size());
        contents.right_to_left = words.language(sample.language).right_to_left;
        right_to_left_ = contents.right_to_left;
        screen_.layout = lay_out(sample.screen, contents);
    }

    SampleScreen build() {
        add_halves();
        add_shelf(Part::lamp, screen_.layout.lamps, sample_.chosen);
        add_shelf(Part::lamp_right, screen_.layout.lamps_right, sample_.chosen + 3);
        add_bar();
        add_panels();
        add(Part::caption, screen_.layout.caption, said("booth.match", {{"lamp", lamp(sample_.chosen)}}));
        add(Part::hint, screen_.layout.hint, said(sample_.contents.booth ? "hint.booth" : "hint.start"));
        add(Part::notice, screen_.layout.notice,
            said("notice.refused",
                 {{"error", "museum-kiosk.ini:37: lamps = E, D65, A28…: NIST-LPZ: the library "
                            "has no such lamp; did you mean \"NIST-LPS\"?"}}));
        return std::move(screen_);
    }

private:
    std::string said(std::string_view key, const std::map<std::string, std::string>& values = {}) const {
        return words_.text(sample_.language, key, values);
    }
    std::string lamp(int index) const {
        const auto& lamps = sample_lamps();
        return words_.name_of(sample_.language, "lamp",
                              lamps[static_cast<std::size_t>(index) % lamps.size()]);
    }

    Widget& add(Part part, const PxBox& box, const std::string& text) {
        Widget widget;
        widget.part = part;
        widget.box = box;
        widget.text = text;
        widget.right_to_left = right_to_left_;
        screen_.widgets.push_back(widget);
        return screen_.widgets.back();
    }

    void add_halves() {
        const Layout& layout = screen_.layout;
        const bool booth = sample_.contents.booth;
        add(Part::left_label, layout.left_label,
            booth ? said("booth.match", {{"lamp", lamp(sample_.chosen)}}) : said("half.numbers"));
        add(Part::right_label, layout.right_label,
            booth ? said("booth.part", {{"lamp", lamp(sample_.chosen + 3)}}) : said("half.wavelengths"));
        add(Part::split, split_handle(layout, sample_.split), said("split.handle"));
    }

    void add_shelf(Part part, const std::vector<PxBox>& boxes, int chosen) {
        for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
            Widget& tile = add(part, boxes[static_cast<std::size_t>(i)], lamp(i));
            tile.index = i;
            tile.bars = sample_bars(i);
            tile.on = i == chosen % static_cast<int>(boxes.size());
        }
    }

    void add_bar() {
        const Layout& layout = screen_.layout;
        Widget& slider = add(Part::strength, layout.strength,
                             said("slider.strength", {{"factor", words_.number(sample_.language, 1.25, 2)}}));
        slider.value = 0.62;
        add(Part::mode, layout.mode, said(sample_.contents.booth ? "button.methods" : "button.booth"));
        add(Part::expert, layout.expert, said("button.expert")).on = sample_.contents.expert;
        for (std::size_t i = 0; i < layout.languages.size(); ++i) {
            const Language& language = words_.languages()[i];
            Widget& button = add(Part::language, layout.languages[i], language.name);
            button.index = static_cast<int>(i);
            button.on = language.code == sample_.language;
        }
    }

    void add_panels() {
        ProductPanel panel;
        panel.title =
            said("panel.title",
                 {{"material", words_.name_of(sample_.language, "material", "crayon-carnation-pink")},
                  {"lamp", sample_.glass ? said("panel.all_lamps") : lamp(sample_.chosen)}});
        panel.lamp_name = said(sample_.glass ? "panel.lamps" : "panel.lamp");
        panel.material_name = said(sample_.glass ? "panel.medium" : "panel.material");
        panel.product_name = said("panel.product");
        panel.lamp = sample_bars(sample_.chosen);
        panel.material = sample_bars(1);
        panel.product = panel.lamp;
        for (std::size_t i = 0; i < panel.product.size(); ++i)
            panel.product[i] *= panel.material[i];
        panel.left = {0xC8, 0x5A, 0x64};
        panel.right = {0xB4, 0x64, 0x46};
        panel.left_name = said("panel.numbers");
        panel.right_name = said("panel.wavelengths");
        panel.difference = said(sample_.difference);
        panel.number = said("difference.number", {{"number", words_.number(sample_.language, 12.3, 1)}});
        add(Part::panel, screen_.layout.panel, panel.title).product = panel;
        add(Part::next, screen_.layout.next, said("button.next"));
        add(Part::close, screen_.layout.close, said("button.close"));
        add(Part::expert_panel, screen_.layout.expert_panel, said("expert.title")).expert = expert();
    }

    ExpertPanel expert() const {
        const auto number = [&](double value, int decimals) {
            return words_.number(sample_.language, value, decimals);
        };
        return {{{said("expert.method"), said("method.packed") + " | " + said("method." + sample_.method)},
                 {said("expert.space"), "sRGB-D65 | Adobe-D65"},
                 {said("expert.wavelengths"), "64 | 471"},
                 {said("expert.tolerance"), said("difference.number", {{"number", number(0.5, 2)}})},
                 {said("expert.reason"), reason()},
                 {said("expert.frame"), said("expert.milliseconds", {{"ms", number(16.4, 1)}})}}};
    }

    /// As long as they get: with what was not good enough.
    std::string reason() const {
        const auto error = [&](double value) {
            return said("difference.number", {{"number", words_.number(sample_.language, value, 2)}});
        };
        const std::string behind =
            said("reason.behind", {{"material", "rgb:FFFFFF"},
                                   {"medium", words_.name_of(sample_.language, "material", "glass-cobalt")},
                                   {"thickness", words_.number(sample_.language, 2.5, 1)}});
        const std::string pixel = said("panel.title", {{"material", behind}, {"lamp", lamp(sample_.chosen)}});
        const std::string ground =
            said("reason." + sample_.ground, {{"error", error(0.12)}, {"count", "16"}, {"pixel", pixel}});
        if (sample_.ground == "asked" || sample_.ground == "constant") // nothing cheaper was tried
            return ground;
        return said(
            "reason.cheaper",
            {{"reason", ground}, {"error", error(12.34)}, {"method", said("reason.few", {{"count", "12"}})}});
    }

    const Words& words_;
    const Sample& sample_;
    bool right_to_left_ = false;
    SampleScreen screen_;
};

} // namespace

const std::vector<std::string>& sample_lamps() {
    static const std::vector<std::string> names{"D65",      "A2800",   "white-LED", "F11",
                                                "D25000",   "krypton", "LED-RGB1",  "F2",
                                                "NIST-LPS", "HP1",     "moonlight", "NIST-HG-H38HT-100"};
    return names;
}

Bars sample_bars(int kind) {
    Bars bars;
    for (std::size_t i = 0; i < kIntervals; ++i)
        bars.push_back(
            static_cast<float>(std::clamp(sample_power(kind, kThesisGrid.wavelength_nm(i)), 0.0, 1.0)));
    return bars;
}

SampleScreen sample_screen(const Words& words, const Sample& sample) {
    Builder builder(words, sample);
    SampleScreen screen = builder.build();
    std::erase_if(screen.widgets, [](const Widget& widget) { return widget.box.width == 0; });
    return screen;
}

} // namespace metamer
