#include "plan/planner.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "color/difference.h"
#include "exhibit/scene_kinds.h"
#include "plan/cost.h"

namespace metamer {

namespace {

struct Candidate {
    Method method;
    int taps = 0;
    double cost = 0;
};

/// An object in a half with what every candidate is tried on.
struct Task {
    const Exhibit& exhibit;
    const ObjectSetting& object;
    const HalfView& view;
    const ExhibitSpectra& spectra;
    int fragment_bits;
    std::vector<NamedPixel> pixels;
    std::vector<Xyz> exact;
};

/// The taps of an object that carries maps serve any of its materials.
Taps taps_of(const Task& task, int count) {
    const Pixel pixel = pixel_of(task.exhibit, task.view, task.spectra, task.object, task.object.material);
    if (surface_of(task.exhibit, task.object, Method::reduced) != Surface::maps && !task.object.material_end)
        return taps_for(pixel, count);
    std::vector<std::vector<double>> own;
    for (const NamedPixel& sample : task.pixels)
        if (sample.lamps == task.pixels.front().lamps)
            own.push_back(full_values(sample.pixel.material));
    return taps_for(pixel, own, count);
}

/// Fills in delta_e_bound and worst; stops early above `enough`.
void find_bound(const Task& task, ObjectPlan& plan, double enough = 1e9) {
    Sight sight = sight_of(task.view, task.spectra);
    sight.output.adaptation = Matrix3::identity();
    for (std::size_t i = 0; i < task.pixels.size() && plan.delta_e_bound <= enough; ++i) {
        const NamedPixel& pixel = task.pixels[i];
        const Taps taps = plan.method == Method::reduced ? of_lamps(plan.taps, pixel.lamps) : Taps();
        sight.taps = &taps;
        const Xyz shown = shown_xyz(plan.method, pixel.pixel, sight, task.fragment_bits);
        const double difference = delta_e_2000(shown, task.exact[i]);
        // What is not a number at all is the worst that can be.
        if (!(difference <= plan.delta_e_bound)) {
            plan.delta_e_bound = difference == difference ? difference : 1e9;
            plan.worst = pixel.name;
        }
    }
}

ObjectPlan tried(const Task& task, const Candidate& candidate, double enough) {
    ObjectPlan plan;
    plan.object = task.object.name;
    plan.method = candidate.method;
    plan.cost_ratio = candidate.cost;
    if (candidate.method == Method::reduced)
        plan.taps = taps_of(task, candidate.taps);
    find_bound(task, plan, enough);
    return plan;
}

Candidate candidate(const Task& task, Method method, int taps) {
    const PixelWork work{.method = method,
                         .taps = taps,
                         .surface = surface_of(task.exhibit, task.object, method),
                         .lamps = static_cast<int>(task.view.lamps.size()),
                         .lit = !scene_kind(task.exhibit.scene).flat,
                         .mirrors = task.object.specular > 0};
    return {method, taps, cost_ratio(work)};
}

/// Whether light times the matrix stays a number in half precision, where the shader multiplies by one.
bool matrix_holds(const Task& task, Method method) {
    constexpr double kMostHalf = 65504;
    if (task.fragment_bits >= kFloatBits || method == Method::folded || method == Method::reduced)
        return true;
    for (const auto& row : rgb_from_numbers(method, task.view.output_of()).m)
        if (kMostLight * (std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2])) > kMostHalf)
            return false;
    return true;
}

bool can_be_drawn(const Task& task, Method method) {
    return can_draw(method, task.object.medium.has_value()) && matrix_holds(task, method);
}

