#include "cli/commands.h"
#ifndef PROOFREEL_PICTURES
#include "cli/run_peer.h"
#include "golden/report_folder.h"
#endif
#include "render/usage_error.h"

namespace proofreel {
#ifndef PROOFREEL_PICTURES
namespace {

Subcommand absent(CLI::App& program, const char* name, const char* why) {
  CLI::App* command = program.add_subcommand(name, why)->allow_extras()->group("");
  command->set_help_flag();
  const auto refuse = [name, why]() -> int { throw UsageError(std::string("proofreel ").append(name).append(why)); };
  return {command, refuse};
}

}  // namespace
#endif

std::vector<Subcommand> absent_commands([[maybe_unused]] CLI::App& program) {
  std::vector<Subcommand> commands;
#ifndef PROOFREEL_PICTURES
  for (const char* name : {"render", "bless", "diff", "report-merge", "doctor", "study", "scorecard", "gallery"}) {
    commands.push_back(absent(program, name, " is not in this build, which has no pictures (PROOFREEL_PICTURES=OFF)."));
  }
#endif
  return commands;
}

#ifndef PROOFREEL_PICTURES
PeerRun peer_run(const std::string&, const Scenario&) {
  throw UsageError("--peer is not in this build, which has no other engines (PROOFREEL_PICTURES=OFF).");
}

ReportFolder::ReportFolder(std::filesystem::path) {
  throw UsageError("--report is not in this build, which has no pictures (PROOFREEL_PICTURES=OFF).");
}
void ReportFolder::add_pictures(ReportItem&, const std::string&, const std::filesystem::path&, const Image&) const {}
void ReportFolder::finish(const Report&) const {}
#endif

}  // namespace proofreel
