// metamer list: what has a name.
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "color/working_space.h"
#include "commands/commands.h"
#include "exhibit/scene_kinds.h"
#include "methods/method.h"
#include "spectra/library.h"

namespace metamer {

namespace {

void print_row(std::string_view name, std::string_view description) {
    std::cout << name << std::string(name.size() < 24 ? 24 - name.size() : 1, ' ') << description << '\n';
}

void list_lamps() {
    for (const Lamp& lamp : library_lamps())
        print_row(lamp.name, lamp.description);
    std::cout << "\nBy formula: planck:KELVIN, daylight:KELVIN, gauss:CENTER_NM:FWHM_NM, line:NM. "
                 "By file: FILE.csv, FILE.csv#COLUMN\n";
}

void list_materials() {
    for (const MaterialSet& set : material_sets()) {
        std::cout << '[' << set.name << "] " << set.description << '\n';
        for (const std::string& name : set.materials)
            print_row("  " + name, find_material(name).description);
        std::cout << '\n';
    }
    std::cout << "By formula: rgb:RRGGBB, gauss:CENTER_NM:FWHM_NM, "
                 "absorb:CENTER_NM:FWHM_NM:DENSITY... By file: FILE.csv, FILE.csv#COLUMN\n";
}

void list_spaces() {
    for (const WorkingSpace& space : working_spaces())
        print_row(space.name, space.description);
}

void list_methods() {
    for (const MethodInfo& method : kMethods)
        print_row(method.name, method.description);
}

void list_scenes() {
    for (const SceneKindInfo& scene : scene_kinds())
        print_row(scene.name, scene.description);
}

} // namespace

void add_list_command(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("list", "what has a name: lamps, materials, spaces, methods, scenes");
    command->require_subcommand(1);
    command->add_subcommand("lamps", "the library's lamps")->callback(list_lamps);
    command->add_subcommand("materials", "the library's materials, set by set")->callback(list_materials);
    command->add_subcommand("spaces", "RGB working spaces")->callback(list_spaces);
    command->add_subcommand("methods", "ways from spectra to XYZ")->callback(list_methods);
    command->add_subcommand("scenes", "kinds of scene")->callback(list_scenes);
}

} // namespace metamer
