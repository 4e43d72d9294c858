// The one place that asks for extensions: every one is optional, and the program must do without.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace metamer {

/// Every extension of the current context, as the driver lists them.
std::vector<std::string> present_gl_extensions();

/// Whether the program may use this extension: the driver lists it, and the environment does not say
/// METAMER_GL_EXTENSIONS=none (for tests of the paths without). Needs a current context.
bool use_gl_extension(std::string_view name);

/// Those that the program uses in this context, of all that it knows a use for.
std::vector<std::string> used_gl_extensions();

/// Whether a list as EGL and GL give it, names parted by blanks, holds this name; under
/// METAMER_GL_EXTENSIONS=none it does not. For EGL display extensions; `list` may be nullptr.
bool use_listed_extension(const char* list, std::string_view name);

} // namespace metamer
