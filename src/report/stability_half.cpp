// Half precision: sums, keys and coordinates.
#include <bit>
#include <cstdint>

#include "report/number_text.h"
#include "report/stability_groups.h"
#include "report/stability_kit.h"

namespace metamer {

namespace {

enum class Rounding { nearest, to_zero };

// A number as half precision keeps it. OpenGL ES asks for no rounding in particular: some GPUs cut.
Float16 half(double v, Rounding rounding = Rounding::nearest) {
    const Float16 h = static_cast<Float16>(v);
    if (rounding == Rounding::nearest || std::abs(static_cast<double>(h)) <= std::abs(v))
        return h;
    return std::bit_cast<Float16>(static_cast<std::uint16_t>(std::bit_cast<std::uint16_t>(h) - 1));
}

double in_half(double v, Rounding rounding) {
    return static_cast<double>(half(v, rounding));
}

// X', Y', Z' / k' with sums of `group` terms first, then the sum of those, every operation in half; k' by the
// CPU. The double holds what half makes of the operands exactly, so that each result is rounded once.
Xyz grouped_sum(const LampForms& lamp, const MaterialForms& material, const GridObserver& observer,
                std::size_t group, Rounding rounding) {
    const auto r = [&](double v) { return in_half(v, rounding); };
    std::array<double, kIntervals> phi;
    for (std::size_t i = 0; i < kIntervals; ++i)
        phi[i] = r(in_half(material.row.value[i], Rounding::nearest) *
                   in_half(lamp.row.value[i], Rounding::nearest));
    const double scale = in_half(packed_scale(lamp.row, 1, observer), Rounding::nearest);
    const auto sum = [&](const std::array<double, kIntervals>& weight) {
        double total = 0;
        for (std::size_t first = 0; first < kIntervals; first += group) {
            double part = 0;
            for (std::size_t i = first; i < first + group; ++i)
                part = r(part + r(in_half(weight[i], Rounding::nearest) * phi[i]));
            total = r(total + part);
        }
        return r(scale * total);
    };
    return {sum(observer.x), sum(observer.y), sum(observer.z)};
}

// What is seen of one material where another was meant.
double mixed_up(std::size_t meant, std::size_t found, const LampForms& lamp) {
    const std::size_t count = patches().size();
    const auto color = [&](std::size_t i) { return reference_xyz(lamp.full, patches()[i % count].full); };
    return delta_e_2000(color(meant), color(found));
}

// The key that a shader in half makes of a map's byte; a half up before the integer part is taken, or not.
std::size_t key_read(int key, bool rounds, Rounding rounding) {
    const double scaled = in_half(in_half(key / 255.0, rounding) * 255, rounding);
    return static_cast<std::size_t>(std::floor(rounds ? in_half(scaled + 0.5, rounding) : scaled));
}

template <Scalar T>
std::size_t texel_found(std::size_t texel, int size) {
    const T coordinate =
        static_cast<T>((static_cast<double>(texel) + 0.5) / size); // as the CPU or a varying hands it over
    const double at = std::floor(static_cast<double>(coordinate) * size);
    return static_cast<std::size_t>(std::min<double>(at, size - 1));
}

} // namespace

Experiment summation_order() {
    Experiment e{.name = "Order of a sum in half precision",
                 .swept = "terms that are summed before the sums are, 64 in all; six lamps",
                 .unit = "terms",
                 .discrete = true};
    const GridObserver& observer = *sight().seen;
    std::vector<LampForms> lamps;
    for (const char* name : {"A2800", "D65", "F2", "F11", "white-LED", "krypton"})
        lamps.push_back(lamp_forms(name));
    for (std::size_t group = 1; group <= kIntervals; group *= 2) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{static_cast<double>(group)});
        for (const LampForms& lamp : lamps)
            for (const MaterialForms& patch : patches()) {
                const Pixel pixel = pair(lamp, patch);
                const Xyz exact = exact_xyz(pixel, *sight().exact);
                const auto partial = [&](Rounding rounding) {
                    return delta_e_2000(grouped_sum(lamp, patch, observer, group, rounding), exact);
                };
                raise(point, "spectral in fp16", partial(Rounding::nearest));
                raise(point, "spectral in fp16 that cuts", partial(Rounding::to_zero));
                raise(point, "packed in fp16", difference<Float16>(Method::packed, pixel, sight()));
                raise(point, "folded in fp16", difference<Float16>(Method::folded, pixel, sight()));
                raise(point, "spectral", difference<float>(Method::spectral, pixel, sight()));
            }
    }
    add_failure(e, "spectral in fp16", Harder::up, "each addition rounds to 11 bits of the sum so far");
    add_failure(e, "spectral in fp16 that cuts", Harder::up,
                "a GPU that rounds to zero loses up to a step in each addition, always downwards");
    add_failure(e, "packed in fp16", Harder::up, "the matrix behind the sums rounds as well");
    add_failure(e, "folded in fp16", Harder::up, "a constant of 11 bits");
    const auto at = [&](std::size_t i) {
        return short_number(e.points[i].delta_e.at("spectral in fp16 that cuts"));
    };
    e.finding = "On a GPU that cuts, one fp16 sum of 64 terms costs " + at(6) + ", sums of four " + at(2);
    e.guard = "packed adds sums of four, with k' from the CPU; the planner measures the GPU's bits and takes "
              "folded";
    return e;
}

