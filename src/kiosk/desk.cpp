#include "kiosk/desk.h"

#include <algorithm>

#include "kiosk/brief_error.h"
#include "kiosk/product.h"
#include "kiosk/reason_words.h"

namespace metamer {

namespace {

/// Fills a desk in from facts.
class DeskBuilder {
public:
    explicit DeskBuilder(const Facts& facts)
        : facts_(facts),
          state_(facts.visit->state()),
          language_(facts.words->language(facts.visit->state().language)) {}

    Desk build();

private:
    std::string say(const char* key, const std::map<std::string, std::string>& values = {}) const {
        return facts_.words->text(language_.code, key, values);
    }
    Widget& add(Part part, const PxBox& box, std::string text, int index = 0);
    Contents contents() const;
    void add_halves();
    void add_shelf(Part part, const std::vector<PxBox>& boxes, std::optional<std::size_t> chosen);
    void add_strength();
    void add_buttons();
    void add_panels();

    const Facts& facts_;
    const VisitState& state_;
    const Language& language_;
    std::optional<ProductPanel> product_;
    Desk desk_;
};

Widget& DeskBuilder::add(Part part, const PxBox& box, std::string text, int index) {
    static Widget nowhere;
    if (box.width <= 0 || box.height <= 0)
        return nowhere = {};
    Widget& widget = desk_.widgets.emplace_back();
    widget.part = part;
    widget.index = index;
    widget.box = box;
    widget.text = std::move(text);
    widget.right_to_left = language_.right_to_left;
    widget.focused = facts_.focus == Focus{part, index};
    return widget;
}

Contents DeskBuilder::contents() const {
    const bool visitor = facts_.visit->phase() == Phase::visitor;
    Contents contents = controls(*facts_.shelf, *facts_.words, state_);
    contents.panel = product_.has_value();
    contents.expert = state_.expert;
    contents.caption = !facts_.visit->caption().empty();
    contents.hint = !contents.caption && !(visitor && contents.panel);
    contents.notice = !facts_.notice.empty();
    return contents;
}

void DeskBuilder::add_halves() {
    const auto name = [&](std::size_t half) {
        return half_name(*facts_.exhibit, *facts_.plan, half, HalfName::full, *facts_.words, language_.code);
    };
    const bool booth = state_.mode == Mode::booth;
    const auto card = [&](std::size_t half, std::size_t lamp) {
        const std::string& lamp_name = facts_.shelf->kiosk.lamps[lamp].lamp.name;
        const bool match = cards_match(*facts_.exhibit, *facts_.plan, *facts_.spectra, half);
        return say(match ? "booth.match" : "booth.part",
                   {{"lamp", facts_.words->name_of(language_.code, "lamp", lamp_name)}});
    };
    const std::size_t last = facts_.plan->halves.size() - 1;
    const std::string left = booth ? card(0, state_.booth_left) : name(0);
    const std::string right = booth ? card(last, state_.booth_right) : name(last);
    const bool beside = halves_side_by_side(*facts_.exhibit);
    if (facts_.plan->halves.size() > 1 && (beside || state_.split > 0))
        add(Part::left_label, desk_.layout.left_label, left).touchable = false;
    if (beside || state_.split < 1)
        add(Part::right_label, desk_.layout.right_label, right).touchable = false;
    if (!beside && facts_.plan->halves.size() > 1)
        add(Part::split, split_handle(desk_.layout, state_.split), say("split.handle")).value = state_.split;
}

void DeskBuilder::add_shelf(Part part, const std::vector<PxBox>& boxes, std::optional<std::size_t> chosen) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const LampSetting& lamp = facts_.shelf->kiosk.lamps[i];
        Widget& tile = add(part, boxes[i], facts_.words->name_of(language_.code, "lamp", lamp.lamp.name),
                           static_cast<int>(i));
        tile.on = chosen == i;
        tile.bars = lamp_bars(lamp, facts_.shelf->atlas);
    }
}

void DeskBuilder::add_strength() {
    const std::string factor = factor_words(state_.strength, *facts_.words, language_.code);
    add(Part::strength, desk_.layout.strength, say("slider.strength", {{"factor", factor}})).value =
        slider_of_strength(state_.strength);
}

void DeskBuilder::add_buttons() {
    const bool booth = state_.mode == Mode::booth;
    add(Part::mode, desk_.layout.mode, say(booth ? "button.methods" : "button.booth"));
    add(Part::expert, desk_.layout.expert, say("button.expert")).on = state_.expert;
    const std::vector<Language>& all = facts_.words->languages();
    for (std::size_t i = 0; i < desk_.layout.languages.size() && i < all.size(); ++i)
        add(Part::language, desk_.layout.languages[i], all[i].name, static_cast<int>(i)).on =
            all[i].code == language_.code;
}

