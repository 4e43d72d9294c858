// What can be told of a shader by reading it: declarations, what they cost, and rules of the house.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace metamer::test {

enum class Stage { vertex, fragment };

/// Words and numbers whole, every other character for itself, white space gone. Of preprocessed text: no
/// comments, no macros.
std::vector<std::string> tokens(std::string_view preprocessed);

/// A global of qualifier `uniform`, `varying` or `attribute`.
struct Declaration {
    std::string qualifier, type, name;
    int size; ///< array elements, 1 for no array

    bool is_sampler() const { return type.starts_with("sampler"); }
};

std::vector<Declaration> declarations(const std::vector<std::string>& tokens);

/// Rows of four components that the declarations of this qualifier need where nothing is packed: one for a
/// scalar or a vector, one per column of a matrix, each array element for itself, none for samplers. GLSL
/// ES 1.00.17 appendix A section 7 packs better: this is an upper bound, whatever a driver drops.
int vectors(const std::vector<Declaration>& declarations, std::string_view qualifier);

/// Samplers, array elements counted.
int samplers(const std::vector<Declaration>& declarations);

/// The rules of the house that this text breaks, one line each: loops other than
/// `for (int i = NUMBER; i < NUMBER; i++)`, while, do, derivatives, explicit levels of detail, textures in
/// vertex shaders (many old GPUs have none), extensions.
std::vector<std::string> broken_rules(Stage stage, const std::vector<std::string>& tokens);

} // namespace metamer::test
