// What the command line calls lamps and materials: files stand for all of their columns, sets for their
// members.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace metamer {

/// Names for find_lamp: a file without #column becomes one name per column; `thesis` the thesis's fifteen,
/// `all` the library's lamps; everything else stays. Throws bad_input for a file that is no spectrum file.
std::vector<std::string> expanded_lamps(std::span<const std::string> names);

/// Names for find_material, likewise; the name of a material set becomes its members.
std::vector<std::string> expanded_materials(std::span<const std::string> names);

} // namespace metamer