void DeskBuilder::add_panels() {
    const std::string caption = facts_.visit->caption();
    const bool booth = state_.mode == Mode::booth;
    const bool visitor = facts_.visit->phase() == Phase::visitor;
    add(Part::caption, desk_.layout.caption, caption).touchable = false;
    add(Part::hint, desk_.layout.hint,
        say(!visitor                                            ? "hint.start"
            : booth                                             ? "hint.booth"
            : desk_.find(Part::lamp) && desk_.find(Part::split) ? "hint.methods"
                                                                : "hint.objects"))
        .touchable = false;
    if (state_.expert) {
        const ExpertPanel expert = expert_panel(facts_);
        Widget& widget = add(Part::expert_panel, desk_.layout.expert_panel, say("expert.title"));
        widget.expert = expert;
        widget.touchable = false;
    }
    if (product_) {
        Widget& panel = add(Part::panel, desk_.layout.panel,
                            product_->title + ". " + product_->number + ": " + product_->difference);
        panel.product = product_;
        panel.focused = facts_.focus == kSceneFocus;
        if (facts_.exhibit->objects.size() > 1)
            add(Part::next, desk_.layout.next, say("button.next"));
        add(Part::close, desk_.layout.close, say("button.close"));
    }
    add(Part::notice, desk_.layout.notice, brief_error(facts_.notice)).touchable = false;
}

Desk DeskBuilder::build() {
    if (state_.seen)
        product_ = product_panel(*facts_.exhibit, *facts_.plan, *facts_.spectra, *state_.seen, *facts_.words,
                                 language_.code);
    desk_.layout = lay_out(facts_.screen, contents());
    const bool booth = state_.mode == Mode::booth;
    add_halves();
    add_shelf(Part::lamp, desk_.layout.lamps, booth ? std::optional(state_.booth_left) : state_.lamp);
    if (booth)
        add_shelf(Part::lamp_right, desk_.layout.lamps_right, state_.booth_right);
    add_strength();
    add_buttons();
    add_panels();
    return std::move(desk_);
}

std::string wavelengths(const ObjectPlan& plan) {
    switch (plan.method) {
    case Method::spectral:
    case Method::packed:
        return std::to_string(kIntervals);
    case Method::reduced:
        return std::to_string(plan.taps.wavelength_nm.size());
    case Method::folded:
        return std::to_string(kReferenceGrid.count);
    default:
        return "3";
    }
}

} // namespace

const Widget* Desk::at(double x_px, double y_px) const {
    const auto found = std::find_if(widgets.rbegin(), widgets.rend(), [&](const Widget& widget) {
        return widget.touchable && widget.box.contains(x_px, y_px);
    });
    return found == widgets.rend() ? nullptr : &*found;
}

const Widget* Desk::find(Part part, int index) const {
    const auto found = std::find_if(widgets.begin(), widgets.end(), [&](const Widget& widget) {
        return widget.part == part && widget.index == index;
    });
    return found == widgets.end() ? nullptr : &*found;
}

Contents controls(const Exhibit& shelf, const Words& words, const VisitState& state) {
    Contents contents;
    contents.lamps = static_cast<int>(lamps_to_choose(shelf));
    contents.languages = static_cast<int>(words.languages().size());
    contents.booth = state.mode == Mode::booth;
    contents.right_to_left = words.language(state.language).right_to_left;
    return contents;
}

ExpertPanel expert_panel(const Facts& facts) {
    const VisitState& state = facts.visit->state();
    const std::string& language = state.language;
    const auto say = [&](const char* key, const std::map<std::string, std::string>& values = {}) {
        return facts.words->text(language, key, values);
    };
    const std::size_t object =
        state.seen && state.seen->object < facts.exhibit->objects.size() ? state.seen->object : 0;
    const auto both = [&](auto value) {
        std::string left = value(facts.plan->halves.front()), right = value(facts.plan->halves.back());
        if (left == right)
            return left;
        if (!facts.words->language(language).right_to_left)
            return left + " | " + right;
        // The picture's left stays left: a pair that runs from left to right, each of it as its own words run
        // (Unicode isolates, UAX #9).
        return "\u2066\u2068" + left + "\u2069 | \u2068" + right + "\u2069\u2069";
    };
    ExpertPanel panel;
    panel.rows.push_back(
        {say("expert.method"), both([&](const HalfPlan& half) {
             return say(("method." + std::string(method_name(half.objects[object].method))).c_str());
         })});
    panel.rows.push_back({say("expert.space"), both([&](const HalfPlan& half) {
                              const WorkingSpace* own =
                                  half.view.half ? half.view.half->working_space : nullptr;
                              return std::string((own ? own : facts.exhibit->display.working_space)->name);
                          })});
    panel.rows.push_back({say("expert.wavelengths"),
                          both([&](const HalfPlan& half) { return wavelengths(half.objects[object]); })});
    panel.rows.push_back(
        {say("expert.tolerance"),
         say("difference.number", {{"number", facts.words->number(language, facts.plan->tolerance, 2)}})});
    panel.rows.push_back({say("expert.reason"), reason_words(facts.plan->halves.back().objects[object].why,
                                                             *facts.words, language)});
    panel.rows.push_back(
        {say("expert.frame"),
         say("expert.milliseconds", {{"ms", facts.words->number(language, facts.frame_ms, 1)}})});
    return panel;
}

Desk make_desk(const Facts& facts) {
    return DeskBuilder(facts).build();
}

} // namespace metamer
