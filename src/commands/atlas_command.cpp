// metamer atlas: building atlases from spectra, and showing them.
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "atlas/atlas_file.h"
#include "atlas/atlas_picture.h"
#include "atlas/atlas_table.h"
#include "base/error.h"
#include "base/files.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/spectrum_names.h"

namespace metamer {

namespace {

struct BuildOptions {
    std::vector<std::string> lamps, materials;
    std::string output;
    std::string quantization{name_of(Quantization::weighted)};
};

std::vector<std::string> quantization_names() {
    std::vector<std::string> names;
    for (const QuantizationName& known : kQuantizations)
        names.emplace_back(known.name);
    return names;
}

void build(const BuildOptions& options) {
    std::vector<std::string> warnings;
    Atlas atlas = empty_atlas(find_quantization(options.quantization).value());
    std::vector<Lamp> lamps;
    for (const std::string& name : expanded_lamps(options.lamps))
        add_lamp(atlas, lamps.emplace_back(find_lamp(name, ".", &warnings)));
    for (const std::string& name : expanded_materials(options.materials))
        add_material(atlas, find_material(name, ".", &warnings), lamps);
    warn(warnings);
    write_file(options.output, encode_atlas(atlas));
    std::cout << options.output << ": written\n";
}

struct ShowOptions {
    std::string file, picture;
    bool json = false;
};

void show(const ShowOptions& options) {
    const Atlas atlas = read_atlas(options.file);
    if (!options.picture.empty()) {
        ColorChunks color;
        color.srgb = true;
        write_file(options.picture, encode_png({picture(atlas), {{"Software", "Metamer"}}, color}, false));
    }
    if (options.json)
        print_json(nlohmann::ordered_json(describe_json(atlas)));
    else
        std::cout << describe(atlas);
}

} // namespace

void add_atlas_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("atlas", "the 64 x 64 picture that holds lamps and materials");
    command->require_subcommand(1);

    auto building = std::make_shared<BuildOptions>();
    CLI::App* sub = command->add_subcommand("build", "make an atlas of spectra");
    sub->add_option(
           "--lamps", building->lamps,
           "spectrum files (all columns, or FILE#COLUMN), library names, or the sets `thesis` and `all`")
        ->type_name("F.csv|NAME");
    sub->add_option("--materials", building->materials,
                    "spectrum files (all columns, or FILE#COLUMN), library names, or names of sets")
        ->type_name("F.csv|NAME");
    sub->add_option("--quantization", building->quantization,
                    "how levels are chosen: `weighted` keeps sums, `thesis` rounds each value")
        ->check(CLI::IsMember(quantization_names()))
        ->capture_default_str()
        ->type_name("NAME");
    sub->add_option("-o,--output", building->output, "the PNG to write")->required()->type_name("A.png");
    sub->callback([building] {
        if (building->lamps.empty() && building->materials.empty())
            throw bad_input("build", building->output, "there are neither --lamps nor --materials");
        check_output(building->output);
        build(*building);
    });

    auto showing = std::make_shared<ShowOptions>();
    sub = command->add_subcommand("show", "print an atlas: names, peaks, and its rows as small pictures");
    sub->add_option("atlas", showing->file, "the atlas")->required()->type_name("A.png");
    sub->add_option("--picture", showing->picture,
                    "also draw the rows, enlarged, in their wavelengths' colors")
        ->type_name("F.png");
    sub->add_flag("--json", showing->json, "print one JSON document");
    sub->callback([showing] { show(*showing); });
}

} // namespace metamer
