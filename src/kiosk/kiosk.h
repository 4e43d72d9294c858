// The kiosk: one turn after another of waiting, acting, drawing what changed.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "kiosk/desk.h"
#include "kiosk/hands.h"
#include "kiosk/loaded.h"
#include "kiosk/picture_watch.h"
#include "kiosk/show.h"
#include "service/log.h"
#include "window/stage.h"

namespace metamer {

struct KioskParts {
    Stage* stage;                                  ///< not owned
    Log* log;                                      ///< not owned
    std::function<std::unique_ptr<Loaded>()> load; ///< throws bad_input; called at start and for each reload
    std::function<int()> minute_of_day;            ///< local time, 0 .. 1439
    std::function<void(const std::string&)> describe; ///< what is shown, as JSON, whenever it changed
};

class Kiosk {
public:
    /// Loads, draws and shows the first frame. Throws what loading and drawing throw.
    explicit Kiosk(KioskParts parts);
    ~Kiosk();

    /// Waits for what comes next, at most `most_s`, and does it. Returns false when it is time to end.
    /// Throws failure where the picture stays wrong after everything was made anew, no_gl where the context
    /// does not come back.
    bool turn(double most_s = 1e9);

    const Visit& visit() const { return *visit_; }
    const Desk& desk() const { return desk_; }
    /// What the corner says: of the file that was refused last, else of the scene.
    const std::string& notice() const { return reload_notice_.empty() ? scene_notice_ : reload_notice_; }
    const Show& show() const { return *show_; }
    long rebuilds() const { return rebuilds_; }

private:
    bool act_and_draw(const std::vector<Event>& events);
    void take(const Event& event);
    bool wakes();
    void act(const std::optional<Action>& action);
    void reload();
    std::string refuse(const char* event, const Error& error);
    void tell_shown();
    void rebuild(const std::string& why);
    void set_watch();
    void look_at_the_picture();
    void refresh();
    void stage_scene();
    void lay_desk();
    bool move_split_only();
    void draw();
    double due_s() const;
    Within within();
    std::optional<Seen> seen_at(double x_px, double y_px) const;
    PxSize picture() const;
    Shift shift() const;
    ScreenSize screen(const Loaded& loaded) const;
    PxSize scene_size(const Loaded& loaded, const Visit& visit) const;

    KioskParts parts_;
    std::unique_ptr<Loaded> loaded_;
    std::optional<Visit> visit_;
    std::unique_ptr<Show> show_;
    std::optional<PictureWatch> watch_;
    Hands hands_;
    Desk desk_;
    std::vector<Seen> objects_; ///< of the scene on show, for the keyboard
    std::optional<Visit> good_; ///< the last whose scene could be drawn
    /// What the desk was laid for.
    struct {
        VisitState state;
        Phase phase = Phase::visitor;
        int step = -1;
        std::optional<Focus> focus;
    } laid_;
    std::string reload_notice_; ///< until the next good file
    std::string scene_notice_;  ///< until the next wish
    Shift shown_shift_;
    double watched_s_ = 0, frame_s_ = -1;
    long rebuilds_ = 0;
    int wrong_looks_ = 0;
    bool stale_ = true;  ///< the desk must be laid anew
    bool dirty_ = true;  ///< a frame must be shown
    bool untold_ = true; ///< the next frame must be described
    bool ends_ = false, display_ = true;
};

} // namespace metamer
