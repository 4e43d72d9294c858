#include "spectra/sets.h"
#include "spectra/tables.h"

namespace metamer {

std::vector<Material> colorchecker_materials() {
    const SpectrumTable& table = colorchecker();
    std::vector<Material> materials;
    for (std::size_t i = 0; i < table.names.size(); ++i)
        materials.push_back({table.names[i],
                             "ColorChecker patch " + std::to_string(i + 1) + ", measured",
                             table.source,
                             {table.curves[i]}});
    return materials;
}

} // namespace metamer
