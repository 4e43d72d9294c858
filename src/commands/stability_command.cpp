// metamer stability: where each method fails, why, and what the program does about it.
#include <filesystem>
#include <iostream>
#include <memory>

#include "base/error.h"
#include "base/files.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "report/picture.h"
#include "report/stability.h"

namespace metamer {

namespace {

namespace fs = std::filesystem;

struct Options {
    std::string folder;
    bool json = false;
};

// Before seconds are spent on experiments.
void make_folder(const fs::path& folder) {
    if (folder.empty())
        throw bad_input("write", "\"\"", "it names no folder");
    std::error_code ec;
    if (fs::is_directory(folder, ec))
        return;
    if (fs::exists(folder, ec))
        throw bad_input("write", folder.string(), "it is no folder");
    if (!fs::create_directory(folder, ec))
        throw bad_input("write", folder.string(), "no folder can be made there: " + ec.message());
}

struct File {
    fs::path path;
    std::string bytes;
};

// Everything is drawn before anything is written: what cannot be drawn leaves no files.
std::vector<File> files_of(const fs::path& folder, const std::vector<Experiment>& experiments) {
    std::vector<File> files{{folder / "stability.csv", stability_csv(experiments)}};
    for (const StabilityPage& page : stability_pages(experiments)) {
        files.push_back({folder / (page.file + ".svg"), picture_svg(page.picture)});
        files.push_back({folder / (page.file + ".png"), picture_png(page.picture)});
    }
    return files;
}

void run(const Options& options, bool writes) {
    if (writes)
        make_folder(options.folder);
    const std::vector<Experiment> experiments = stability_experiments();
    if (writes)
        for (const File& file : files_of(options.folder, experiments))
            write_file(file.path, file.bytes);
    std::cout << (options.json ? experiments_json(experiments) : stability_text(experiments));
}

} // namespace

void add_stability_command(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("stability", "where each method fails, why, and what is done about it");
    CLI::Option* output =
        command
            ->add_option(
                "-o,--output", options->folder,
                "also write the curves there: pages as SVG and PNG, and stability.csv; the folder is "
                "made if it is missing")
            ->type_name("DIR");
    command->add_flag("--json", options->json, "print one JSON document");
    command->callback([options, output] { run(*options, output->count() > 0); });
}

} // namespace metamer
