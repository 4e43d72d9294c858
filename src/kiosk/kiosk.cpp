#include "kiosk/kiosk.h"

#include <GLES2/gl2.h>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "gles/info.h"
#include "kiosk/description.h"
#include "render/pick.h"
#include "service/notify.h"

namespace metamer {

namespace {

constexpr int kMostWrongLooks = 2; ///< the second after everything was made anew

std::vector<Seen> objects_of(const Exhibit& exhibit) {
    std::vector<Seen> objects;
    for (std::size_t i = 0; i < exhibit.objects.size(); ++i)
        objects.push_back({i, exhibit.objects[i].material.material.name});
    return objects;
}

} // namespace

Kiosk::Kiosk(KioskParts parts) : parts_(std::move(parts)) {
    loaded_ = parts_.load();
    parts_.loaded(*loaded_);
    visit_.emplace(loaded_->exhibit, parts_.stage->now_s());
    visit_->tick(parts_.stage->now_s(), parts_.minute_of_day());
    show_.emplace(loaded_->exhibit);
    good_ = visit_->state();
    refresh();
    draw();
    if (loaded_->exhibit.kiosk.watch_s > 0)
        watch_.emplace();
    watched_s_ = parts_.stage->now_s();
    parts_.log->write(
        Priority::info, "shown",
        {{"driver", parts_.stage->driver()},
         {"renderer", gl_renderer()},
         {"size", std::to_string(picture().width_px) + "x" + std::to_string(picture().height_px)}});
    notify_ready();
}

Kiosk::~Kiosk() = default;

PxSize Kiosk::picture() const {
    return turned({parts_.stage->surface_width_px(), parts_.stage->surface_height_px()},
                  parts_.stage->rotation_deg());
}

// The picture wanders within a margin of twice its reach.
int Kiosk::margin_px() const {
    return 2 * loaded_->exhibit.kiosk.pixel_shift_px;
}

Shift Kiosk::shift() const {
    const int most = loaded_->exhibit.kiosk.pixel_shift_px;
    const Shift walk = pixel_shift(parts_.stage->now_s(), most);
    return {walk.x_px + most, walk.y_px};
}

ScreenSize Kiosk::screen() const {
    const PxSize size = picture();
    return {size.width_px - margin_px(), size.height_px - margin_px(), parts_.stage->px_per_mm()};
}

double Kiosk::due_s() const {
    const double now = parts_.stage->now_s();
    if (!display_)
        return now + 1;
    if (show_->fading(now))
        return now;
    double due = visit_->next_s();
    if (loaded_->exhibit.kiosk.pixel_shift_px > 0)
        due = std::min(due, (std::floor(now / 60) + 1) * 60);
    if (watch_)
        due = std::min(due, watched_s_ + loaded_->exhibit.kiosk.watch_s);
    if (const auto alive = alive_interval())
        due = std::min(due, now + std::chrono::duration<double>(*alive).count());
    return due;
}

bool Kiosk::turn(double most_s) {
    const double now = parts_.stage->now_s();
    for (const Event& event : parts_.stage->wait(std::clamp(due_s() - now, 0.0, most_s)))
        take(event);
    if (ends_)
        return false;
    notify_alive();
    if (parts_.stage->context_lost())
        rebuild("the context was reset");
    visit_->tick(parts_.stage->now_s(), parts_.minute_of_day());
    look_at_the_picture();
    refresh();
    const Shift now_shift = shift();
    const bool moved = now_shift.x_px != shown_shift_.x_px || now_shift.y_px != shown_shift_.y_px;
    // One frame more ends a fade.
    const bool fades = frame_end_s_ < 1e300 && show_->fading(frame_end_s_);
    if (display_ && (dirty_ || moved || fades))
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

void Kiosk::take(const Event& event) {
    const double now = parts_.stage->now_s();
    if (const auto* pointer = std::get_if<PointerEvent>(&event)) {
        if (visit_->touch(now)) {
            hands_.let_go(); // what wakes the night does nothing else
            return;
        }
        PointerEvent inside = *pointer;
        inside.x_px -= shown_shift_.x_px;
        inside.y_px -= shown_shift_.y_px;
        act(hands_.pointer(inside, within()));
    } else if (const auto* key = std::get_if<KeyEvent>(&event)) {
        if (!visit_->touch(now))
            act(hands_.key(*key, within()));
    } else if (std::holds_alternative<ResizeEvent>(event)) {
        stale_ = dirty_ = true;
        hands_.let_go();
    } else if (std::holds_alternative<ExposeEvent>(event)) {
        dirty_ = true;
    } else if (std::holds_alternative<ContextLostEvent>(event)) {
        rebuild("the context was lost");
    } else if (std::holds_alternative<DisplayGoneEvent>(event)) {
        display_ = false;
        parts_.log->write(Priority::warning, "display_gone");
    } else if (std::holds_alternative<DisplayBackEvent>(event)) {
        display_ = dirty_ = true;
        parts_.log->write(Priority::notice, "display_back");
    } else if (std::holds_alternative<QuitEvent>(event)) {
        ends_ = true;
    } else {
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
        auto show = std::make_unique<std::optional<Show>>(std::in_place, fresh->exhibit);
        (*show)->stage(cue_of(visit),
                       {desk_.layout.scene.width > 0 ? desk_.layout.scene.width : 64,
                        desk_.layout.scene.height > 0 ? desk_.layout.scene.height : 64},
                       parts_.stage->now_s());
        (*show).reset();
        show_.reset();
        visit_ = visit;
        loaded_ = std::move(fresh);
        show_.emplace(loaded_->exhibit);
        notice_.clear();
        parts_.loaded(*loaded_);
        parts_.log->write(Priority::info, "reloaded", {{"exhibit", loaded_->exhibit.place}});
    } catch (const Error& error) {
        notice_ = loaded_->words.text(visit_->state().language, "notice.refused", {{"error", error.what()}});
        parts_.log->write(Priority::error, "reload_refused", {{"error", error.what()}});
    }
    hands_.let_go();
    stale_ = dirty_ = true;
    notify_ready();
}

void Kiosk::rebuild(const std::string& why) {
    parts_.log->write(Priority::warning, "context_rebuilt", {{"why", why}});
    const bool watched = watch_.has_value();
    watch_.reset();
    show_.reset();
    parts_.stage->rebuild();
    show_.emplace(loaded_->exhibit);
    if (watched)
        watch_.emplace();
    ++rebuilds_;
    stale_ = dirty_ = true;
}

void Kiosk::look_at_the_picture() {
    const double now = parts_.stage->now_s();
    if (!watch_ || now < watched_s_ + loaded_->exhibit.kiosk.watch_s)
        return;
    watched_s_ = now;
    const std::string wrong = watch_->look();
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

bool Kiosk::stage_scene() {
    const PxBox& scene = desk_.layout.scene;
    const PxSize size{scene.width, scene.height};
    try {
        const bool drew = show_->stage(cue_of(*visit_), size, parts_.stage->now_s());
        good_ = visit_->state();
        return drew;
    } catch (const Error& error) {
        if (error.status() != Exit::bad_input || visit_->state() == good_)
            throw;
        notice_ = loaded_->words.text(visit_->state().language, "notice.refused", {{"error", error.what()}});
        parts_.log->write(Priority::error, "scene_refused", {{"error", error.what()}});
        visit_->put_back(good_);
        stale_ = true;
        return show_->stage(cue_of(*visit_), size, parts_.stage->now_s());
    }
}

// Dragging moves two things: nothing is laid out, painted or allocated.
bool Kiosk::move_split_only(const VisitState& before) {
    VisitState moved = before;
    moved.split = visit_->state().split;
    if (moved != visit_->state() || moved.mode != Mode::methods)
        return false;
    const auto inner = [](double split) { return split > 0 && split < 1; };
    if (!inner(before.split) || !inner(moved.split))
        return false;
    for (Widget& widget : desk_.widgets)
        if (widget.part == Part::split) {
            widget.box = split_handle(desk_.layout, moved.split);
            widget.value = moved.split;
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
                      screen(),
                      hands_.focus(),
                      notice_,
                      show_->frame_ms()};
    desk_ = make_desk(facts);
    objects_ = objects_of(show_->play().exhibit());
}

// The desk needs the plan of the scene, the scene the desk's layout: both are cheap to repeat.
void Kiosk::refresh() {
    const bool changed = stale_ || laid_ != visit_->state() || laid_phase_ != visit_->phase() ||
                         laid_step_ != visit_->step() || laid_focus_ != hands_.focus();
    if (!changed)
        return;
    dirty_ = true;
    const bool same_desk = !stale_ && laid_phase_ == visit_->phase() && laid_step_ == visit_->step() &&
                           laid_focus_ == hands_.focus() && move_split_only(laid_);
    if (!same_desk && visit_->phase() != Phase::night) {
        if (desk_.layout.scene.width == 0)
            desk_.layout =
                lay_out(screen(), {.lamps = static_cast<int>(loaded_->exhibit.kiosk.lamps.size()),
                                   .languages = static_cast<int>(loaded_->words.languages().size())});
        stage_scene();
        lay_desk();
        stage_scene(); // the box may be another
        show_->paint(desk_);
    } else if (!same_desk) {
        desk_.widgets.clear();
        show_->paint(desk_);
    }
    laid_ = visit_->state();
    laid_phase_ = visit_->phase();
    laid_step_ = visit_->step();
    laid_focus_ = hands_.focus();
    stale_ = false;
    if (!same_desk)
        describe();
}

void Kiosk::draw() {
    shown_shift_ = shift();
    const double now = parts_.stage->now_s();
    parts_.stage->bind();
    show_->compose(desk_, picture(), parts_.stage->rotation_deg(), shown_shift_, visit_->state().split, now,
                   visit_->phase() == Phase::night);
    parts_.stage->show();
    frame_end_s_ = now;
    dirty_ = false;
}

void Kiosk::describe() const {
    if (parts_.describe)
        parts_.describe(description(desk_, *visit_, picture(), shift()));
}

} // namespace metamer
