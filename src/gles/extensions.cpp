#include "gles/extensions.h"

#include <GLES2/gl2.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

namespace metamer {

namespace {
/// Every GL extension that the program has a use for.
constexpr std::array<std::string_view, 4> kKnownGlExtensions = {
    "GL_OES_rgb8_rgba8",           // framebuffer.cpp: RGBA8 renderbuffers
    "GL_EXT_disjoint_timer_query", // timer_query.cpp: the GPU's own clock
    "GL_EXT_robustness",           // window/sdl_stage.cpp: whether the context was lost
    "GL_KHR_robustness",           // the same, by its later name
};

bool switched_off() {
    const char* choice = std::getenv("METAMER_GL_EXTENSIONS");
    return choice != nullptr && std::string_view(choice) == "none";
}

std::vector<std::string> words(const char* list) {
    std::istringstream stream(list == nullptr ? "" : list);
    std::vector<std::string> names;
    for (std::string name; stream >> name;)
        names.push_back(name);
    return names;
}
} // namespace

std::vector<std::string> present_gl_extensions() {
    return words(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)));
}

bool use_gl_extension(std::string_view name) {
    return use_listed_extension(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)), name);
}

std::vector<std::string> used_gl_extensions() {
    std::vector<std::string> used;
    for (const std::string_view name : kKnownGlExtensions)
        if (use_gl_extension(name))
            used.emplace_back(name);
    return used;
}

bool use_listed_extension(const char* list, std::string_view name) {
    const std::vector<std::string> listed = words(list);
    return !switched_off() && std::find(listed.begin(), listed.end(), name) != listed.end();
}

} // namespace metamer
