// The stage that a visitor sees.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>

#include "window/connectors.h"
#include "window/input_wait.h"
#include "window/sdl_input.h"
#include "window/sdl_window.h"
#include "window/stage.h"

namespace metamer {

/// What open_window() opens.
class SdlStage : public Stage {
public:
    /// `connectors`: where Linux tells of them; looked at once a second where SDL does not tell (KMSDRM).
    explicit SdlStage(const WindowOptions& options, std::filesystem::path connectors = "/sys/class/drm");
    ~SdlStage() override;

    /// False: WindowOptions::still_waiting said so. Throws no_gl.
    bool open();

    const std::vector<Event>& wait(double most_s) override;
    void post(const Event& event) override;
    int surface_width_px() const override { return surface_.width_px; }
    int surface_height_px() const override { return surface_.height_px; }
    int rotation_deg() const override { return options_.rotation_deg; }
    double px_per_mm() const override { return px_per_mm_; }
    void hang(int rotation_deg, double diagonal_in) override;
    void bind() override;
    void show() override;
    bool context_lost() override;
    bool rebuild() override { return open(); }
    double now_s() const override;
    std::string driver() const override;

private:
    using ResetStatus = unsigned (*)();

    void try_open();
    bool measure();
    void take(const SDL_Event& event);
    void tell_window();
    void look_at_connectors();
    void take_pending();
    void sleep(double most_s);

    WindowOptions options_;
    std::filesystem::path connectors_folder_;
    std::mutex video_;                  ///< held while SDL's video comes or goes: post() is another thread's
    std::unique_ptr<SdlWindow> window_; ///< none only while there is no display
    std::optional<SdlInput> input_;
    PxSize surface_;
    double px_per_mm_ = 0;
    ResetStatus reset_status_ = nullptr; ///< glGetGraphicsResetStatus, where it is there
    bool sleeps_in_sdl_ = false;         ///< the driver waits for events without polling
    bool lost_ = false, loss_told_ = false, resized_ = false, back_ = false;
    std::optional<Connectors> connectors_; ///< none where SDL tells of displays
    bool unplugged_ = false;
    double looked_s_ = 0;       ///< at the connectors
    std::vector<Event> events_; ///< of the last wait()

    std::mutex mutex_; ///< guards posted_
    std::vector<Event> posted_;
    InputWait input_wait_;
};

} // namespace metamer
