// The experiments of `metamer stability`: one thing swept until methods fail.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/plot.h"

namespace metamer {

struct ExperimentPoint {
    double x = 0;
    std::map<std::string, double> delta_e{}; ///< CIEDE2000 by method
    std::string name{};                      ///< of what was tried here, where x alone does not say it
    std::map<std::string, double> also{};    ///< other figures, by name
};

/// Where a method fails, and why, in half a sentence.
struct Failure {
    std::string method{};
    double at = 0;
    std::string why{};
};

struct Experiment {
    std::string name{};
    std::string group{};         ///< what is shown on one page
    std::string finding{};       ///< in half a sentence, with its number
    std::string swept{}, unit{}; ///< unit: empty for a plain number
    bool log_x = true;
    bool discrete = false; ///< x takes the swept values only: a failure is at one of them
    std::vector<ExperimentPoint> points{};
    std::vector<Failure> fails{};
    std::string guard{}; ///< what the program does about it
};

/// {"experiments": [...]} as DESIGN.md section 6 names it, `finding` beside, and `point` and further figures
/// where a point has them; a difference that is no finite number is null.
/// Ends in a line break. Throws bad_input `cannot write stability: ...` for text that is not UTF-8.
std::string experiments_json(const std::vector<Experiment>& experiments);

/// Pages of at most `columns` x `rows` small plots under their findings: a line per method, rings where one
/// fails, the causes and the guard below. `tolerance`: a line across each; 0: none. Throws bad_input for
/// columns or rows below 1.
std::vector<Picture> experiment_pages(const std::vector<Experiment>& experiments, double tolerance,
                                      const std::string& note, int columns = 3, int rows = 2,
                                      int width_px = 1800, int height_px = 1200);

} // namespace metamer