Experiment key_precision() {
    Experiment e{.name = "Keys in half precision",
                 .swept = "key, as R of a map read by a GPU that computes in fp16",
                 .log_x = false,
                 .discrete = true};
    const LampForms lamp = lamp_forms("D65");
    for (int key = 1; key <= 255; ++key) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{static_cast<double>(key)});
        const auto meant = static_cast<std::size_t>(key);
        raise(point, "key cut", mixed_up(meant, key_read(key, false, Rounding::nearest), lamp));
        raise(point, "key cut, GPU that cuts",
              mixed_up(meant, key_read(key, false, Rounding::to_zero), lamp));
        raise(point, "key rounded", mixed_up(meant, key_read(key, true, Rounding::nearest), lamp));
        raise(point, "key rounded, GPU that cuts",
              mixed_up(meant, key_read(key, true, Rounding::to_zero), lamp));
    }
    const std::string below = "R times 255 comes out just below the key";
    add_failure(e, "key cut", Harder::up, below);
    add_failure(e, "key cut, GPU that cuts", Harder::up, below);
    add_failure(e, "key rounded", Harder::up, "R times 255 is off by half a key");
    add_failure(e, "key rounded, GPU that cuts", Harder::up, "R times 255 is off by half a key");
    e.finding =
        finding(e, "key cut, GPU that cuts", "Without rounding, keys are misread from", "Keys may be cut") +
        finding(e, "key rounded, GPU that cuts", "; rounded from", "; rounded, all 255 hold");
    e.guard = "shaders round: floor(R * 255 + 0.5)";
    return e;
}

Experiment texel_precision() {
    Experiment e{.name = "Coordinates in half precision",
                 .swept = "texels along a side, read at their centers",
                 .unit = "px",
                 .discrete = true};
    const LampForms lamp = lamp_forms("D65");
    for (int size = 64; size <= 4096; size *= 2) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{static_cast<double>(size)});
        for (std::size_t texel = 0; texel < static_cast<std::size_t>(size); ++texel) {
            const std::size_t in_half = texel_found<Float16>(texel, size),
                              in_float = texel_found<float>(texel, size);
            raise(point, "coordinate in fp16", in_half == texel ? 0 : mixed_up(texel, in_half, lamp));
            raise(point, "coordinate in fp32", in_float == texel ? 0 : mixed_up(texel, in_float, lamp));
        }
    }
    add_failure(e, "coordinate in fp16", Harder::up,
                "above 1/2 half precision has 2048 steps to 1: centers round onto edges");
    add_failure(e, "coordinate in fp32", Harder::up, "centers round onto edges");
    e.finding = finding(e, "coordinate in fp16", "Half-precision coordinates meet the wrong texel from",
                        "Half-precision coordinates meet their texels");
    e.guard = "computed coordinates read tables of at most 256 rows; maps are read by the varying itself, "
              "which old GPUs keep at 24 bits";
    return e;
}

} // namespace metamer
