// metamer check: exhibits, languages, atlases and spectra: valid, or what is wrong and where.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "atlas/atlas_file.h"
#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "exhibit/ini.h"
#include "exhibit/load.h"
#include "kiosk/loaded.h"
#include "overlay/language_file.h"
#include "plan/half_view.h"
#include "spectra/csv.h"

namespace metamer {

namespace {

// Each returns what a valid file holds, in a few words.

std::string check_exhibit(const std::string& path, std::vector<std::string>& warnings) {
    const Exhibit exhibit = load_exhibit(path, {}, &warnings, Use::kiosk); // all that metamer run asks for
    half_views(exhibit);                                                   // an adaptation that cannot be
    words_of(exhibit);
    return "exhibit, " + counted(exhibit.objects.size(), "object") + ", " +
           counted(exhibit.lamps.size(), "lamp");
}

std::string check_language(const std::string& path) {
    const Language language = read_language(path);
    return "language, " + language.name + ", " + counted(language.words.size(), "word");
}

/// An exhibit's INI file and a language's are told apart by their sections.
bool is_language(const std::string& path) {
    const std::vector<IniSection> sections = parse_ini(read_file(path), path).sections;
    return std::ranges::find(sections, "language", &IniSection::name) != sections.end();
}

std::string check_ini(const std::string& path, std::vector<std::string>& warnings) {
    return is_language(path) ? check_language(path) : check_exhibit(path, warnings);
}

std::string check_atlas(const std::string& path) {
    const Atlas atlas = read_atlas(path);
    std::size_t lamps = 0, materials = 0;
    for (const AtlasLamp& lamp : atlas.lamps)
        lamps += lamp.name.empty() ? 0 : 1;
    for (const AtlasMaterial& material : atlas.materials)
        materials += material.name.empty() ? 0 : 1;
    return "atlas, " + counted(lamps, "lamp") + ", " + counted(materials, "material");
}

// The file does not say whether its values are powers or reflectances: everything a reflectance may be, a
// power may be.
std::string check_spectra(const std::string& path, std::vector<std::string>& warnings) {
    const SpectrumTable table = read_spectra(path, SpectrumKind::emission);
    std::string use = "for lamps and materials";
    try {
        read_spectra(path, SpectrumKind::reflectance);
    } catch (const Error& error) {
        use = "for lamps only: " + error.cause();
    }
    std::vector<std::string> doubts;
    for (const std::string& name : table.names)
        find_lamp(path + "#" + name, ".", &doubts);
    for (const std::string& doubt : doubts)
        warnings.push_back(doubt + " (if it is a lamp)");
    return "spectra, " + counted(table.names.size(), "column") + ", " + use;
}

std::string check_file(const std::string& path, std::vector<std::string>& warnings) {
    const std::string kind = lower_case(std::filesystem::path(path).extension().string());
    if (kind == ".ini")
        return check_ini(path, warnings);
    if (kind == ".png")
        return check_atlas(path);
    if (kind == ".csv" || kind == ".txt")
        return check_spectra(path, warnings);
    throw bad_input(
        "check", path,
        "its name ends in none of .ini (exhibit, language), .png (atlas), .csv and .txt (spectra)");
}

// All files are looked at, whatever is wrong with the first.
void run(const std::vector<std::string>& files) {
    std::size_t wrong = 0;
    for (const std::string& file : files) {
        std::vector<std::string> warnings;
        try {
            const std::string what = check_file(file, warnings);
            warn(warnings);
            std::cout << file << ": valid " << what << '\n';
        } catch (const Error& error) {
            if (error.status() != Exit::bad_input || files.size() == 1)
                throw;
            std::cerr << "metamer: " << error.what() << '\n';
            ++wrong;
        }
    }
    if (wrong > 0)
        throw bad_input("accept", std::to_string(wrong) + " of " + std::to_string(files.size()) + " files",
                        "see above");
}

} // namespace

void add_check_command(CLI::App& app) {
    auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* command = app.add_subcommand(
        "check", "exhibits, languages, atlases, spectra: valid, or what is wrong and where");
    command
        ->add_option("files", *files, "exhibits and languages (.ini), atlases (.png), spectra (.csv, .txt)")
        ->required()
        ->type_name("FILE...");
    command->callback([files] { run(*files); });
}

} // namespace metamer
