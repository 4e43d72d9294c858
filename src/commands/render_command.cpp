// metamer render: one frame of an exhibit as a PNG, without any display.
#include <iostream>
#include <memory>
#include <optional>

#include "base/error.h"
#include "base/files.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/half_table.h"
#include "gles/info.h"
#include "gles/surfaceless.h"
#include "render/frame.h"

namespace metamer {

namespace {

struct Options {
    ExhibitArguments exhibit;
    std::string output;
    std::optional<std::string> size;
    bool table = false;
};

void run(const Options& options) {
    const Exhibit exhibit =
        at_size(options.exhibit, options.size, [](const ExhibitArguments& sized) { return load(sized); });
    check_output(options.output);
    const std::string table = options.table ? half_table(exhibit) : "";
    const Surfaceless context;
    const Image image = render_frame(exhibit);
    write_file(options.output, encode_frame(image, exhibit));
    std::cout << options.output << ": " << image.width << " x " << image.height << " px, drawn by "
              << gl_renderer() << '\n'
              << table;
}

} // namespace

void add_render_command(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("render", "one frame as a PNG, without any display");
    add_exhibit_arguments(*command, options->exhibit);
    command->add_option("-o,--output", options->output, "the PNG to write")->required()->type_name("F.png");
    command->add_option("--size", options->size, "pixels, e.g. 1280x720 (default: the exhibit's)")
        ->type_name("WxH");
    command->add_flag("--table", options->table,
                      "also print, for each of the thesis's fifteen lamps, how far the two halves part");
    command->callback([options] { run(*options); });
}

} // namespace metamer
