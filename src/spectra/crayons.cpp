#include <stdexcept>

#include "spectra/csv_text.h"
#include "spectra/sets.h"
#include "spectra/srgb_reflectance.h"
#include "spectra/tables.h"

namespace metamer {

namespace {

struct Crayon {
    std::string name;
    EncodedRgb8 code;
};

const std::vector<Crayon>& crayons() {
    static const std::vector<Crayon> table = [] {
        const CsvText csv = split_csv(table_text("crayons.csv"), "crayons.csv");
        std::vector<Crayon> rows;
        for (std::size_t i = 1; i < csv.rows.size(); ++i) {
            const auto code = parse_srgb_code(csv.rows[i].cells.at(1));
            if (!code)
                refuse_line("crayons.csv", csv.rows[i].line, "this is no sRGB code");
            rows.push_back({csv.rows[i].cells.at(0), *code});
        }
        return rows;
    }();
    return table;
}

} // namespace

std::vector<std::string> crayon_names() {
    std::vector<std::string> names;
    for (const Crayon& crayon : crayons())
        names.push_back(crayon.name);
    return names;
}

std::vector<Material> crayon_materials() {
    std::vector<Material> materials;
    for (const auto& [name, code] : crayons()) {
        auto spectrum = srgb_reflectance(code);
        if (!spectrum)
            throw std::logic_error(name + " has no reflectance");
        materials.push_back(
            {name,
             "modelled from Crayola's published sRGB color " + srgb_code_text(code) + "; no measurement",
             "Burns's LHTSS for sRGB " + srgb_code_text(code) + " under D65", std::move(*spectrum)});
    }
    return materials;
}

} // namespace metamer
