// The atlas's rows: 8 bits of them, and how they are read.
#include <memory>

#include "atlas/lamp_fit.h"
#include "atlas/levels.h"
#include "atlas/material_fit.h"
#include "report/stability_groups.h"
#include "report/stability_kit.h"
#include "spectra/library.h"

namespace metamer {

namespace {

// A row of levels 0 .. 2^bits - 1 that stands for `fit`, `greatest` of it at the highest level.
RowValues chosen_together(const LevelSearch& search, const RowFit& fit, double greatest, int bits) {
    const double highest = (1 << bits) - 1;
    RowValues wanted = fit.best;
    for (double& v : wanted)
        v *= highest / greatest;
    const Levels levels = search.nearest(wanted);
    RowValues out;
    std::transform(levels.level.begin(), levels.level.end(), out.begin(),
                   [&](std::uint8_t level) { return std::min<double>(level, highest) / highest * greatest; });
    return out;
}

RowValues one_by_one(const RowFit& fit, double greatest, int bits) {
    RowValues out = fit.best;
    for (double& v : out)
        v /= greatest;
    out = rounded(out, (1 << bits) - 1);
    for (double& v : out)
        v *= greatest;
    return out;
}

// A fit and everything that is made of it.
struct Fitted {
    RowFit fit;
    LevelSearch search;
    double greatest;

    explicit Fitted(RowFit made)
        : fit(std::move(made)),
          search(fit.form),
          greatest(*std::max_element(fit.best.begin(), fit.best.end())) {}
    Fitted(const Fitted&) = delete;
    Fitted& operator=(const Fitted&) = delete;

    RowValues row(bool together, int bits) const {
        return together ? chosen_together(search, fit, greatest, bits) : one_by_one(fit, greatest, bits);
    }
};

void divide(RowValues& row, double by) {
    for (double& v : row)
        v /= by;
}

void measure_bits(ExperimentPoint& point, int bits, const Fitted& lamp, const ReferenceLamp& full,
                  const std::vector<std::unique_ptr<Fitted>>& materials) {
    for (const bool together : {false, true}) {
        LampForms forms{{lamp.row(together, bits)}, full};
        divide(forms.row.value, lamp.greatest);
        for (std::size_t m = 0; m < materials.size(); ++m) {
            const MaterialForms material{{materials[m]->row(together, bits)}, patches()[m].full};
            raise(point, together ? "spectral" : "spectral, rounded one by one",
                  difference<float>(Method::spectral, pair(forms, material), sight()));
        }
    }
}

// What a linear filter makes of a table of rows when read `offset` rows off a row's center, towards the next.
RowValues between(const RowValues& row, const RowValues& next, double offset) {
    RowValues out;
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = std::lerp(row[i], next[i], offset);
    return out;
}

} // namespace

Experiment dim_rows() {
    Experiment e{.name = "Dim rows of the atlas",
                 .swept = "full scale over the row's greatest value; krypton, F11, low-pressure sodium",
                 .unit = ""};
    for (const double dimmer : {1., 2., 3., 4., 5., 7., 10., 14., 20., 28., 35., 50.}) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{dimmer});
        for (const std::string& name : line_lamps()) {
            const LampForms bright = lamp_forms(name);
            LampForms dim = bright;
            divide(dim.row.value, dimmer);
            dim.row.value = rounded(dim.row.value);
            raise(point, "spectral", worst<float>(Method::spectral, bright, patches(), sight()));
            raise(point, "spectral, lamp's row dim", worst<float>(Method::spectral, dim, patches(), sight()));
            for (const MaterialForms& patch : patches()) {
                MaterialForms dark = patch;
                const double full =
                    *std::max_element(patch.row.value.begin(), patch.row.value.end()) * dimmer;
                divide(dark.row.value, full);
                dark.row.value = rounded(dark.row.value);
                divide(dark.row.value, 1 / full);
                raise(point, "spectral, material's row dim",
                      difference<float>(Method::spectral, pair(bright, dark), sight()));
            }
        }
    }
    for (const char* what : {"lamp", "material"})
        add_failure(e, std::string("spectral, ") + what + "'s row dim", Harder::up,
                    "weak lines and dark bands fall below half a level");
    e.finding = finding(e, "spectral, lamp's row dim",
                        "Stored at less than full scale, a lamp fails from 1 /", "Dim lamp rows hold") +
                finding(e, "spectral, material's row dim", "; a material from 1 /", "");
    e.guard = "every row is stored at full scale: a lamp's peak and a material's scale travel beside it";
    return e;
}

Experiment level_bits() {
    Experiment e{.name = "Bits of a level",
                 .swept = "bits; krypton, F11, low-pressure sodium",
                 .unit = "bits",
                 .log_x = false,
                 .discrete = true};
    std::vector<std::unique_ptr<Fitted>> materials;
    for (const Material& patch : patch_materials())
        materials.push_back(std::make_unique<Fitted>(fit_material(patch.spectrum)));
    std::vector<std::unique_ptr<Fitted>> lamps;
    std::vector<ReferenceLamp> full;
    for (const std::string& name : line_lamps()) {
        const LampSpectrum lamp = find_lamp(name).spectrum;
        lamps.push_back(std::make_unique<Fitted>(fit_lamp(lamp_power(lamp))));
        full.push_back(reference_lamp(lamp));
    }
    for (int bits = 4; bits <= 8; ++bits) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{static_cast<double>(bits)});
        for (std::size_t l = 0; l < lamps.size(); ++l)
            measure_bits(point, bits, *lamps[l], full[l], materials);
    }
    add_failure(e, "spectral", Harder::down, "too few levels, however they are chosen");
    add_failure(e, "spectral, rounded one by one", Harder::down, "errors of neighbors add up by chance");
    e.finding = finding(e, "spectral, rounded one by one", "Rounded one by one, levels fail at",
                        "Rounding one by one holds") +
                finding(e, "spectral", "; chosen together at", "; chosen together they hold");
    e.guard = "the levels of a row are chosen together, so that its sums come out right";
    return e;
}

Experiment row_filtering() {
    Experiment e{.name = "Filtering between rows",
                 .swept = "distance of the coordinate from its row's center, patches as rows, D65",
                 .unit = "rows",
                 .log_x = false,
                 .discrete = true};
    const LampForms lamp = lamp_forms("D65");
    for (const double offset : evenly(0, 0.6, 61)) {
        ExperimentPoint& point = e.points.emplace_back(ExperimentPoint{offset});
        for (std::size_t m = 0; m + 1 < patches().size(); ++m) {
            const MaterialForms &own = patches()[m], &next = patches()[m + 1];
            const MaterialForms filtered{{between(own.row.value, next.row.value, offset)}, own.full};
            const MaterialForms nearest{offset < 0.5 ? own.row : next.row, own.full};
            raise(point, "spectral, linear filter",
                  difference<float>(Method::spectral, pair(lamp, filtered), sight()));
            raise(point, "spectral", difference<float>(Method::spectral, pair(lamp, nearest), sight()));
        }
    }
    add_failure(e, "spectral, linear filter", Harder::up, "a share of the next material's row is mixed in");
    add_failure(e, "spectral", Harder::up, "half a row off is the next row");
    e.finding =
        finding(e, "spectral, linear filter", "A linear filter bleeds from", "A linear filter holds") +
        finding(e, "spectral", "; the nearest turns at", "; nearest holds");
    e.guard = "tables of rows are read with the nearest filter, at the centers of their texels";
    return e;
}

} // namespace metamer
