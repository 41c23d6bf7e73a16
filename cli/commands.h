#pragma once

/// The subcommands, one file each.

#include "cli/options.h"

namespace proofreel {

Subcommand list_command(CLI::App& program);
Subcommand run_command(CLI::App& program);
Subcommand check_command(CLI::App& program);
Subcommand explain_command(CLI::App& program);
#ifdef PROOFREEL_PICTURES
Subcommand render_command(CLI::App& program);
Subcommand bless_command(CLI::App& program);
Subcommand diff_command(CLI::App& program);
Subcommand report_merge_command(CLI::App& program);
Subcommand doctor_command(CLI::App& program);
Subcommand study_command(CLI::App& program);
Subcommand scorecard_command(CLI::App& program);
Subcommand gallery_command(CLI::App& program);
#endif
/// Subcommands this program does not have; calling one is a UsageError that says why.
std::vector<Subcommand> absent_commands(CLI::App& program);

}  // namespace proofreel
