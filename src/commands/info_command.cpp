// metamer info: what the GL is, says and does.
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands/command_line.h"
#include "commands/commands.h"
#include "gles/info.h"
#include "gles/surfaceless.h"

namespace metamer {

namespace {

nlohmann::ordered_json to_json(const FragmentPrecision& p, int measured_bits) {
    return {{"reported_bits", p.reported_bits},
            {"range_min_log2", p.range_min_log2},
            {"range_max_log2", p.range_max_log2},
            {"measured_bits", measured_bits}};
}

nlohmann::ordered_json to_json(const GlInfo& info) {
    const GlLimits& limits = info.limits;
    return {
        {"gl_vendor", info.vendor},
        {"gl_renderer", info.renderer},
        {"gl_version", info.version},
        {"shading_language", info.shading_language},
        {"fragment_highp", info.highp.reported_bits > 0},
        {"fragment_mediump_bits", info.measured_mediump_bits},
        {"fragment_precision",
         {{"mediump", to_json(info.mediump, info.measured_mediump_bits)},
          {"highp", to_json(info.highp, info.measured_highp_bits)}}},
        {"max_fragment_uniform_vectors", limits.max_fragment_uniform_vectors},
        {"max_vertex_uniform_vectors", limits.max_vertex_uniform_vectors},
        {"max_varying_vectors", limits.max_varying_vectors},
        {"max_vertex_attribs", limits.max_vertex_attribs},
        {"max_texture_image_units", limits.max_texture_image_units},
        {"max_vertex_texture_image_units", limits.max_vertex_texture_image_units},
        {"max_combined_texture_image_units", limits.max_combined_texture_image_units},
        {"max_texture_size_px", limits.max_texture_size_px},
        {"max_renderbuffer_size_px", limits.max_renderbuffer_size_px},
        {"max_viewport_px", {limits.max_viewport_width_px, limits.max_viewport_height_px}},
        {"extensions_used", info.extensions_used},
        {"extensions", info.extensions},
    };
}

void print_text(const GlInfo& info) {
    const nlohmann::ordered_json document = to_json(info);
    for (const auto& [key, value] : document.items())
        if (key != "extensions" && key != "fragment_precision")
            std::cout << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump()) << '\n';
    std::cout << "fragment mediump: " << info.mediump.reported_bits << " bits reported, "
              << info.measured_mediump_bits << " measured\nfragment highp: " << info.highp.reported_bits
              << " bits reported, " << info.measured_highp_bits
              << " measured\nextensions: " << info.extensions.size() << " (--json lists them)\n";
}

} // namespace

void add_info_command(CLI::App& app) {
    auto json = std::make_shared<bool>(false);
    CLI::App* command =
        app.add_subcommand("info", "GL vendor, renderer, version, precisions, limits, extensions used");
    command->add_flag("--json", *json, "print one JSON document");
    command->callback([json] {
        const Surfaceless context;
        const GlInfo info = gl_info();
        if (*json)
            print_json(to_json(info));
        else
            print_text(info);
    });
}

} // namespace metamer
