// metamer measure: a lamp and a material by every method, CPU and GPU.
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/measurement.h"
#include "gles/surfaceless.h"

namespace metamer {

namespace {

struct Options {
    std::string lamp, material;
    ExhibitArguments exhibit;
    bool json = false;
};

nlohmann::ordered_json to_json(const Xyz& c) {
    return {c.x, c.y, c.z};
}

nlohmann::ordered_json to_json(const EncodedRgb8& c) {
    return {c.r, c.g, c.b};
}

nlohmann::ordered_json to_json(const Measurement& m) {
    auto methods = nlohmann::ordered_json::array();
    for (const MethodMeasurement& row : m.methods)
        methods.push_back({{"name", method_name(row.method)},
                           {"xyz", to_json(row.xyz)},
                           {"delta_e_2000", row.delta_e_2000},
                           {"cpu_rgb8", to_json(row.cpu_rgb8)},
                           {"gpu_rgb8", to_json(row.gpu_rgb8)}});
    return {{"lamp", m.lamp},
            {"material", m.material},
            {"reference", {{"xyz", to_json(m.reference)}}},
            {"methods", methods}};
}

void print_row(const char* name, const Xyz& c) {
    std::printf("%-12s %8.5f %8.5f %8.5f", name, c.x, c.y, c.z);
}

void print_text(const Measurement& m) {
    std::printf("%s on %s\n%-12s %8s %8s %8s  %10s  %-12s %s\n", m.material.c_str(), m.lamp.c_str(), "method",
                "X", "Y", "Z", "CIEDE2000", "CPU RGB", "GPU RGB");
    print_row("reference", m.reference);
    std::printf("\n");
    for (const MethodMeasurement& row : m.methods) {
        print_row(std::string(method_name(row.method)).c_str(), row.xyz);
        std::printf("  %10.4f  %3d %3d %3d  %3d %3d %3d\n", row.delta_e_2000, row.cpu_rgb8.r, row.cpu_rgb8.g,
                    row.cpu_rgb8.b, row.gpu_rgb8.r, row.gpu_rgb8.g, row.gpu_rgb8.b);
    }
}

void run(const Options& options) {
    std::vector<std::string> warnings;
    const Lamp lamp = find_lamp(options.lamp, ".", &warnings);
    const Material material = find_material(options.material, ".", &warnings);
    warn(warnings);
    const Display display = options.exhibit.path.empty() ? Display{} : load(options.exhibit).display;
    const Surfaceless context;
    const Measurement measurement = measure(lamp, material, display);
    if (options.json)
        print_json(to_json(measurement));
    else
        print_text(measurement);
}

} // namespace

void add_measure_command(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("measure", "a pair of lamp and material by every method, CPU and GPU");
    command->add_option("--lamp", options->lamp, "library name, formula, FILE.csv or FILE.csv#COLUMN")
        ->required();
    command->add_option("--material", options->material, "library name, formula, FILE.csv or FILE.csv#COLUMN")
        ->required();
    command
        ->add_option("--exhibit", options->exhibit.path,
                     "take working space, transfer curve and adaptation from here")
        ->type_name("E.ini");
    command->add_flag("--json", options->json, "print one JSON document");
    command->callback([options] { run(*options); });
}

} // namespace metamer
