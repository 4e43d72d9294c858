// dump_shaders DIR: writes every shader variant as a driver gets it, NAME.vert and NAME.frag.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "base/files.h"
#include "gles/shader_source.h"
#include "render/variants.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: dump_shaders DIR\n");
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        const metamer::ShaderFiles files = metamer::shader_files();
        for (const metamer::ShaderVariant& variant : metamer::shader_variants()) {
            metamer::write_file(folder / (variant.name + ".vert"),
                                metamer::compose_shader(variant.vertex, variant.defines, files).text);
            metamer::write_file(folder / (variant.name + ".frag"),
                                metamer::compose_shader(variant.fragment, variant.defines, files).text);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dump_shaders: %s\n", error.what());
        return 1;
    }
    return 0;
}
