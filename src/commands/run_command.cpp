// metamer run: the kiosk.
#include <atomic>
#include <ctime>
#include <memory>
#include <optional>

#include "base/files.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "kiosk/kiosk.h"
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

std::unique_ptr<Loaded> load_kiosk(const Options& options) {
    Exhibit exhibit = at_size(options.exhibit, options.size,
                              [](const ExhibitArguments& sized) { return load(sized, Use::kiosk); });
    Words words = words_of(exhibit);
    return std::make_unique<Loaded>(Loaded{std::move(exhibit), std::move(words)});
}

WindowOptions window_of(const Options& options, const Exhibit& exhibit) {
    WindowOptions window;
    if (options.size || !exhibit.kiosk.fullscreen) {
        window.width_px = exhibit.display.width_px;
        window.height_px = exhibit.display.height_px;
    }
    window.rotation_deg = exhibit.kiosk.rotation_deg;
    window.diagonal_in = exhibit.kiosk.diagonal_in;
    window.wait_for_display = options.wait;
    return window;
}

int local_minute_of_day() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return 60 * local.tm_hour + local.tm_min;
}

/// What the outside tells: to the stage, once there is one.
struct Outlet {
    std::atomic<Stage*> stage{nullptr};
    std::atomic<bool> quit{false};

    void tell(Outside what) {
        if (what == Outside::quit)
            quit = true;
        if (Stage* told = stage)
            told->post(what == Outside::quit     ? Event(QuitEvent{})
                       : what == Outside::reload ? Event(ReloadEvent{})
                                                 : Event(FilesChangedEvent{}));
    }
};

void run(const Options& options) {
    std::unique_ptr<Loaded> first = load_kiosk(options); // what cannot be read is told before a window opens
    if (!options.description.empty())
        check_output(options.description);
    Log log;
    Outlet outlet;
    std::unique_ptr<Stage> stage;
    OutsideWatch outside([&](Outside what) { outlet.tell(what); });
    WindowOptions window = window_of(options, first->exhibit);
    window.still_waiting = [&](const std::string& error) {
        notify_alive();
        notify_waiting();
        log.write(Priority::warning, "no_display", {{"error", error}});
        return !outlet.quit;
    };
    stage = open_window(window);
    if (stage) {
        outlet.stage = stage.get();
        KioskParts parts;
        parts.stage = stage.get();
        parts.log = &log;
        parts.load = [&] { return first ? std::move(first) : load_kiosk(options); };
        parts.loaded = [&](const Loaded& loaded) {
            if (!outside.watch(loaded.exhibit.files))
                log.write(Priority::warning, "not_watched", {{"exhibit", loaded.exhibit.place}});
        };
        parts.minute_of_day = local_minute_of_day;
        if (!options.description.empty())
            parts.describe = [&](const std::string& text) { write_file(options.description, text); };
        Kiosk kiosk(std::move(parts));
        while (!outlet.quit && kiosk.turn()) {
        }
    }
    notify_stopping();
    log.write(Priority::info, "stopped");
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
    command->callback([options] { run(*options); });
}

} // namespace metamer
