#include "cli/score_options.h"

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "golden/shell.h"
#include "lab/csv.h"
#include "lab/score_files.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

/// CLI::Range lets pass what is not a number, since that is neither below nor above; then every run is too slow.
std::string problem_with_limit(const std::string& text) {
  const std::optional<double> seconds = number_in(text);
  if (seconds && *seconds >= 0.1 && *seconds <= 86400) return {};
  return "it goes from 0.1 to 86400 seconds, so not " + text;
}

}  // namespace

void add_grid_options(CLI::App& command, GridOptions& options) {
  command.add_option("-o,--output", options.folder, "Folder for the table, the page and the pictures")
      ->type_name("DIR");
  command.add_option("--limit", options.limit_s, "CPU seconds the steps of a run may take; 10 unless told")
      ->type_name("SECONDS")
      ->check(problem_with_limit, "0.1 to 86400");
  command.add_flag("--json", options.json, "Print one JSON object instead of text");
  command.get_option("--threads")->description("Runs at a time; 1 unless told, since runs beside others take longer");
  command.get_option("--gl")->description("Draw stills and the map through osmesa or egl");
}

void require_folder(const GridOptions& options) {
  if (options.folder.empty()) throw UsageError("Name a folder for the table, the page and the pictures with -o DIR.");
}

GridFiles make_grid_files(const Grid& grid, const std::string& name, bool with_scores, const GridOptions& options) {
  const GridWork work{options.folder, name + ".csv", options.limit_s, std::max(1, options.common.threads),
                      gl_backend_named(options.common.gl)};
  note_interrupts();
  GridFiles files;
  {
    ProgressLine progress("runs", options.common.quiet);
    files.results = work_off(grid, work, [&](std::int64_t done, std::int64_t total) {
      stop_if_interrupted();
      progress.update(done, total);
    });
  }
  if (with_scores) files.scores = scores_of(grid, files.results);
  write_score_files(grid, files.results, files.scores, work, command_line("proofreel"), PROOFREEL_VERSION);
  return files;
}

}  // namespace proofreel
