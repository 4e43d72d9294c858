// metamer plan: which method draws which object, and why.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands/command_line.h"
#include "commands/commands.h"
#include "gles/surfaceless.h"
#include "plan/planner.h"
#include "render/frame_renderer.h"

namespace metamer {

namespace {

struct Options {
    ExhibitArguments exhibit;
    std::string precision;
    bool json = false;
};

int bits_of(const std::string& precision) {
    if (precision == "fp16")
        return kHalfBits;
    if (precision == "fp32")
        return kSingleBits;
    const Surfaceless context;
    return measured_bits();
}

std::string half_name(const Plan& plan, std::size_t half) {
    return plan.halves.size() == 1 ? "whole" : half == 0 ? "left" : "right";
}

std::vector<std::string> lamps_of(const HalfPlan& half) {
    std::vector<std::string> names(half.view.lamps.size());
    for (const HalfLamp& lamp : half.view.lamps) // in the exhibit's order, not that of shadows
        names[lamp.setting] = lamp.name;
    return names;
}

nlohmann::ordered_json to_json(const Plan& plan) {
    auto objects = nlohmann::ordered_json::array();
    for (std::size_t h = 0; h < plan.halves.size(); ++h)
        for (const ObjectPlan& object : plan.halves[h].objects) {
            nlohmann::ordered_json row{{"object", object.object},
                                       {"half", half_name(plan, h)},
                                       {"lamps", lamps_of(plan.halves[h])},
                                       {"method", method_name(object.method)}};
            if (object.method == Method::reduced)
                row["taps"] = object.taps.wavelength_nm.size();
            row.update({{"why", in_english(object.why)},
                        {"delta_e_2000_bound", object.delta_e_bound},
                        {"worst", in_english(object.worst)},
                        {"cost_ratio", object.cost_ratio},
                        {"asked", object.asked}});
            objects.push_back(row);
        }
    return {{"objects", objects}, {"tolerance", plan.tolerance}, {"fragment_bits", plan.fragment_bits}};
}

void print_text(const Plan& plan) {
    std::printf("tolerance %g CIEDE2000; fragment shaders compute with %d bits\n", plan.tolerance,
                plan.fragment_bits);
    for (std::size_t h = 0; h < plan.halves.size(); ++h) {
        const HalfPlan& half = plan.halves[h];
        std::string lamps;
        for (const std::string& name : lamps_of(half))
            lamps += (lamps.empty() ? "" : ", ") + name;
        std::printf("\n%s, lit by %s\n%-16s %-12s %9s %6s  %s\n", half_name(plan, h).c_str(), lamps.c_str(),
                    "object", "method", "CIEDE2000", "cost", "why");
        for (const ObjectPlan& object : half.objects) {
            const std::string taps = object.method == Method::reduced
                                         ? " " + std::to_string(object.taps.wavelength_nm.size())
                                         : "";
            std::printf("%-16s %-12s %9.4f %6.2f  %s\n", object.object.c_str(),
                        (std::string(method_name(object.method)) + taps).c_str(), object.delta_e_bound,
                        object.cost_ratio, in_english(object.why).c_str());
        }
    }
}

void run(const Options& options) {
    const Exhibit exhibit = load(options.exhibit);
    const Plan plan = plan_exhibit(exhibit, ExhibitSpectra(exhibit), bits_of(options.precision));
    if (options.json)
        print_json(to_json(plan));
    else
        print_text(plan);
}

} // namespace

void add_plan_command(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("plan", "which method draws which object, and why");
    add_exhibit_arguments(*command, options->exhibit);
    command
        ->add_option("--precision", options->precision,
                     "plan for a GPU that computes so, without asking this one: fp16 or fp32")
        ->check(CLI::IsMember({"fp16", "fp32"}));
    command->add_flag("--json", options->json, "print one JSON document");
    command->callback([options] { run(*options); });
}

} // namespace metamer
