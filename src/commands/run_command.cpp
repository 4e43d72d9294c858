// metamer run: the kiosk.
#include <csignal>
#include <ctime>
#include <memory>
#include <optional>

#include "base/files.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "kiosk/kiosk.h"
#include "kiosk/outlet.h"
#include "service/notify.h"
#include "service/signals.h"

namespace metamer {

namespace {

struct Options {
    ExhibitArguments exhibit;
    std::optional<std::string> size;
    std::string description;
    bool wait = false;
};

int local_minute_of_day() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return 60 * local.tm_hour + local.tm_min;
}

class Run {
public:
    explicit Run(const Options& options) : options_(options) {}

    /// From the first load to the end.
    void live();

private:
    std::unique_ptr<Loaded> load();
    bool still_waiting(const std::string& error);
    WindowOptions window_of(const Exhibit& exhibit);
    KioskParts parts(std::unique_ptr<Loaded>& first);

    const Options& options_;
    Log log_;
    Outlet outlet_;
    std::unique_ptr<Stage> stage_;
    OutsideWatch outside_{[this](Outside what) { outlet_.tell(what); }}; ///< goes first: it tells the others
};

std::unique_ptr<Loaded> Run::load() {
    // Watched before they are read: what is changed from then on is told, and so is what mends a refused one.
    if (!outside_.watch(exhibit_files(options_.exhibit.path, options_.exhibit.sets)))
        log_.write(Priority::warning, "not_watched", {{"exhibit", options_.exhibit.path}});
    std::vector<std::string> doubts;
    Exhibit exhibit = at_size(options_.exhibit, options_.size, [&](const ExhibitArguments& sized) {
        return metamer::load(sized, Use::kiosk, doubts);
    });
    for (const std::string& doubt : doubts)
        log_.write(Priority::notice, "doubt", {{"doubt", doubt}});
    Words words = words_of(exhibit);
    return std::make_unique<Loaded>(Loaded{std::move(exhibit), std::move(words)});
}

bool Run::still_waiting(const std::string& error) {
    notify_alive();
    notify_waiting();
    log_.write(Priority::warning, "no_display", {{"error", error}});
    return !outlet_.quit();
}

WindowOptions Run::window_of(const Exhibit& exhibit) {
    WindowOptions window;
    if (options_.size || !exhibit.kiosk.fullscreen) {
        window.width_px = exhibit.display.width_px;
        window.height_px = exhibit.display.height_px;
    }
    window.rotation_deg = exhibit.kiosk.rotation_deg;
    window.diagonal_in = exhibit.kiosk.diagonal_in;
    window.wait_for_display = options_.wait;
    window.still_waiting = [this](const std::string& error) { return still_waiting(error); };
    return window;
}

/// `first` is taken by the first load.
KioskParts Run::parts(std::unique_ptr<Loaded>& first) {
    KioskParts parts;
    parts.stage = stage_.get();
    parts.log = &log_;
    parts.load = [this, &first] { return first ? std::move(first) : load(); };
    parts.minute_of_day = local_minute_of_day;
    if (!options_.description.empty())
        parts.describe = [this](const std::string& text) { write_file(options_.description, text); };
    return parts;
}

void Run::live() {
    std::signal(SIGPIPE, SIG_IGN);          // a log that nobody reads any more is no reason to end
    std::unique_ptr<Loaded> first = load(); // what cannot be read is told before a window opens
    if (!options_.description.empty())
        check_output(options_.description);
    stage_ = open_window(window_of(first->exhibit));
    if (stage_) {
        outlet_.lead_to(*stage_);
        Kiosk kiosk(parts(first));
        while (!outlet_.quit() && kiosk.turn()) {
        }
    }
    notify_stopping();
    log_.end();
    log_.write(Priority::info, "stopped");
}

} // namespace

void add_run_command(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("run", "the kiosk, full screen");
    add_exhibit_arguments(*command, options->exhibit);
    command->add_option("--size", options->size, "a window of this many pixels instead, e.g. 1280x720")
        ->type_name("WxH");
    command->add_flag("--wait", options->wait, "where there is no display, wait for one");
    command
        ->add_option("--describe", options->description,
                     "write what is on the screen there, as JSON, whenever it changes")
        ->type_name("F.json");
    command->callback([options] { Run(*options).live(); });
}

} // namespace metamer
