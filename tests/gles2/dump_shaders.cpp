// dump_shaders DIR [--ends]: writes shader variants as a driver gets them, NAME.vert and NAME.frag: every
// one; or, for compilers that take long, those that leave nothing out, under 1, 2, 3 and 8 lamps, with no
// shadows and with as many as can be.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "exhibit/exhibit.h"
#include "gles/shader_files.h"
#include "render/variants.h"

namespace {

bool is_end(const metamer::Variant& v) {
    const bool few = v.lamps <= 3 || v.lamps == metamer::kMostLamps;
    const bool bounce = v.surface == metamer::Surface::bounce;
    const bool whole = !v.lit || (v.mirrors && v.smooth && (v.placed || bounce));
    const bool shadows = v.shadows == 0 || v.shadows == std::min(v.lamps, metamer::kMostShadows);
    return few && whole && shadows && v.output == metamer::OutputStage();
}

std::vector<metamer::ShaderVariant> end_variants() {
    std::vector<metamer::ShaderVariant> out{metamer::shadow_variant(), metamer::picture_variant(false),
                                            metamer::picture_variant(true)};
    for (const metamer::Variant& variant : metamer::all_variants())
        if (is_end(variant))
            out.push_back(metamer::shader_variant(variant));
    return out;
}

void write(const std::filesystem::path& folder, const metamer::ShaderVariant& variant) {
    const metamer::ShaderFiles files = metamer::shader_files();
    metamer::write_file(folder / (variant.name + ".vert"),
                        metamer::compose_shader(variant.vertex, variant.defines, files).text);
    metamer::write_file(folder / (variant.name + ".frag"),
                        metamer::compose_shader(variant.fragment, variant.defines, files).text);
}

} // namespace

int main(int argc, char** argv) {
    const bool ends = argc == 3 && std::string_view(argv[2]) == "--ends";
    if (argc != 2 && !ends) {
        std::fprintf(stderr, "usage: dump_shaders DIR [--ends]\n");
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        for (const metamer::ShaderVariant& variant : ends ? end_variants() : metamer::shader_variants())
            write(folder, variant);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dump_shaders: %s\n", error.what());
        return 1;
    }
    return 0;
}
