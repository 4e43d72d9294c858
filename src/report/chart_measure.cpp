#include "report/chart_measure.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "base/error.h"
#include "gles/info.h"
#include "report/chart_exhibits.h"
#include "report/frame_timing.h"
#include "report/statistics.h"

namespace metamer {

namespace {

constexpr std::array kWays{
    Way{{}, 0, Precision::fp32, Levels::unquantized}, Way{{}, 0, Precision::fp32, Levels::eight_bit},
    Way{{}, 0, Precision::fp16, Levels::unquantized}, Way{{}, 0, Precision::fp16, Levels::eight_bit}};

void leave_out(std::string& left_out, const std::string& what, const Error& error) {
    left_out += (left_out.empty() ? "" : "; ") + what + ": " + error.cause();
}

/// An entry that can be drawn.
struct Contender {
    Entry entry;
    std::unique_ptr<TimedFrame> frame;
};

std::vector<Contender> contenders(const Exhibit& exhibit, std::string& left_out) {
    std::vector<Contender> out;
    for (const Entry& entry : chart_entries())
        try {
            out.push_back({entry, std::make_unique<TimedFrame>(drawn_by(exhibit, entry.method, entry.taps),
                                                               DrawStyle{.everybody = entry.everybody})});
        } catch (const Error& error) {
            if (entry.everybody)
                throw; // without it no ratio means anything
            leave_out(left_out, entry.name, error);
        }
    return out;
}

std::vector<ChartRow> timed_rows(std::span<const Contender> contenders, int rounds, const StopWatch& watch) {
    std::vector<std::function<void()>> frames;
    for (const Contender& contender : contenders)
        frames.push_back([&contender] { contender.frame->draw(); });
    const auto ms = time_rounds(frames, rounds, watch);
    std::vector<ChartRow> rows;
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        const Summary time = summarize(ms[i], "times of " + contenders[i].entry.name);
        const Summary ratio = summarize(ratios(ms[i], ms[0]), "ratios of " + contenders[i].entry.name);
        rows.push_back({.method = contenders[i].entry.name,
                        .taps = contenders[i].entry.sums(),
                        .ms = time.median,
                        .ms_q1 = time.q1,
                        .ms_q3 = time.q3,
                        .cost_ratio = ratio.median,
                        .cost_ratio_q1 = ratio.q1,
                        .cost_ratio_q3 = ratio.q3});
    }
    return rows;
}

void fill_in(ChartRow& row, std::span<const PairDifference> differences) {
    std::vector<double> values;
    for (const PairDifference& pair : differences)
        values.push_back(pair.delta_e);
    const Summary summary = summarize(values, "differences of " + row.method);
    row.delta_e_mean = summary.mean;
    row.delta_e_p95 = summary.p95;
    row.delta_e_max = summary.max;
    const PairDifference& worst = differences[static_cast<std::size_t>(
        std::max_element(values.begin(), values.end()) - values.begin())];
    row.worst_lamp = worst.lamp;
    row.worst_material = worst.material;
}

std::string way_name(const ChartRow& row) {
    return row.method + (row.precision == Precision::fp16 ? " in fp16" : "") +
           (row.atlas == Levels::eight_bit ? " from the atlas" : "");
}

/// A row of the entry computed in this way, or none, with its cause in `left_out`.
std::optional<ChartRow> judged(ChartRow row, const Entry& entry, Way way,
                               std::span<const AccuracyProbe> probes, std::string& left_out) {
    way.method = entry.method;
    way.taps = entry.taps;
    row.precision = way.precision;
    row.atlas = way.levels;
    std::vector<PairDifference> differences;
    try {
        for (const AccuracyProbe& probe : probes) {
            auto more = probe.differences(way);
            differences.insert(differences.end(), more.begin(), more.end());
        }
    } catch (const Error& error) {
        leave_out(left_out, way_name(row), error);
        return std::nullopt;
    }
    fill_in(row, differences);
    return row;
}

void mark_chosen(std::vector<ChartRow>& rows, const Plan& plan, Levels levels) {
    const Precision precision = plan.fragment_bits < kFloatBits ? Precision::fp16 : Precision::fp32;
    for (const ObjectPlan& object : plan.halves[0].objects) {
        const Entry taken{
            std::string(method_name(object.method)), object.method,
            object.method == Method::reduced ? static_cast<int>(object.taps.wavelength_nm.size()) : 0};
        for (ChartRow& row : rows)
            if (row.method == taken.name && row.taps == taken.sums() && row.precision == precision &&
                row.atlas == levels)
                row.chosen = true;
    }
}

void count_pairs(ChartContext& context, std::span<const AccuracyProbe> probes) {
    std::set<std::string> lamps, materials;
    for (const AccuracyProbe& probe : probes)
        for (const PairDifference& pair : probe.differences({Method::tristimulus})) {
            lamps.insert(pair.lamp);
            materials.insert(pair.material.substr(0, pair.material.find(" through ")));
        }
    context.lamps = static_cast<int>(lamps.size());
    context.materials = static_cast<int>(materials.size());
}

} // namespace

int Entry::sums() const {
    if (!method || *method == Method::folded || is_product(*method))
        return 0;
    return *method == Method::reduced ? taps : static_cast<int>(kIntervals);
}

std::vector<Entry> chart_entries() {
    std::vector<Entry> out{{std::string(kBaseName), Method::rgb, 0, true}};
    for (const MethodInfo& info : kMethods)
        if (info.method != Method::reduced)
            out.push_back({std::string(info.name), info.method});
        else
            for (const int taps : kTapCounts)
                out.push_back({std::string(info.name), info.method, taps});
    out.push_back({std::string(kPlannedName), std::nullopt});
    return out;
}

Levels levels_known(const Exhibit& exhibit) {
    const bool lamps = std::all_of(exhibit.lamps.begin(), exhibit.lamps.end(),
                                   [](const LampSetting& lamp) { return lamp.full_resolution; });
    const ExhibitSpectra spectra(exhibit);
    const bool materials = std::all_of(spectra.keys().begin(), spectra.keys().end(),
                                       [&](int key) { return spectra.material(key).full != nullptr; });
    return lamps && materials ? Levels::unquantized : Levels::eight_bit;
}

Chart measure_chart(const Exhibit& exhibit, std::span<const Exhibit> pairs, int rounds) {
    const FrameClock clock = frame_clock();
    Chart chart;
    chart.context = {.gl_renderer = gl_renderer(),
                     .timer = clock.name,
                     .width_px = exhibit.display.width_px,
                     .height_px = exhibit.display.height_px,
                     .rounds = rounds,
                     .tolerance = exhibit.accuracy.tolerance};
    std::string& left_out = chart.context.left_out;
    const auto drawn = contenders(exhibit, left_out);
    const auto timed = timed_rows(drawn, rounds, clock.watch);
    std::vector<AccuracyProbe> probes;
    if (pairs.empty())
        probes.emplace_back(exhibit);
    for (const Exhibit& pair : pairs)
        probes.emplace_back(pair);
    count_pairs(chart.context, probes);
    for (std::size_t i = 0; i < drawn.size(); ++i)
        for (const Way& way : kWays)
            if (auto row = judged(timed[i], drawn[i].entry, way, probes, left_out))
                chart.rows.push_back(std::move(*row));
    mark_frontier(chart.rows, chart.context.frontier_by);
    if (drawn.back().entry.name == kPlannedName)
        mark_chosen(chart.rows, drawn.back().frame->plan(), levels_known(exhibit));
    return chart;
}

} // namespace metamer
