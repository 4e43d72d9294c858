// Rows, sweeps and experiments as real ones look, from formulas: every run draws the same picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "report/chart_picture.h"
#include "report/experiment.h"
#include "report/rows.h"

namespace metamer {

inline ChartRow sample_row(const std::string& method, int taps, Precision precision, Levels atlas,
                           double cost, double mean, double p95, double max, const std::string& material,
                           const std::string& lamp) {
    return {.method = method,
            .taps = taps,
            .precision = precision,
            .atlas = atlas,
            .ms = cost * 21.3,
            .ms_q1 = cost * 20.9,
            .ms_q3 = cost * 22.1,
            .cost_ratio = cost,
            .cost_ratio_q1 = cost * 0.98,
            .cost_ratio_q3 = cost * 1.03,
            .delta_e_mean = mean,
            .delta_e_p95 = p95,
            .delta_e_max = max,
            .worst_lamp = lamp,
            .worst_material = material};
}

/// 56 rows with the costs and errors of DESIGN.md section 2.
inline Chart sample_chart() {
    Chart chart;
    chart.context = {.exhibit = "still life",
                     .gl_renderer = "llvmpipe (LLVM 15.0.6, 256 bits)",
                     .date = "2026-11-22",
                     .command = "metamer chart config/still-life.ini",
                     .width_px = 1280,
                     .height_px = 720,
                     .lamps = 45,
                     .materials = 64,
                     .tolerance = 0.5};
    for (const Precision precision : {Precision::fp32, Precision::fp16})
        for (const Levels atlas : {Levels::eight_bit, Levels::unquantized}) {
            const bool half = precision == Precision::fp16, fine = atlas == Levels::unquantized;
            const auto add = [&](const std::string& method, int taps, double cost, double mean, double p95,
                                 double max, const std::string& material, const std::string& lamp) {
                const double noise = half ? 0.12 : 0, better = fine ? 0.5 : 1;
                chart.rows.push_back(sample_row(method, taps, precision, atlas, cost * (half ? 1.012 : 1),
                                                mean * better + noise, p95 * better + noise * 2,
                                                max * better + noise * 6, material, lamp));
            };
            if (!fine) {
                add("rgb", 0, 1, 4.8, 15, 58, "ces-27 red", "Na low pressure");
                add("tristimulus", 0, 1.04, 3.3, 9.6, 32, "ces-64 blue", "Na low pressure");
                add("prefiltered", 0, 1.06, 1.4, 4.4, 14, "ces-64 blue", "F10");
            }
            add("spectral", 64, 6.3, 0.14, 0.4, 2.15, "crayon-black", "F10");
            add("packed", 64, 3.3, 0.135, 0.4, 2.15, "crayon-black", "F10");
            add("folded", 0, 0.65, 0.03, 0.1, 0.4, "crayon-black", "F10");
            for (const int n : {4, 6, 8, 12, 16, 24, 32})
                add("reduced", n, 1.1 + 0.09 * n, 30.0 / (n * n), 90.0 / (n * n), 240.0 / (n * n),
                    "ces-16 violet", "krypton");
        }
    mark_frontier(chart.rows, chart.context.frontier_by);
    for (ChartRow& row : chart.rows)
        row.chosen =
            row.method == "folded" && row.precision == Precision::fp32 && row.atlas == Levels::unquantized;
    return chart;
}

/// Cost over wavelengths, lamps, objects and pixels.
inline std::vector<CostPanel> sample_costs() {
    std::vector<CostPanel> panels;
    const std::vector<std::vector<double>> swept{
        {4, 8, 16, 32, 64}, {1, 2, 3, 4, 6, 8}, {1, 4, 16, 63}, {0.06, 0.23, 0.92, 2.07}};
    const std::vector<std::string> titles{"Wavelengths", "Lamps", "Objects", "Pixels"};
    const std::vector<std::string> axes{"wavelengths N", "lamps", "objects", "megapixels"};
    for (std::size_t i = 0; i < swept.size(); ++i) {
        CostPanel panel{.title = titles[i], .swept = axes[i], .log_x = i != 1};
        double slope = 0;
        for (const char* method : {"folded", "rgb", "tristimulus", "reduced", "packed", "spectral"}) {
            CostCurve curve{.method = method};
            for (const double x : swept[i]) {
                const double cost = i == 3 ? (0.6 + slope) * x : 0.65 + slope * 0.1 * x;
                curve.points.push_back({x, cost, cost * 0.97, cost * 1.05});
            }
            panel.curves.push_back(curve);
            slope = slope * 2 + (slope == 0 ? 0.1 : 0);
        }
        panels.push_back(panel);
    }
    return panels;
}

inline std::vector<RateRow> sample_rates() {
    std::vector<RateRow> rows;
    const std::vector<std::pair<std::string, double>> gpus{
        {"Mali-450", 1200}, {"VideoCore IV", 260}, {"Vivante GC2000", 900}, {"Adreno 200", 400}};
    for (const auto& [gpu, rate] : gpus) {
        double cost = 4;
        for (const char* method :
             {"folded", "rgb", "tristimulus", "prefiltered", "reduced", "packed", "spectral"}) {
            rows.push_back({gpu, method, rate / cost});
            cost *= cost < 6 ? 1.12 : 3.1;
        }
    }
    return rows;
}

/// Eight sweeps; one with a zero, an infinity and a NaN.
inline std::vector<Experiment> sample_experiments() {
    std::vector<Experiment> out;
    for (int i = 0; i < 8; ++i) {
        Experiment e{
            .name = "Line width, no. " + std::to_string(i + 1),
            .swept = "full width at half maximum",
            .unit = "nm",
            .guard = "the planner integrates lamps at their own resolution and refuses spectral below 5 nm"};
        for (double width = 100; width > 0.09; width /= 1.5) {
            const double grid = 0.05 + 12 / (1 + width * width / (3 + i));
            e.points.push_back({width,
                                {{"spectral", grid},
                                 {"packed", grid * 1.02},
                                 {"folded", 0.004},
                                 {"reduced", 0.3 + 3 / width}}});
        }
        e.fails = {{"spectral", 5, "the line falls between two samples of the 5 nm grid"},
                   {"reduced", 12, "eight bands are wider than the line"}};
        out.push_back(e);
    }
    out[1].points[2].delta_e["folded"] = 0;
    out[1].points[4].delta_e["spectral"] = HUGE_VAL;
    out[1].points[6].delta_e["packed"] = std::nan("");
    return out;
}

} // namespace metamer
