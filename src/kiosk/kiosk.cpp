#include "kiosk/kiosk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gles/info.h"
#include "kiosk/description.h"
#include "render/pick.h"
#include "service/notify.h"

namespace metamer {

namespace {

constexpr int kMostWrongLooks = 2; ///< the second after everything was made anew
constexpr int kLeastScreenPx = 16; ///< what a window of any size is laid out for at least

bool reloads(const Event& event) {
    return std::holds_alternative<ReloadEvent>(event) || std::holds_alternative<FilesChangedEvent>(event);
}

std::vector<Seen> objects_of(const Exhibit& exhibit) {
    std::vector<Seen> objects;
    for (std::size_t i = 0; i < exhibit.objects.size(); ++i)
        objects.push_back({i, exhibit.objects[i].material.material.name});
    return objects;
}

} // namespace

Kiosk::Kiosk(KioskParts parts) : parts_(std::move(parts)) {
    loaded_ = parts_.load();
    visit_.emplace(loaded_->exhibit, parts_.stage->now_s());
    visit_->tick(parts_.stage->now_s(), parts_.minute_of_day());
    show_ = std::make_unique<Show>(loaded_->exhibit);
    good_ = visit_;
    refresh();
    draw();
    tell_shown();
    notify_ready();
    notify_running();
    set_watch();
    watched_s_ = parts_.stage->now_s();
}

Kiosk::~Kiosk() = default;

void Kiosk::tell_shown() {
    parts_.log->write(
        Priority::info, "shown",
        {{"driver", parts_.stage->driver()},
         {"renderer", gl_renderer()},
         {"size", std::to_string(picture().width_px) + "x" + std::to_string(picture().height_px)}});
}

PxSize Kiosk::picture() const {
    return turned({parts_.stage->surface_width_px(), parts_.stage->surface_height_px()},
                  parts_.stage->rotation_deg());
}

Shift Kiosk::shift() const {
    const int most = loaded_->exhibit.kiosk.pixel_shift_px;
    const Shift walk = pixel_shift(parts_.stage->now_s(), most);
    return {walk.x_px + most, walk.y_px};
}

// The picture wanders within a margin of twice its reach.
ScreenSize Kiosk::screen(const Loaded& loaded) const {
    const PxSize size = picture();
    const int margin_px = 2 * loaded.exhibit.kiosk.pixel_shift_px;
    return {std::max(size.width_px - margin_px, kLeastScreenPx),
            std::max(size.height_px - margin_px, kLeastScreenPx), parts_.stage->px_per_mm()};
}

PxSize Kiosk::scene_size(const Loaded& loaded, const Visit& visit) const {
    const PxBox scene = lay_out(screen(loaded), controls(loaded.exhibit, loaded.words, visit.state())).scene;
    return {scene.width, scene.height};
}

double Kiosk::due_s() const {
    const double now = parts_.stage->now_s();
    if (parts_.stage->context_lost())
        return now;
    if (!display_)
        return now + 1;
    if (show_->fading(frame_s_)) // the frame that ends a fade is due too
        return now;
    double due = visit_->next_s();
    if (loaded_->exhibit.kiosk.pixel_shift_px > 0 && visit_->phase() != Phase::night)
        due = std::min(due, (std::floor(now / 60) + 1) * 60);
    if (watch_)
        due = std::min(due, watched_s_ + loaded_->exhibit.kiosk.watch_s);
    if (const auto alive = alive_interval())
        due = std::min(due, now + std::chrono::duration<double>(*alive).count());
    if (const auto kept_back_s = parts_.log->due_in_s())
        due = std::min(due, now + *kept_back_s);
    return due;
}

bool Kiosk::turn(double most_s) {
    const double now = parts_.stage->now_s();
    const std::vector<Event>& events = parts_.stage->wait(std::clamp(due_s() - now, 0.0, most_s));
    const auto quits = [](const Event& event) { return std::holds_alternative<QuitEvent>(event); };
    if (std::any_of(events.begin(), events.end(), quits))
        return false;
    notify_alive();
    parts_.log->flush();
    try {
        return act_and_draw(events);
    } catch (const Error& error) {
        // A context may go at any moment, and whatever is drawn then fails: the next turn makes all of it
        // anew, unless that is what failed.
        if (error.status() == Exit::no_gl || !parts_.stage->context_lost())
            throw;
        for (const Event& event : events)
            if (reloads(event))
                parts_.stage->post(event);
        stale_ = dirty_ = true;
        return true;
    }
}

bool Kiosk::act_and_draw(const std::vector<Event>& events) {
    // Before the events: what they ask for is drawn.
    if (parts_.stage->context_lost())
        rebuild("the context was lost");
    for (const Event& event : events)
        if (!ends_)
            take(event);
    if (ends_)
        return false;
    const Phase before = visit_->phase();
    visit_->tick(parts_.stage->now_s(), parts_.minute_of_day());
    if (before == Phase::visitor && visit_->phase() != Phase::visitor)
        hands_.let_go(); // the keyboard's focus is not the next visitor's
    look_at_the_picture();
    if (ends_)
        return false;
    refresh();
    const Shift now_shift = shift();
    const bool moved = visit_->phase() != Phase::night &&
                       (now_shift.x_px != shown_shift_.x_px || now_shift.y_px != shown_shift_.y_px);
    untold_ = untold_ || moved;
    // One frame more ends a fade.
    if (display_ && (dirty_ || moved || show_->fading(frame_s_)))
        draw();
    return true;
}

Within Kiosk::within() {
    return {&desk_, &visit_->state(), &loaded_->words, [this](double x, double y) { return seen_at(x, y); },
            objects_};
}

std::optional<Seen> Kiosk::seen_at(double x_px, double y_px) const {
    const PxBox& scene = desk_.layout.scene;
    if (!scene.contains(x_px, y_px))
        return std::nullopt;
    const Play& play = show_->play();
    double x = (x_px - scene.left) / scene.width;
    double aspect = static_cast<double>(scene.width) / scene.height;
    if (play.side_by_side()) {
        x = x < 0.5 ? 2 * x : 2 * x - 1;
        aspect /= 2;
    }
    const auto hit =
        pick(play.renderer().scene(), play.exhibit(), x, (y_px - scene.top) / scene.height, aspect);
    if (!hit)
        return std::nullopt;
    const ObjectSetting& object = play.exhibit().objects[hit->object];
    const int key = material_key(play.exhibit(), *hit);
    const bool own = key == object.material.key;
    return Seen{hit->object, own ? object.material.material.name
                                 : play.exhibit().atlas.materials[static_cast<std::size_t>(key)].name};
}

void Kiosk::act(const std::optional<Action>& action) {
    if (action)
        visit_->act(*action);
}

bool Kiosk::wakes() {
    const bool alone = visit_->phase() != Phase::visitor;
    const bool woke = visit_->touch(parts_.stage->now_s());
    if (alone)
        refresh(); // what is touched is the visitor's, not the tour's
    return woke;
}

void Kiosk::take(const Event& event) {
    if (const auto* pointer = std::get_if<PointerEvent>(&event)) {
        if (wakes()) {
            hands_.let_go(); // what wakes the night does nothing else
            return;
        }
        PointerEvent inside = *pointer;
        inside.x_px -= shown_shift_.x_px;
        inside.y_px -= shown_shift_.y_px;
        act(hands_.pointer(inside, within()));
    } else if (const auto* key = std::get_if<KeyEvent>(&event)) {
        if (!wakes())
            act(hands_.key(*key, within()));
    } else if (std::holds_alternative<ResizeEvent>(event)) {
        stale_ = dirty_ = true;
        hands_.let_go();
    } else if (std::holds_alternative<ExposeEvent>(event)) {
        dirty_ = true;
    } else if (std::holds_alternative<DisplayGoneEvent>(event)) {
        display_ = false;
        parts_.log->write(Priority::warning, "display_gone");
        notify_waiting();
    } else if (std::holds_alternative<DisplayBackEvent>(event)) {
        display_ = dirty_ = true;
        parts_.log->write(Priority::notice, "display_back");
        notify_running();
    } else if (reloads(event)) {
        reload();
    }
}

void Kiosk::reload() {
    notify_reloading();
    try {
        std::unique_ptr<Loaded> fresh = parts_.load();
        // It must be drawn before the old one goes: an exhibit may be readable and still not plannable.
        Visit visit = *visit_;
        visit.take_over(fresh->exhibit);
        auto show = std::make_unique<Show>(fresh->exhibit);
        show->stage(cue_of(visit), scene_size(*fresh, visit), parts_.stage->now_s());
        show_ = std::move(show);
        // Without its words a language is another.
        visit.act(ChooseLanguage{fresh->words.language(visit.state().language).code});
        good_ = visit_ = visit;
        loaded_ = std::move(fresh);
        parts_.stage->hang(loaded_->exhibit.kiosk.rotation_deg, loaded_->exhibit.kiosk.diagonal_in);
        reload_notice_.clear();
        scene_notice_.clear();
        set_watch();
        parts_.log->write(Priority::info, "reloaded", {{"exhibit", loaded_->exhibit.place}});
    } catch (const Error& error) {
        if (parts_.stage->context_lost())
            throw;
        reload_notice_ = refuse("reload_refused", error);
    }
    hands_.let_go();
    stale_ = dirty_ = true;
    notify_ready();
}

std::string Kiosk::refuse(const char* event, const Error& error) {
    parts_.log->write(Priority::error, event, {{"error", error.what()}});
    return loaded_->words.text(visit_->state().language, "notice.refused", {{"error", error.what()}});
}

void Kiosk::rebuild(const std::string& why) {
    parts_.log->write(Priority::warning, "context_rebuilt", {{"why", why}});
    watch_.reset();
    show_.reset();
    if (!parts_.stage->rebuild()) {
        ends_ = true;
        return;
    }
    show_ = std::make_unique<Show>(loaded_->exhibit);
    set_watch();
    ++rebuilds_;
    display_ = true; // where a window opens there is one
    stale_ = dirty_ = true;
    refresh(); // the events to come are about what stands there
    tell_shown();
    notify_running();
}

void Kiosk::set_watch() {
    if (loaded_->exhibit.kiosk.watch_s <= 0)
        watch_.reset();
    else if (!watch_)
        try {
            watch_.emplace();
        } catch (const Error& error) {
            // The exhibit is drawn all the same.
            if (parts_.stage->context_lost())
                throw;
            parts_.log->write(Priority::warning, "watch_off", {{"error", error.what()}});
        }
}

void Kiosk::look_at_the_picture() {
    const double now = parts_.stage->now_s();
    if (!watch_ || now < watched_s_ + loaded_->exhibit.kiosk.watch_s)
        return;
    watched_s_ = now;
    const std::string wrong = watch_->look();
    if (parts_.stage->context_lost())
        return; // then it would be
    if (wrong.empty()) {
        wrong_looks_ = 0;
        return;
    }
    parts_.log->write(Priority::error, "picture_wrong", {{"what", wrong}});
    if (++wrong_looks_ >= kMostWrongLooks)
        throw failure("go on", "drawing", wrong + ", even after everything was made anew");
    rebuild("the picture was wrong");
    watched_s_ = now - loaded_->exhibit.kiosk.watch_s; // and looks again with the next turn
}

void Kiosk::stage_scene() {
    if (cue_of(*visit_) != cue_of(*good_))
        scene_notice_.clear();
    const auto stage = [this] {
        show_->stage(cue_of(*visit_), scene_size(*loaded_, *visit_), parts_.stage->now_s());
    };
    try {
        stage();
        good_ = visit_;
    } catch (const Error& error) {
        // The planner may refuse it, or the GPU: a program may be too long for it.
        if (error.status() == Exit::no_gl || parts_.stage->context_lost() ||
            cue_of(*visit_) == cue_of(*good_))
            throw;
        scene_notice_ = refuse("scene_refused", error);
        visit_->put_back(*good_);
        stage();
    }
}

// Dragging moves two things: nothing is laid out, painted or allocated.
bool Kiosk::move_split_only() {
    const VisitState& state = visit_->state();
    const auto inner = [](double split) { return split > 0 && split < 1; };
    VisitState& laid = laid_.state;
    if (state.mode != Mode::methods || !inner(laid.split) || !inner(state.split))
        return false;
    const double before = std::exchange(laid.split, state.split);
    if (laid != state) {
        laid.split = before;
        return false;
    }
    for (Widget& widget : desk_.widgets)
        if (widget.part == Part::split) {
            widget.box = split_handle(desk_.layout, state.split);
            widget.value = state.split;
        }
    return true;
}

void Kiosk::lay_desk() {
    const Facts facts{&loaded_->exhibit,
                      &show_->play().exhibit(),
                      &show_->play().renderer().plan(),
                      &show_->play().renderer().spectra(),
                      &*visit_,
                      &loaded_->words,
                      screen(*loaded_),
                      hands_.focus(),
                      notice(),
                      show_->frame_ms()};
    desk_ = make_desk(facts);
    objects_ = objects_of(show_->play().exhibit());
}

void Kiosk::refresh() {
    const bool same_around = !stale_ && laid_.phase == visit_->phase() && laid_.step == visit_->step() &&
                             laid_.focus == hands_.focus();
    if (same_around && laid_.state == visit_->state())
        return;
    dirty_ = untold_ = true;
    if (same_around && move_split_only())
        return;
    if (visit_->phase() != Phase::night) {
        stage_scene();
        lay_desk();
    } else {
        desk_.widgets.clear();
    }
    show_->paint(desk_);
    laid_ = {visit_->state(), visit_->phase(), visit_->step(), hands_.focus()};
    stale_ = false;
}

void Kiosk::draw() {
    shown_shift_ = shift();
    const double now = parts_.stage->now_s();
    parts_.stage->bind();
    show_->compose(desk_, picture(), parts_.stage->rotation_deg(), shown_shift_, visit_->state().split, now,
                   visit_->phase() == Phase::night);
    parts_.stage->show();
    frame_s_ = now;
    dirty_ = false;
    if (parts_.describe && untold_)
        parts_.describe(description(desk_, *visit_, picture(), shown_shift_));
    untold_ = false;
}

} // namespace metamer
