// `metamer chart --paper`: what old GPUs could draw, reckoned from instruction counts. Nothing is measured.
#pragma once

#include <string>
#include <vector>

#include "report/chart_picture.h"

namespace metamer {

/// A method's fragment shader on a GPU.
struct PaperRow {
    std::string gpu{}, method{};
    double straight = 0; ///< instructions executed once per pixel
    double loop = 0;     ///< instructions of a round of its loop, `rounds` times per pixel; 0: no loop
    int rounds = 0;
    double clock_mhz = 0;              ///< of the shader cores, published
    double instructions_per_clock = 0; ///< pixels' instructions that all cores finish per clock, published
    std::string source{};              ///< where both are published

    /// Executed per pixel.
    double instructions() const { return straight + loop * rounds; }
    bool operator==(const PaperRow&) const = default;
};

struct PaperContext {
    std::string assumption{}; ///< what the reckoning leaves out
    std::string compilers{};  ///< what the counts are of
    std::string date{}, command{};

    bool operator==(const PaperContext&) const = default;
};

struct Paper {
    PaperContext context;
    std::vector<PaperRow> rows{};

    bool operator==(const Paper&) const = default;
};

/// Frames of 1280x720 per second where every pixel is shaded once and nothing else takes time: clock times
/// instructions per clock over instructions per frame.
double frames_per_s(const PaperRow& row);

/// As chart_csv, chart_json (with `instructions` and `frames_per_s` beside each row's fields) and
/// read_chart_csv; also refuses, at its line, a row without instructions, clock or rate.
std::string paper_csv(const Paper& paper);
std::string paper_json(const Paper& paper);
Paper read_paper_csv(const std::string& text, const std::string& place);

/// Drawn by rate_picture().
Picture paper_picture(const Paper& paper);

/// For people: one line per row.
std::string paper_table(const Paper& paper);

} // namespace metamer
