#include "plan/exhibit_spectra.h"

#include "color/resample.h"

namespace metamer {

ExhibitSpectra::ExhibitSpectra(const Exhibit& exhibit)
    : seen_(observer(exhibit.atlas)), exact_(exact_observer(exhibit.atlas)) {
    for (int key = 1; key <= kAtlasRows; ++key) {
        const auto row = static_cast<std::size_t>(key);
        if (exhibit.atlas.materials[row].name.empty())
            continue;
        keys_.push_back(key);
        rows_[row] = reflectance(exhibit.atlas, key);
        if (const auto found = exhibit.materials.find(key); found != exhibit.materials.end())
            full_[row] = resample(found->second.spectrum, kReferenceGrid);
    }
}

Layer ExhibitSpectra::material(int key) const {
    const auto row = static_cast<std::size_t>(key);
    return {&rows_[row], full_[row].empty() ? nullptr : &full_[row]};
}

} // namespace metamer
