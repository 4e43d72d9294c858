// metamer chart: speed against accuracy, how cost grows, what old GPUs could draw.
#include <algorithm>
#include <ctime>
#include <iostream>
#include <map>
#include <memory>

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "commands/command_line.h"
#include "commands/commands.h"
#include "commands/spectrum_names.h"
#include "gles/surfaceless.h"
#include "report/chart_exhibits.h"
#include "report/chart_measure.h"
#include "report/chart_table.h"
#include "report/growth_measure.h"
#include "report/paper.h"
#include "report/picture.h"
#include "spectra/library.h"

namespace metamer {

namespace {

constexpr int kRounds = 21, kMostRounds = 1001;

struct Options {
    ExhibitArguments exhibit;
    std::vector<std::string> outputs, lamps, materials;
    std::string from, paper;
    int rounds = kRounds;
    bool growth = false;
};

/// A chart of any kind, in all its forms.
struct Forms {
    std::string table, csv, json;
    Picture picture;
};

std::string ending_of(const std::string& path) {
    return lower_case(std::filesystem::path(path).extension().string());
}

void check_outputs(const Options& options) {
    for (const std::string& path : options.outputs) {
        check_output(path);
        const std::string ending = ending_of(path);
        if (ending != ".svg" && ending != ".png" && ending != ".csv" && ending != ".json")
            throw bad_input("write", path, "a chart ends in .svg, .png, .csv or .json");
    }
}

void write(const Forms& forms, const std::vector<std::string>& outputs) {
    for (const std::string& path : outputs) {
        if (ending_of(path) == ".csv")
            write_file(path, forms.csv);
        else if (ending_of(path) == ".json")
            write_file(path, forms.json);
        else
            write_picture(path, forms.picture);
    }
    std::cout << forms.table;
    for (const std::string& path : outputs)
        std::cout << path << " is written\n";
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[16];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

std::string file_name(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

/// What was asked for, without the places of files.
std::string command_of(const Options& options) {
    std::string out = "metamer chart";
    if (options.growth)
        out += " --growth";
    if (!options.exhibit.path.empty())
        out += " " + file_name(options.exhibit.path);
    for (const std::string& set : options.exhibit.sets)
        out += " --set " + set;
    for (const std::string& lamp : options.lamps)
        out += " --lamps " + file_name(lamp);
    for (const std::string& material : options.materials)
        out += " --materials " + file_name(material);
    return out;
}

std::string title_of(const Exhibit& exhibit) {
    return std::filesystem::path(exhibit.place).stem().string();
}

std::string without_folder(const std::string& name) {
    const auto hash = std::min(name.find('#'), name.size());
    return file_name(name.substr(0, hash)) + name.substr(hash);
}

/// Spectra of files by their files' names, without folders, where that still tells them apart.
template <class Spectrum>
void drop_folders(std::vector<Spectrum>& spectra) {
    std::map<std::string, int> count;
    for (const Spectrum& spectrum : spectra)
        ++count[lower_case(without_folder(spectrum.name))];
    for (Spectrum& spectrum : spectra)
        if (count[lower_case(without_folder(spectrum.name))] == 1)
            spectrum.name = without_folder(spectrum.name);
}

/// The lamps and materials asked for, those of the exhibit where nothing is; as one-lamp exhibits.
std::vector<Exhibit> pairs_of(const Options& options, const Exhibit& exhibit) {
    if (options.lamps.empty() && options.materials.empty())
        return {};
    std::vector<std::string> warnings;
    std::vector<Lamp> lamps;
    for (const std::string& name : expanded_lamps(options.lamps))
        lamps.push_back(find_lamp(name, ".", &warnings));
    std::vector<Material> materials;
    for (const std::string& name : expanded_materials(options.materials))
        materials.push_back(find_material(name, ".", &warnings));
    warn(warnings);
    drop_folders(lamps);
    drop_folders(materials);
    if (lamps.empty())
        for (const LampSetting& lamp : exhibit.lamps)
            lamps.push_back(lamp.lamp);
    if (materials.empty())
        for (const auto& [key, material] : exhibit.materials)
            materials.push_back(material);
    return pair_exhibits(lamps, materials, exhibit.display);
}

Forms forms_of(const Chart& chart) {
    return {chart_table(chart), chart_csv(chart), chart_json(chart), chart_picture(chart)};
}

Forms forms_of(const Growth& growth) {
    return {growth_table(growth), growth_csv(growth), growth_json(growth),
            cost_picture(cost_panels(growth), growth.context, 1600, 1500)};
}

Forms forms_of(const Paper& paper) {
    return {paper_table(paper), paper_csv(paper), paper_json(paper), paper_picture(paper)};
}

Forms measured(const Options& options) {
    const Exhibit exhibit = load(options.exhibit);
    const std::vector<Exhibit> pairs = pairs_of(options, exhibit);
    const Surfaceless context;
    if (options.growth) {
        Growth growth = measure_growth(exhibit.display, options.rounds);
        growth.context.date = today();
        growth.context.command = command_of(options);
        return forms_of(growth);
    }
    Chart chart = measure_chart(exhibit, pairs, options.rounds);
    chart.context.exhibit = title_of(exhibit);
    chart.context.date = today();
    chart.context.command = command_of(options);
    return forms_of(chart);
}

Forms drawn_again(const Options& options) {
    if (!options.paper.empty())
        return forms_of(read_paper_csv(read_file(options.paper), options.paper));
    const std::string text = read_file(options.from);
    return options.growth ? forms_of(read_growth_csv(text, options.from))
                          : forms_of(read_chart_csv(text, options.from));
}

void run(const Options& options) {
    check_outputs(options);
    const bool measures = options.from.empty() && options.paper.empty();
    write(measures ? measured(options) : drawn_again(options), options.outputs);
}

} // namespace

void add_chart_command(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("chart", "speed against accuracy, every method measured");
    add_exhibit_arguments(*command, options->exhibit);
    CLI::Option* exhibit = command->get_option("exhibit");
    CLI::Option* set = command->get_option("--set");
    command->add_option("-o,--output", options->outputs, "where to, several times for several files")
        ->required()
        ->type_name("F.{svg,png,csv,json}")
        ->take_all()
        ->allow_extra_args(false);
    CLI::Option* rounds =
        command->add_option("--rounds", options->rounds, "how often each frame is timed (default: 21)")
            ->check(CLI::Range(1, kMostRounds));
    CLI::Option* lamps = command->add_option(
        "--lamps", options->lamps,
        "accuracy over these lamps instead of the exhibit's: names, files, `all`, `thesis`");
    CLI::Option* materials =
        command->add_option("--materials", options->materials, "likewise materials: names, files, sets");
    CLI::Option* growth =
        command->add_flag("--growth", options->growth,
                          "chart how cost grows with wavelengths, lamps, materials, objects, pixels");
    CLI::Option* from =
        command->add_option("--from", options->from, "draw again from a CSV of this command, measure nothing")
            ->type_name("F.csv");
    CLI::Option* paper = command
                             ->add_option("--paper", options->paper,
                                          "chart old GPUs' frame rates, from a CSV of instruction counts")
                             ->type_name("F.csv");
    for (CLI::Option* measuring : {exhibit, set, rounds, lamps, materials})
        for (CLI::Option* drawing : {from, paper})
            drawing->excludes(measuring);
    paper->excludes(from)->excludes(growth);
    growth->excludes(lamps)->excludes(materials);
    command->callback([options] { run(*options); });
}

} // namespace metamer
