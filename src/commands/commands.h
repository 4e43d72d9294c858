// The commands (DESIGN.md section 6), one file each: NAME_command.cpp.
#pragma once

#include <CLI/App.hpp>

namespace metamer {

/// Registers every command with its options; parsing runs the one that was asked for. They throw Error.
void add_commands(CLI::App& app);

void add_run_command(CLI::App& app);
void add_render_command(CLI::App& app);
void add_measure_command(CLI::App& app);
void add_plan_command(CLI::App& app);
void add_chart_command(CLI::App& app);
void add_stability_command(CLI::App& app);
void add_atlas_command(CLI::App& app);
void add_check_command(CLI::App& app);
void add_info_command(CLI::App& app);
void add_list_command(CLI::App& app);

} // namespace metamer
