#include "report/paper.h"

#include "base/printed.h"
#include "report/field_csv.h"

namespace metamer {

namespace {

constexpr double kPixels = 1280.0 * 720.0;

} // namespace

double frames_per_s(const PaperRow& row) {
    return row.clock_mhz * 1e6 * row.instructions_per_clock / (row.instructions() * kPixels);
}

std::string paper_csv(const Paper& paper) {
    return fields_csv(paper.context, paper.rows, "paper rows");
}

std::string paper_json(const Paper& paper) {
    auto document = nlohmann::ordered_json::parse(fields_json(paper.context, paper.rows, "paper rows"));
    for (std::size_t i = 0; i < paper.rows.size(); ++i) {
        document["rows"][i]["instructions"] = paper.rows[i].instructions();
        document["rows"][i]["frames_per_s"] = frames_per_s(paper.rows[i]);
    }
    return document.dump(2) + "\n";
}

Paper read_paper_csv(const std::string& text, const std::string& place) {
    Paper paper;
    read_fields_csv(text, place, paper.context, paper.rows, [&](const PaperRow& row, int line) {
        if (!(row.instructions() > 0))
            refuse_line(place, line, "a pixel without instructions");
        if (!(row.clock_mhz > 0) || !(row.instructions_per_clock > 0))
            refuse_line(place, line, "clock_mhz and instructions_per_clock must be above 0");
    });
    return paper;
}

Picture paper_picture(const Paper& paper) {
    std::vector<RateRow> rows;
    for (const PaperRow& row : paper.rows)
        rows.push_back({row.gpu, row.method, frames_per_s(row)});
    const PaperContext& context = paper.context;
    std::string note;
    for (const std::string& part : {context.compilers, context.date, context.command})
        if (!part.empty())
            note += (note.empty() ? "" : " · ") + part;
    return rate_picture(rows, context.assumption, note);
}

std::string paper_table(const Paper& paper) {
    std::string out = paper.context.assumption + "\n\n" +
                      printed("%-22s %-12s %8s %6s %6s %8s %6s %6s %8s\n", "GPU", "method", "straight",
                              "loop", "rounds", "executed", "MHz", "/clock", "frames/s");
    for (const PaperRow& row : paper.rows)
        out += printed("%-22s %-12s %8g %6g %6d %8g %6g %6g %8.1f\n", row.gpu.c_str(), row.method.c_str(),
                       row.straight, row.loop, row.rounds, row.instructions(), row.clock_mhz,
                       row.instructions_per_clock, frames_per_s(row));
    return out;
}

} // namespace metamer