/// Every way to draw the object, the cheapest first. A ramp in code values mixes something else.
std::vector<Candidate> candidates(const Task& task) {
    std::vector<Candidate> out;
    for (const Method method : {Method::folded, Method::rgb, Method::tristimulus, Method::prefiltered,
                                Method::reduced, Method::packed, Method::spectral}) {
        if (!can_be_drawn(task, method) || (method == Method::rgb && task.object.material_end))
            continue;
        if (method != Method::reduced)
            out.push_back(candidate(task, method, 0));
        else
            for (const int taps : kTapCounts)
                out.push_back(candidate(task, method, taps));
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    return out;
}

Ground ground_of(const Task& task, Method method) {
    switch (method) {
    case Method::folded:
        return surface_of(task.exhibit, task.object, method) == Surface::maps ? Ground::table
                                                                              : Ground::constant;
    case Method::rgb:
    case Method::tristimulus:
    case Method::prefiltered:
        return Ground::product;
    case Method::reduced:
        return task.object.medium ? Ground::thickness : Ground::taps;
    case Method::packed:
    case Method::spectral:
        break;
    }
    return Ground::all;
}

ObjectPlan chosen(const Task& task, double tolerance) {
    std::optional<Reason::Rejected> rejected;
    for (const Candidate& candidate : candidates(task)) {
        ObjectPlan plan = tried(task, candidate, tolerance);
        if (plan.delta_e_bound <= tolerance) {
            plan.why = {.ground = ground_of(task, plan.method),
                        .error = plan.delta_e_bound,
                        .taps = static_cast<int>(plan.taps.wavelength_nm.size()),
                        .worst = {},
                        .rejected = rejected};
            return plan;
        }
        rejected = {candidate.method, candidate.taps, plan.delta_e_bound};
    }
    ObjectPlan best;
    best.delta_e_bound = 1e10;
    for (const Candidate& candidate : candidates(task))
        if (ObjectPlan plan = tried(task, candidate, 1e9); plan.delta_e_bound < best.delta_e_bound)
            best = plan;
    throw bad_input("plan", "object \"" + task.object.name + "\" of " + task.exhibit.place,
                    "no method holds a CIEDE2000 of " + error_text(tolerance) + "; " +
                        std::string(method_name(best.method)) + " comes nearest and errs by " +
                        error_text(best.delta_e_bound) + " (" + in_english(best.worst) + ")");
}

ObjectPlan as_asked(const Task& task, Method method) {
    const std::string name(method_name(method));
    if (!can_be_drawn(task, method))
        throw bad_input("draw", "object \"" + task.object.name + "\" of " + task.exhibit.place,
                        matrix_holds(task, method)
                            ? "method " + name + " is a constant, and its medium's thickness varies"
                            : "this GPU computes in half precision, where method " + name +
                                  " overflows with so great a matrix; folded and reduced do not");
    ObjectPlan plan =
        tried(task, candidate(task, method, method == Method::reduced ? task.exhibit.accuracy.taps : 0), 1e9);
    plan.asked = true;
    plan.why = {
        .ground = Ground::asked, .error = plan.delta_e_bound, .taps = 0, .worst = plan.worst, .rejected = {}};
    return plan;
}

HalfPlan plan_half(const Exhibit& exhibit, HalfView view, const ExhibitSpectra& spectra, int fragment_bits) {
    HalfPlan out{std::move(view), {}};
    for (const ObjectSetting& object : exhibit.objects) {
        Task task{exhibit, object,        out.view,
                  spectra, fragment_bits, pixels_of(exhibit, out.view, spectra, object),
                  {}};
        for (const NamedPixel& pixel : task.pixels)
            task.exact.push_back(exact_xyz(pixel.pixel, spectra.exact()));
        const MethodChoice choice = choice_of(exhibit, out.view.half, object);
        out.objects.push_back(choice ? as_asked(task, *choice) : chosen(task, exhibit.accuracy.tolerance));
    }
    return out;
}

} // namespace

Xyz shown_xyz(Method method, const Pixel& pixel, const Sight& sight, int fragment_bits) {
    return fragment_bits < kFloatBits ? shade_xyz<Float16>(method, pixel, sight)
                                      : shade_xyz<float>(method, pixel, sight);
}

Plan plan_exhibit(const Exhibit& exhibit, const ExhibitSpectra& spectra, int fragment_bits) {
    Plan plan{exhibit.accuracy.tolerance, fragment_bits, {}};
    for (HalfView& view : half_views(exhibit))
        plan.halves.push_back(plan_half(exhibit, std::move(view), spectra, fragment_bits));
    return plan;
}

} // namespace metamer
