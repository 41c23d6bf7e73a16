#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/run_peer.h"
#include "cli/scenario_files.h"
#include "cli/score_options.h"
#include "golden/json.h"
#include "golden/shell.h"
#include "lab/csv.h"
#include "lab/score_text.h"
#include "lab/study_analysis.h"
#include "lab/study_charts.h"
#include "lab/study_files.h"
#include "lab/study_film.h"
#include "lab/study_map.h"
#include "lab/target.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

struct Options {
  GridOptions grid;
  std::string scenario;
  std::vector<std::string> vary;
  std::vector<std::string> against;
  std::vector<std::string> measures;
  std::string target;
  bool map = false;
  bool instructions = false;
  bool yes = false;
  bool film = false;
};

/// scenario, and runs: {set: {key: value}, state, cpu_ms_per_s (null where it came to no end), cheapest, why} each.
Json json_of(const Grid& grid, const std::vector<RunResult>& results) {
  Json runs = Json::array();
  const std::vector<bool> best = cheapest(grid, results);
  for (std::size_t i = 0; i < results.size(); ++i) {
    Json values = Json::object();
    for (std::size_t k = 0; k < grid.keys.size(); ++k) values[grid.keys[k]] = grid.runs[i].values[k];
    Json run{{"set", values},
             {"state", name_of(results[i].standing)},
             {"cpu_ms_per_s", nullptr},
             {"cheapest", static_cast<bool>(best[i])},
             {"why", results[i].why}};
    if (results[i].cost_ms()) run["cpu_ms_per_s"] = *results[i].cost_ms();
    runs.push_back(run);
  }
  return {{"scenario", grid.runs.front().scenario}, {"runs", runs}};
}

void print(const Grid& grid, const std::vector<RunResult>& results) {
  const std::vector<bool> best = cheapest(grid, results);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Heading& row = grid.rows[i / grid.columns.size()];
    const Heading& column = grid.columns[i % grid.columns.size()];
    const std::string where = label_of(grid, column) + ", " + label_of(grid, row);
    std::printf("%-40s %-12s %10s ms/s%s\n", where.c_str(), name_of(results[i].standing),
                cost_text(results[i].cost_ms()).c_str(), best[i] ? "   the cheapest that stands" : "");
  }
}

int draw_map(const Options& options) {
  require_folder(options.grid);
  const std::vector<Axis> axes = map_axes(options.vary);
  const Grid grid = map_grid(scenario_file(options.scenario), axes, options.grid.common.overrides());
  const GridFiles files = make_grid_files(grid, "map", false, options.grid);
  if (options.grid.json) {
    std::cout << json_text(json_of(grid, files.results), 2) << "\n";
  } else {
    print(grid, files.results);
  }
  return 0;
}

/// Said before anything is planned, since that takes its time too.
void refuse_too_many(const Options& options, const std::vector<Axis>& axes) {
  std::size_t runs = 1;
  for (const Axis& axis : axes) runs *= axis.values.size();
  if (runs <= most_runs_unasked || options.yes) return;
  throw UsageError("That makes " + std::to_string(runs) + " runs, more than " + std::to_string(most_runs_unasked) +
                   ": name fewer values, or say --yes.");
}

Study planned(const Options& options, const std::vector<Axis>& axes) {
  refuse_too_many(options, axes);
  return plan_study({scenario_file(options.scenario), options.grid.common.overrides(), axes,
                     peers_meant(options.against), options.measures});
}

StudyWork work_with(const Options& options) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int threads = options.grid.common.threads;
  return {options.grid.folder, options.grid.limit_s, threads > 0 ? threads : cores, options.instructions,
          std::filesystem::read_symlink("/proc/self/exe")};
}

/// The line of progress, one after the other for each part of the work.
class Phases {
 public:
  explicit Phases(bool quiet) : quiet_(quiet) { begin("runs"); }
  void begin(const std::string& unit) {
    line_.reset();
    line_ = std::make_unique<ProgressLine>(unit, quiet_);
  }
  void update(std::int64_t done, std::int64_t total) {
    stop_if_interrupted();
    line_->update(done, total);
  }

 private:
  bool quiet_;
  std::unique_ptr<ProgressLine> line_;
};

