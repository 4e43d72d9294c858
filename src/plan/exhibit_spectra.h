// Every spectrum of an exhibit's materials in the two forms that pixels take: the atlas's rows, and at 1 nm.
#pragma once

#include <array>
#include <vector>

#include "exhibit/exhibit.h"
#include "methods/pixel.h"

namespace metamer {

/// Made once per exhibit; lamps change without it. Layers point into it: it must outlive them.
class ExhibitSpectra {
public:
    explicit ExhibitSpectra(const Exhibit& exhibit);

    /// A key of the atlas, 1 .. 63, that holds a material. At full resolution where the exhibit knows it so.
    Layer material(int key) const;

    /// The observer as loops in shaders read it, and as sums on the CPU take it.
    const GridObserver& seen() const { return seen_; }
    const GridObserver& exact() const { return exact_; }

    /// Keys that hold a material.
    const std::vector<int>& keys() const { return keys_; }

private:
    GridObserver seen_, exact_;
    std::array<Reflectance, kAtlasSize> rows_;
    std::array<std::vector<double>, kAtlasSize> full_; ///< empty where only the row is at hand
    std::vector<int> keys_;
};

} // namespace metamer
