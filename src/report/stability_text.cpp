#include <algorithm>

#include "base/numbers.h"
#include "report/number_text.h"
#include "report/stability.h"

namespace metamer {

namespace {

constexpr std::size_t kLineLength = 100;

// Words on lines of at most kLineLength bytes; lines after the first begin with `indent` blanks.
std::string wrapped(const std::string& text, std::size_t indent) {
    std::string out, line;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        if (!line.empty() && line.size() + 1 + word.size() > kLineLength) {
            out += line + '\n';
            line = std::string(indent, ' ') + word;
        } else {
            line += (begin == 0 ? "" : " ") + word;
        }
        begin = end + 1;
    }
    return out + line + '\n';
}

std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
    std::string out = "\"";
    for (const char c : text)
        out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + '"';
}

std::string place(const Experiment& e, const Failure& fail) {
    return short_number(fail.at, e.discrete ? 4 : 3) + (e.unit.empty() ? "" : " " + e.unit);
}

} // namespace

std::string stability_text(std::span<const Experiment> experiments) {
    std::string out = wrapped("Where each method fails: its CIEDE2000 against the reference exceeds " +
                                  short_number(kFailsAbove) + ".",
                              0);
    for (const Experiment& e : experiments) {
        out += '\n' + wrapped(e.name + ": " + e.finding, 2);
        out += wrapped("  swept: " + e.swept + ", " + short_number(e.points.front().x) + " .. " +
                           short_number(e.points.back().x) + (e.unit.empty() ? "" : " " + e.unit),
                       4);
        for (const Failure& fail : e.fails)
            out += wrapped("  " + fail.method + " fails at " + place(e, fail) + ": " + fail.why, 4);
        std::string holding;
        for (const auto& [method, difference] : e.points.front().delta_e) {
            const auto is_it = [&, &name = method](const Failure& f) { return f.method == name; };
            if (std::none_of(e.fails.begin(), e.fails.end(), is_it))
                holding += (holding.empty() ? "" : "; ") + method;
        }
        if (!holding.empty())
            out += wrapped("  holds throughout: " + holding, 4);
        out += wrapped("  guard: " + e.guard, 4);
    }
    return out;
}

std::string stability_csv(std::span<const Experiment> experiments) {
    std::string out = "experiment,swept,unit,x,point,method,delta_e_2000\n";
    for (const Experiment& e : experiments)
        for (const ExperimentPoint& point : e.points)
            for (const auto& [method, difference] : point.delta_e)
                out += cell(e.name) + ',' + cell(e.swept) + ',' + e.unit + ',' + to_text(point.x) + ',' +
                       cell(point.name) + ',' + cell(method) + ',' + to_text(difference) + '\n';
    return out;
}

} // namespace metamer