/// One line per method: its order, and the cheapest run for each error worth asking for.
void print(const Study& study, const StudyOutcome& outcome) {
  const std::vector<double> targets = worthwhile_targets(outcome.results);
  std::printf("%-32s", "CPU ms per simulated second");
  for (const double target : targets) std::printf(" %12s", power_text(target).c_str());
  std::printf("\n");
  std::vector<std::vector<std::optional<Winner>>> columns;
  for (const double target : targets)
    columns.push_back(cheapest_by_method(study, outcome.results, WorkAxis::cpu, target));
  for (std::size_t method = 0; method < study.methods.size(); ++method) {
    std::printf("%-32s", study.methods[method].name.c_str());
    for (const auto& column : columns) {
      const std::string cost = column[method] ? cost_text(column[method]->work) : "-";
      std::printf(" %12s", cost.c_str());
    }
    std::printf("\n");
  }
  for (const std::string& sentence : study.left_out) std::printf("left out: %s\n", sentence.c_str());
  const std::string verdict = verdict_of(study, outcome.results);
  if (!verdict.empty()) std::printf("%s\n", verdict.c_str());
}

/// What a film can show at once.
void check_film(const Study& study) {
  if (study.methods.size() >= fewest_filmed && study.methods.size() <= most_filmed) return;
  throw UsageError("--film shows two to six methods side by side, not " + std::to_string(study.methods.size()) +
                   ": name others with --vary.");
}

/// Of each method the run whose CPU time all of them can spend.
void make_film(const Options& options, const Study& study, const StudyOutcome& outcome, const StudyWork& work) {
  const std::vector<std::size_t> runs = runs_of_equal_cost(study, outcome.results);
  if (runs.size() < fewest_filmed) throw UsageError("Too few methods came to their end for a film.");
  const std::vector<Trace> traces = traces_of(study, runs, work, [](std::int64_t, std::int64_t) {});
  FilmSettings settings;
  settings.size = study_film_size;
  settings.fps = fps_of(study);
  const std::string file = (std::filesystem::path(options.grid.folder) / "film.mp4").string();
  const std::unique_ptr<Sink> sink = make_sink(file, settings);
  ProgressLine line("frames", options.grid.common.quiet);
  film_study(study, runs, traces, gl_backend_named(options.grid.common.gl), *sink,
             [&](std::int64_t done, std::int64_t total) {
               stop_if_interrupted();
               line.update(done, total);
             });
}

int make_study(const Options& options) {
  if (options.grid.folder.empty())
    throw UsageError("Name a folder for the table, the page and the diagrams with -o DIR.");
  const Study study = planned(options, parse_axes(options.vary));
  if (options.film) check_film(study);
  const StudyWork work = work_with(options);
  note_interrupts();
  StudyOutcome outcome;
  {
    Phases phases(options.grid.common.quiet);
    outcome = work_off(
        study, work, [&](const char* phase) { phases.begin(phase); },
        [&](std::int64_t done, std::int64_t total) { phases.update(done, total); });
    write_study_files(study, outcome, work, gl_backend_named(options.grid.common.gl), command_line("proofreel"),
                      PROOFREEL_VERSION);
  }
  if (options.film) make_film(options, study, outcome, work);
  if (options.grid.json) {
    std::cout << json_text(json_of(study, outcome), 2) << "\n";
  } else {
    print(study, outcome);
  }
  return 0;
}

double target_in(const std::string& text) {
  const std::optional<double> target = number_in(text);
  if (target && *target > 0 && *target < 1e9) return *target;
  throw UsageError("--target takes the largest error that is allowed, such as 1e-4, not \"" + text + "\".");
}

/// [{name, rate, error, error_below (at the next lower rate), cpu_ms_per_s, line, why_not}], the cheapest first.
Json json_of(const std::vector<PlannedMethod>& plans) {
  Json methods = Json::array();
  for (const PlannedMethod& plan : plans) {
    Json method{{"name", plan.name},       {"rate", nullptr},   {"error", nullptr},       {"error_below", nullptr},
                {"cpu_ms_per_s", nullptr}, {"line", plan.line}, {"why_not", plan.why_not}};
    if (plan.rate) method["rate"] = *plan.rate;
    if (plan.rate) method["error"] = plan.error;
    if (plan.error_below) method["error_below"] = *plan.error_below;
    if (plan.cost_ms) method["cpu_ms_per_s"] = *plan.cost_ms;
    methods.push_back(method);
  }
  return methods;
}

