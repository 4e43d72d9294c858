// A desk with hands at it and no GPU: the plan is made on the CPU, what lies in the scene is told.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "exhibit/booth.h"
#include "kiosk/desk.h"
#include "kiosk/exhibits.h"
#include "kiosk/hands.h"

namespace metamer {

/// The scene's objects stand side by side in the upper nine tenths of its box; nothing is under them.
class TestDesk {
public:
    explicit TestDesk(const std::string& text = patches(), ScreenSize size = {1280, 720, 4})
        : exhibit(kiosk_exhibit(text)), visit(exhibit, 0), screen(size), text_(text) {
        visit.touch(0);
        lay();
    }

    /// As the kiosk does after each change.
    void lay() {
        drawn_ = visit.state().mode == Mode::booth ? booth() : scene();
        desk = make_desk(facts());
    }
    Facts facts() const {
        return {&exhibit, &drawn(), &plan(),       &spectra(), &visit,
                &words,   screen,   hands.focus(), notice,     12.34};
    }
    const Exhibit& drawn() const { return drawn_->exhibit; }
    const Plan& plan() const { return drawn_->plan; }
    const ExhibitSpectra& spectra() const { return *drawn_->spectra; }

    Within within() {
        objects.clear();
        for (std::size_t i = 0; i < drawn().objects.size(); ++i)
            objects.push_back({i, drawn().objects[i].material.material.name});
        return {&desk, &visit.state(), &words, [this](double x, double y) { return seen(x, y); }, objects};
    }
    std::optional<Seen> seen(double x, double y) const {
        const PxBox& scene = desk.layout.scene;
        if (!scene.contains(x, y) || y > scene.top + 0.9 * scene.height)
            return std::nullopt;
        const auto count = static_cast<double>(drawn().objects.size());
        const auto i = static_cast<std::size_t>((x - scene.left) / scene.width * count);
        return Seen{i, drawn().objects[i].material.material.name};
    }

    /// What the hands make of it, done and laid anew. Returns whether it meant anything.
    bool pointer(PointerPhase phase, double x, double y, int finger = 0) {
        return done(hands.pointer({phase, finger, x, y}, within()));
    }
    bool key(Key key) { return done(hands.key({key}, within())); }
    bool tap(double x, double y) {
        const bool down = pointer(PointerPhase::down, x, y);
        return pointer(PointerPhase::up, x, y) || down;
    }
    bool tap(Part part, int index = 0) {
        const PxBox box = desk.find(part, index)->box;
        return tap(box.left + box.width / 2.0, box.top + box.height / 2.0);
    }
    /// Moves the focus there by tab; false where it does not come by.
    bool focus(Focus wanted) {
        for (int i = 0; i < 100; ++i) {
            if (hands.focus() == wanted)
                return true;
            key(Key::tab);
        }
        return false;
    }

    const Words& words = all_words();
    Exhibit exhibit;
    Visit visit;
    ScreenSize screen;
    Hands hands;
    std::string notice;
    Desk desk;
    std::vector<Seen> objects;

private:
    /// The plan points into the exhibit.
    struct Drawn {
        Exhibit exhibit;
        std::optional<ExhibitSpectra> spectra;
        Plan plan;

        explicit Drawn(Exhibit e)
            : exhibit(std::move(e)), spectra(exhibit), plan(plan_exhibit(exhibit, *spectra)) {}
    };

    std::shared_ptr<const Drawn> scene() const {
        const Exhibit& base = visit.scene() ? *visit.scene() : exhibit;
        Exhibit lit = base;
        apply(visit.state(), base, lit);
        return std::make_shared<Drawn>(std::move(lit));
    }
    /// Its cards take time: once for all desks of a text.
    std::shared_ptr<const Drawn> booth() const {
        static std::map<std::string, std::shared_ptr<const Drawn>> all;
        const VisitState& state = visit.state();
        auto& found = all[std::to_string(state.booth_left) + ' ' + std::to_string(state.booth_right) + text_];
        if (!found)
            found = std::make_shared<Drawn>(booth_exhibit(exhibit, exhibit.kiosk.lamps[state.booth_left],
                                                          exhibit.kiosk.lamps[state.booth_right]));
        return found;
    }

    bool done(const std::optional<Action>& action) {
        const VisitState before = visit.state();
        const std::optional<Focus> focus = laid_focus_;
        if (action)
            visit.act(*action);
        laid_focus_ = hands.focus();
        if (before != visit.state() || focus != laid_focus_)
            lay();
        return action.has_value();
    }
    std::optional<Focus> laid_focus_;
    std::string text_;
    std::shared_ptr<const Drawn> drawn_;
};

inline double middle_x(const PxBox& box) {
    return box.left + box.width / 2.0;
}
inline double middle_y(const PxBox& box) {
    return box.top + box.height / 2.0;
}

} // namespace metamer
