#include "window/sdl_stage.h"

#include <GLES2/gl2.h>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "base/error.h"
#include "gles/extensions.h"
#include "window/sdl_setup.h"

namespace metamer {

namespace {

constexpr auto kBetweenQuestions = std::chrono::milliseconds(100);
constexpr int kQuestionsPerTry = 10;

/// How late a display may be seen to come and go where only its connector tells.
constexpr double kBetweenLooks_s = 1;

unsigned (*reset_status())() {
    for (const auto& [extension, function] : {std::pair{"GL_KHR_robustness", "glGetGraphicsResetStatusKHR"},
                                              std::pair{"GL_EXT_robustness", "glGetGraphicsResetStatusEXT"}})
        if (use_gl_extension(extension))
            if (void* found = SDL_GL_GetProcAddress(function))
                return reinterpret_cast<unsigned (*)()>(found);
    return nullptr;
}

/// SDL_WaitEventTimeout of SDL 2.26 blocks with these and asks every millisecond with all others.
bool waits_for_events(const std::string& driver) {
    return driver == "x11" || driver == "wayland";
}

} // namespace

SdlStage::SdlStage(const WindowOptions& options, std::filesystem::path connectors)
    : options_(options), connectors_folder_(std::move(connectors)) {
    prepare_sdl(options.width_px == 0);
    if (SDL_InitSubSystem(SDL_INIT_EVENTS) != 0)
        throw failure("open", "a window", std::string("SDL events: ") + SDL_GetError());
}

SdlStage::~SdlStage() {
    window_.reset();
    SDL_QuitSubSystem(SDL_INIT_EVENTS);
}

bool SdlStage::open() {
    for (;;) {
        std::string error;
        try {
            try_open();
            return true;
        } catch (const Error& no_display) {
            if (!options_.wait_for_display)
                throw;
            error = no_display.what();
        }
        for (int i = 0; i < kQuestionsPerTry; ++i) {
            if (options_.still_waiting && !options_.still_waiting(error))
                return false;
            std::this_thread::sleep_for(kBetweenQuestions);
        }
    }
}

void SdlStage::try_open() {
    const std::lock_guard lock(video_);
    window_.reset();
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT); // of the old window; what was posted is in posted_
    window_ = SdlWindow::open(options_);
    back_ = input_ && !input_->seen();
    unplugged_ = false;
    SdlHost host = sdl_host();
    host.displays = [this, of_sdl = host.displays] { return unplugged_ ? 0 : of_sdl(); };
    input_.emplace(options_.rotation_deg, std::move(host));
    lost_ = loss_told_ = false;
    reset_status_ = reset_status();
    sleeps_in_sdl_ = waits_for_events(driver());
    connectors_.reset();
    if (!sleeps_in_sdl_)
        connectors_.emplace(connectors_folder_);
    const bool again = surface_ != PxSize{};
    resized_ = measure() && again;
}

/// Returns whether the surface has another size.
bool SdlStage::measure() {
    const PxSize before = surface_;
    surface_ = window_->surface_size();
    px_per_mm_ = window_->px_per_mm(options_.diagonal_in);
    input_->set_sizes(surface_, window_->window_size());
    return surface_ != before;
}

void SdlStage::hang(int rotation_deg, double diagonal_in) {
    options_.rotation_deg = rotation_deg;
    options_.diagonal_in = diagonal_in;
    input_->set_rotation(rotation_deg);
    resized_ = measure() || resized_;
}

const std::vector<Event>& SdlStage::wait(double most_s) {
    const double until_s = most_s < 0 ? std::numeric_limits<double>::infinity() : now_s() + most_s;
    events_.clear();
    take_pending();
    for (double left_s; events_.empty() && (left_s = until_s - now_s()) > 0;) {
        sleep(left_s);
        take_pending();
    }
    return events_;
}

void SdlStage::sleep(double most_s) {
    if (sleeps_in_sdl_) {
        // Rounded up: a rest below a millisecond is not to be waited for in circles.
        const int most_ms =
            std::isinf(most_s) ? -1 : static_cast<int>(std::ceil(std::min(most_s, 1e6) * 1e3));
        SDL_Event event;
        if (SDL_WaitEventTimeout(&event, most_ms) == 1)
            take(event);
    } else {
        input_wait_.sleep(std::min(most_s, kBetweenLooks_s));
    }
}

void SdlStage::take(const SDL_Event& event) {
    const bool sized =
        event.type == SDL_WINDOWEVENT && (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED ||
                                          event.window.event == SDL_WINDOWEVENT_DISPLAY_CHANGED);
    resized_ = ((sized || event.type == SDL_DISPLAYEVENT) && measure()) || resized_;
    tell_window();
    input_->take(event, events_);
}

void SdlStage::tell_window() {
    if (std::exchange(resized_, false)) {
        const PxSize picture = turned(surface_, options_.rotation_deg);
        events_.emplace_back(ResizeEvent{picture.width_px, picture.height_px});
    }
    if (std::exchange(back_, false))
        events_.emplace_back(DisplayBackEvent{});
}

void SdlStage::look_at_connectors() {
    if (!connectors_ || now_s() < looked_s_ + kBetweenLooks_s)
        return;
    looked_s_ = now_s();
    if (!unplugged_ && connectors_->unplugged()) {
        unplugged_ = true;
        input_->look_for_display(events_);
    } else if (unplugged_ && connectors_->connected()) {
        lost_ = true; // another display has another mode, and takes another window
    }
}

void SdlStage::take_pending() {
    for (SDL_Event event; SDL_PollEvent(&event) == 1;)
        take(event);
    input_->cancel_lost(events_);
    tell_window();
    look_at_connectors();
    if (!loss_told_ && context_lost()) {
        loss_told_ = true;
        events_.emplace_back(ContextLostEvent{});
    }
    const std::lock_guard lock(mutex_);
    events_.insert(events_.end(), posted_.begin(), posted_.end());
    posted_.clear();
}

void SdlStage::post(const Event& event) {
    {
        const std::lock_guard lock(mutex_);
        posted_.push_back(event);
    }
    input_wait_.wake();
    const std::lock_guard lock(video_);
    static const Uint32 wake = SDL_RegisterEvents(1);
    SDL_Event woken{};
    woken.type = wake;
    SDL_PushEvent(&woken); // where the queue is full, nobody sleeps
}

void SdlStage::bind() {
    lost_ = !window_->keep_current() || lost_;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, surface_.width_px, surface_.height_px);
}

void SdlStage::show() {
    lost_ = !window_->show() || lost_;
}

bool SdlStage::context_lost() {
    // Asked again after the reset is over, GL says that nothing is wrong.
    lost_ = lost_ || (reset_status_ != nullptr && reset_status_() != GL_NO_ERROR);
    return lost_;
}

double SdlStage::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string SdlStage::driver() const {
    const char* name = SDL_GetCurrentVideoDriver();
    return name == nullptr ? "" : name;
}

std::unique_ptr<Stage> open_window(const WindowOptions& options) {
    auto stage = std::make_unique<SdlStage>(options);
    return stage->open() ? std::move(stage) : nullptr;
}

} // namespace metamer