void print(const PlannedMethod& plan) {
  if (!plan.rate) {
    std::printf("%-24s %s\n", plan.name.c_str(), plan.why_not.c_str());
    return;
  }
  const std::string below = plan.error_below ? power_text(*plan.error_below) : "-";
  std::printf("%-24s %9d %12s %12s %12s\n", plan.name.c_str(), *plan.rate, cost_text(plan.cost_ms).c_str(),
              power_text(plan.error).c_str(), below.c_str());
}

/// Exit status 1 when nobody reaches the error.
int plan_target(const Options& options) {
  const double target = target_in(options.target);
  const Study study = planned(options, axes_of_search(parse_axes(options.vary)));
  note_interrupts();
  std::vector<PlannedMethod> plans;
  {
    ProgressLine line("searches", options.grid.common.quiet);
    plans = plan_for(study, target, work_with(options), [&](std::int64_t done, std::int64_t total) {
      stop_if_interrupted();
      line.update(done, total);
    });
  }
  const bool reached = !plans.empty() && plans.front().rate.has_value();
  if (options.grid.json) {
    const Json json{{"scenario", study.scenario},
                    {"measure", study.measures.front().name},
                    {"target", target},
                    {"methods", json_of(plans)},
                    {"left_out", study.left_out}};
    std::cout << json_text(json, 2) << "\n";
    return reached ? 0 : 1;
  }
  std::printf("%-24s %9s %12s %12s %12s\n", "method", "rate", "CPU ms/s", "error", "next rate's");
  for (const PlannedMethod& plan : plans) print(plan);
  for (const std::string& sentence : study.left_out) std::printf("left out: %s\n", sentence.c_str());
  const auto ours = std::find_if(plans.begin(), plans.end(), [](const auto& plan) { return !plan.line.empty(); });
  if (ours != plans.end()) std::printf("\nFor scenario{}:  %s\n", ours->line.c_str());
  return reached ? 0 : 1;
}

int study(const Options& options) {
  if (options.map) return draw_map(options);
  return options.target.empty() ? make_study(options) : plan_target(options);
}

}  // namespace

Subcommand study_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "study", "What accuracy costs: errors against work, by method and by engine",
                              "proofreel study pendulum --vary integrator=verlet,rk4 --vary rate=60,120,240 -o study",
                              options->grid.common);
  app->add_option("SCENARIO", options->scenario, "Path of a .lua file, or an id such as pendulum")->required();
  app->add_option("--vary", options->vary, "An axis; every integrator at rates from 60 to 3840 when none is given")
      ->type_name("KEY=A,B,...")
      ->allow_extra_args(false);
  CLI::Option* against = app->add_option("--against", options->against, "Other engines: box2d, chipmunk")
                             ->delimiter(',')
                             ->type_name("PEERS");
  CLI::Option* measure =
      app->add_option("--measure", options->measures, "Whose error; all that have a reference unless told; repeatable")
          ->type_name("NAME")
          ->allow_extra_args(false);
  app->add_flag("--instructions", options->instructions, "Count instructions too, with valgrind");
  CLI::Option* target =
      app->add_option("--target", options->target, "Find the cheapest method for this error")->type_name("ERROR");
  CLI::Option* map = app->add_flag("--map", options->map, "A map of two axes: where the scenario stands, and its cost");
  app->add_flag("--yes", options->yes, "Yes, more than 10,000 runs");
  add_grid_options(*app, options->grid);
  app->get_option("--threads")
      ->description("Runs at a time while errors are looked at; unless told all cores, --map: 1");
  for (CLI::Option* other : {target, against, measure}) map->excludes(other);
  CLI::Option* film =
      app->add_flag("--film", options->film, "Film two to six methods side by side, and their errors: DIR/film.mp4");
  film->excludes(map)->excludes(target);
  return {app, [options] { return study(*options); }};
}

}  // namespace proofreel
