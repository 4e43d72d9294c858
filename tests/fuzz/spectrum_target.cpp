#include <algorithm>
#include <cmath>
#include <sys/mman.h>
#include <unistd.h>

#include "atlas/atlas.h"
#include "atlas/atlas_check.h"
#include "base/names.h"
#include "base/numbers.h"
#include "color/colorimetry.h"
#include "color/resample.h"
#include "fuzz/must.h"
#include "service/descriptor.h"
#include "spectra/csv.h"
#include "spectra/library.h"
#include "spectra/spectrum_file.h"

namespace metamer::fuzz {

namespace {

constexpr const char* kPlace = "fuzz.csv";
constexpr std::size_t kMostColumns = 2; // used, of those read: levels take time

/// A file that has a path and is on no disk.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) : file_(memfd_create(kPlace, 0)) {
        must(file_.get() >= 0 && write(file_.get(), bytes.data(), bytes.size()) == std::ssize(bytes),
             "there is memory for a file");
    }
    std::string path() const { return "/proc/self/fd/" + std::to_string(file_.get()); }

private:
    Descriptor file_;
};

void check_curve(const Curve& curve, SpectrumKind kind) {
    const std::vector<double>& nm = curve.wavelength_nm;
    must(nm.size() == curve.value.size() && nm.size() >= 2, "a curve has two points and more");
    must(nm.front() >= 100 && nm.back() <= 5000, "wavelengths are 100 .. 5000 nm");
    must(std::adjacent_find(nm.begin(), nm.end(), std::greater_equal<>()) == nm.end(), "wavelengths ascend");
    for (const double value : curve.value)
        must_be_within(value, kind == SpectrumKind::component ? -1e30 : 0,
                       kind == SpectrumKind::reflectance ? 1 : 1e30, "a spectrum's value");
}

/// The table as a text that says the same: reflectances as they are, not in percent.
std::string canonical(const SpectrumTable& table) {
    std::string text = "# " + table.title + "\n# source: " + table.source + "\nwavelength_nm";
    for (std::string name : table.names) {
        for (std::size_t at = name.find('"'); at != std::string::npos; at = name.find('"', at + 2))
            name.insert(at, 1, '"');
        text += ",\"" + name + '"';
    }
    for (std::size_t row = 0; row < table.curves[0].wavelength_nm.size(); ++row) {
        text += '\n' + to_text(table.curves[0].wavelength_nm[row]);
        for (const Curve& curve : table.curves)
            text += ',' + to_text(curve.value[row]);
    }
    return text + '\n';
}

void check_table(const SpectrumTable& table, SpectrumKind kind) {
    must(!table.names.empty() && table.names.size() == table.curves.size(), "each column has a name");
    for (std::size_t i = 0; i < table.names.size(); ++i) {
        check_curve(table.curves[i], kind);
        must(table.curves[i].wavelength_nm == table.curves[0].wavelength_nm,
             "columns share their wavelengths");
        must(!table.names[i].empty(), "names are not empty");
    }
    const SpectrumTable again = parse_spectra(canonical(table), kPlace, kind);
    must(again.names == table.names && again.title == table.title && again.source == table.source,
         "names, title and source are the same again");
    for (std::size_t i = 0; i < table.curves.size(); ++i)
        must(again.curves[i].wavelength_nm == table.curves[i].wavelength_nm &&
                 again.curves[i].value == table.curves[i].value,
             "curves are the same again");
}

/// Atlases refuse names and sources that could not be printed, the thesis's also light where its observer
/// sees none.
template <class Add>
void add_to_atlases(const Add& add) {
    for (const Quantization quantization : {Quantization::thesis, Quantization::weighted})
        outcome_of([&] {
            Atlas atlas = empty_atlas(quantization);
            must(add(atlas) == 1, "the first row is free");
            must(!flaw_of(atlas), "an atlas has no flaw", flaw_of(atlas).value_or(""));
        });
}

void use_lamp(const std::string& name) {
    std::vector<std::string> doubts;
    Lamp lamp;
    if (outcome_of([&] { lamp = find_lamp(name, ".", &doubts); }) == Outcome::refused)
        return; // it has no light on the grid
    const SampledLamp sampled = sample_lamp(lamp.spectrum);
    must(sampled.peak > 0 && std::isfinite(sampled.peak), "a lamp that is taken has light");
    for (const double value : sampled.emission.value)
        must_be_within(value, 0, 1, "an emission");
    must_be_within(lost_share(lamp.spectrum, kThesisGrid), 0, 1, "the lost share");
    add_to_atlases([&](Atlas& atlas) { return add_lamp(atlas, lamp); });
    const Xyz white = reference_white(reference_lamp(lamp.spectrum));
    must(white.y > 0.999 && white.y < 1.001 && std::isfinite(white.x) && std::isfinite(white.z),
         "a lamp's white has Y = 1");
}

void use_material(const std::string& name) {
    std::vector<std::string> doubts;
    const Material material = find_material(name, ".", &doubts);
    for (const double value : sample_material(material.spectrum).value)
        must_be_within(value, 0, 1, "a reflectance");
    add_to_atlases([&](Atlas& atlas) { return add_material(atlas, material); });
    static const Lamp even = find_lamp("E");
    const Xyz color = reference_xyz(even.spectrum, material.spectrum);
    must_be_within(color.y, 0, 1 + 1e-9, "Y under an even light");
}

/// Names that `path#NAME` can say for a path without an ending of tables, as this one is: neither a `#` nor
/// such an ending, which would make all of it a path.
bool can_be_asked_for(const std::string& name) {
    return name.find('#') == std::string::npos && !names_file("any#" + name);
}

} // namespace

Outcome try_spectrum(std::string_view bytes) {
    const std::string text(bytes);
    const MemoryFile file(bytes);
    const auto table_of = [&](SpectrumKind kind, SpectrumTable& table) {
        const Outcome outcome = outcome_of([&] { table = parse_spectra(text, file.path(), kind); });
        if (outcome == Outcome::taken)
            check_table(table, kind);
        table.names.resize(std::min(table.names.size(), kMostColumns));
        return outcome;
    };
    SpectrumTable components, lamps, materials;
    table_of(SpectrumKind::component, components);
    const Outcome outcome = table_of(SpectrumKind::emission, lamps);
    table_of(SpectrumKind::reflectance, materials);
    for (const std::string& name : lamps.names)
        if (can_be_asked_for(name))
            use_lamp(file.path() + "#" + name);
    for (const std::string& name : materials.names)
        if (can_be_asked_for(name))
            use_material(file.path() + "#" + name);
    return outcome;
}

} // namespace metamer::fuzz
