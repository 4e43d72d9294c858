#include "service/signals.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <thread>

#include "base/error.h"
#include "service/path_watch.h"

namespace metamer {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kQuiet = std::chrono::milliseconds(100); ///< after the last change of a burst
constexpr auto kMost = std::chrono::milliseconds(500);  ///< after its first

sigset_t told_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP})
        sigaddset(&signals, signal);
    return signals;
}

/// A thread's signal mask for as long as this lives.
class Blocked {
public:
    explicit Blocked(const sigset_t& signals) { pthread_sigmask(SIG_BLOCK, &signals, &before_); }
    Blocked(const Blocked&) = delete;
    Blocked& operator=(const Blocked&) = delete;
    ~Blocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

private:
    sigset_t before_{};
};

int checked(int descriptor, const char* call) {
    if (descriptor < 0)
        throw failure("watch", "signals", std::string(call) + ": " + std::strerror(errno));
    return descriptor;
}

/// Several changes that follow each other.
class Burst {
public:
    void change(Clock::time_point now) {
        if (!due_)
            latest_ = now + kMost;
        due_ = std::min(now + kQuiet, latest_);
    }
    void end() { due_.reset(); }
    /// When it is to be told; none: nothing changed.
    const std::optional<Clock::time_point>& due() const { return due_; }

private:
    std::optional<Clock::time_point> due_;
    Clock::time_point latest_;
};

} // namespace

class OutsideWatch::Body {
public:
    explicit Body(Tell tell)
        : tell_(std::move(tell)),
          blocked_(told_signals()),
          signals_(checked(signalfd(-1, &kSignals, SFD_NONBLOCK | SFD_CLOEXEC), "signalfd")),
          end_(checked(eventfd(0, EFD_CLOEXEC), "eventfd")) {
        // The thread inherits a mask: nothing that the process catches is to be caught in it.
        sigset_t all;
        sigfillset(&all);
        const Blocked while_starting(all);
        thread_ = std::thread([this] { run(); });
    }
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;
    ~Body() {
        eventfd_write(end_.get(), 1);
        thread_.join();
        // One more SIGTERM while the first is obeyed must not kill once the mask is lifted.
        take_signals();
    }

    bool watch(std::span<const std::filesystem::path> files) { return paths_.set(files); }

private:
    void run() {
        Burst burst;
        for (;;) {
            std::array<pollfd, 3> awaited{pollfd{end_.get(), POLLIN, 0}, pollfd{signals_.get(), POLLIN, 0},
                                          pollfd{paths_.descriptor(), POLLIN, 0}};
            poll(awaited.data(), awaited.size(), milliseconds_until(burst.due()));
            if (awaited[0].revents != 0)
                return;
            for (const Outside told : take_signals())
                tell_(told);
            if (paths_.take_changes())
                burst.change(Clock::now());
            if (burst.due() && Clock::now() >= *burst.due()) {
                burst.end();
                // Before it is told: what changes from here on finds new folders watched.
                paths_.look_again();
                tell_(Outside::changed);
            }
        }
    }

    /// For poll(2): rounded up, -1 for never.
    static int milliseconds_until(std::optional<Clock::time_point> due) {
        if (!due)
            return -1;
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(*due - Clock::now());
        return static_cast<int>(std::max<std::chrono::milliseconds::rep>(left.count(), 0));
    }

    std::vector<Outside> take_signals() {
        std::vector<Outside> told;
        for (signalfd_siginfo info{}; read(signals_.get(), &info, sizeof info) == sizeof info;)
            told.push_back(info.ssi_signo == SIGHUP ? Outside::reload : Outside::quit);
        return told;
    }

    inline static const sigset_t kSignals = told_signals();

    Tell tell_;
    PathWatch paths_;
    Blocked blocked_;
    Descriptor signals_, end_;
    std::thread thread_;
};

OutsideWatch::OutsideWatch(Tell tell) : body_(std::make_unique<Body>(std::move(tell))) {}

OutsideWatch::~OutsideWatch() = default;

bool OutsideWatch::watch(std::span<const std::filesystem::path> files) {
    return body_->watch(files);
}

} // namespace metamer
