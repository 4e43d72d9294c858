// A stage without any screen: for tests and soak runs. Time and events are scripted.
#pragma once

#include <functional>
#include <mutex>
#include <optional>

#include "gles/framebuffer.h"
#include "gles/surfaceless.h"
#include "window/stage.h"

namespace metamer {

/// Its clock goes on only by advance() and by wait(), which returns at once: with the events that are there,
/// or, where there are none even after the script ran, with nothing and its time passed (none, where it would
/// wait forever: the script must post an end). The framebuffer has a depth buffer, as a window has.
class SurfacelessStage : public Stage {
public:
    SurfacelessStage(int width_px, int height_px, int rotation_deg = 0, double px_per_mm = 4);

    const std::vector<Event>& wait(double most_s) override;
    void post(const Event& event) override;
    int surface_width_px() const override { return width_px_; }
    int surface_height_px() const override { return height_px_; }
    int rotation_deg() const override { return rotation_deg_; }
    double px_per_mm() const override;
    void hang(int rotation_deg, double diagonal_in) override;
    void bind() override;
    void show() override;
    bool context_lost() override { return lost_; }
    bool rebuild() override;
    double now_s() const override { return now_s_; }
    std::string driver() const override { return "surfaceless"; }

    /// Called by wait() when no event is queued: posts what comes next, or nothing to let the time pass.
    void on_idle(std::function<void()> script) { script_ = std::move(script); }
    void advance(double seconds) { now_s_ += seconds; }
    /// Until rebuild() no call draws or makes anything: context_lost() says so, and the next wait() once.
    void lose_context();
    /// From now on rebuild() finds no display, and gives up.
    void lose_display() { display_ = false; }
    /// Another surface, before rotation; wait() tells the picture's size.
    void resize(int width_px, int height_px);

    long frames_shown() const { return frames_; }
    /// The last frame as it stands on the surface, rows from the top, RGBA.
    std::vector<std::uint8_t> read_rgba() const;

private:
    void take_posted();

    int width_px_, height_px_, rotation_deg_;
    double px_per_mm_, diagonal_in_ = 0, now_s_ = 0;
    bool lost_ = false, display_ = true;
    long frames_ = 0;
    std::mutex mutex_; ///< guards posted_
    std::vector<Event> posted_, events_;
    std::function<void()> script_;
    std::optional<Surfaceless> context_;
    std::optional<Framebuffer> target_;
};

} // namespace metamer
