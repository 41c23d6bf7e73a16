#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>

#include "cli/commands.h"
#include "cli/in_order.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/scenario_files.h"
#include "lab/gallery.h"
#include "render/output_file.h"

namespace proofreel {
namespace {

struct Options {
  CommonOptions common;
  std::string scenarios;
  std::string out;
  int jobs = 0;
};

/// What became of one scenario: its film, or why it cannot be filmed.
struct Filmed {
  std::optional<GalleryEntry> entry;
  std::string error;
};

Filmed filmed(const Options& options, const GalleryScenario& which, std::optional<GlBackend> gl) {
  try {
    return {film_for_gallery(which, options.common.overrides(), options.out, gl,
                             [](std::int64_t, std::int64_t) { stop_if_interrupted(); }),
            {}};
  } catch (const ScenarioError& error) {
    return {std::nullopt, error.what()};
  }
}

using Entries = std::map<std::string, GalleryEntry>;

/// Films all, several at a time, and tells what could not be filmed.
Entries film_all(const Options& options, const std::vector<GalleryScenario>& scenarios, bool& good) {
  const std::optional<GlBackend> gl = gl_backend_named(options.common.gl);
  InOrder<Filmed> films(
      [&]() -> InOrder<Filmed>::Worker { return [&](std::size_t i) { return filmed(options, scenarios[i], gl); }; });
  Entries entries;
  ProgressLine line("scenarios", options.common.quiet);
  std::int64_t done = 0;
  films.run(scenarios.size(), jobs_or_cores(options.jobs), [&](Filmed one) {
    stop_if_interrupted();
    line.update(++done, static_cast<std::int64_t>(scenarios.size()));
    if (one.entry) {
      entries.emplace(one.entry->id, std::move(*one.entry));
    } else {
      say(one.error);
      good = false;
    }
  });
  return entries;
}

std::vector<FilmedChapter> in_chapters(const std::vector<GalleryChapter>& chapters, Entries entries) {
  std::vector<FilmedChapter> filled;
  for (const GalleryChapter& chapter : chapters) {
    FilmedChapter one{chapter, {}};
    for (const std::string& id : chapter.ids) {
      const auto entry = entries.find(id);
      if (entry != entries.end()) one.entries.push_back(std::move(entry->second));
    }
    if (!one.entries.empty()) filled.push_back(std::move(one));
  }
  return filled;
}

/// The scenarios of the collection have ids that `render` knows; those of another folder it knows by their files.
std::vector<GalleryScenario> scenarios_in(const std::string& folder, bool is_collection) {
  std::vector<GalleryScenario> scenarios;
  for (const std::string& file : scenario_files_in(folder)) {
    const std::string id = std::filesystem::path(file).lexically_relative(folder).replace_extension().generic_string();
    scenarios.push_back({file, id, is_collection ? id : file});
  }
  return scenarios;
}

/// The way from the gallery to the project whose engine is at work; empty where it does not lie beside the scenarios.
std::string way_to_project(const std::string& folder, const std::string& out) {
  const std::filesystem::path project = std::filesystem::absolute(folder).lexically_normal() / "..";
  if (!std::filesystem::is_directory(project / "engine")) return {};
  return std::filesystem::relative(project, out).generic_string();
}

int gallery(const Options& options) {
  const std::string folder = options.scenarios.empty() ? scenarios_folder() : options.scenarios;
  const std::vector<GalleryScenario> scenarios = scenarios_in(folder, options.scenarios.empty());
  std::vector<std::string> ids;
  for (const GalleryScenario& scenario : scenarios) ids.push_back(scenario.id);
  const std::vector<GalleryChapter> chapters = gallery_chapters(folder, ids);
  open_gallery(options.out);
  note_interrupts();
  setenv("LP_NUM_THREADS", "0",
         0);  // films are made side by side; the drawer's own threads would only take turns with them
  bool good = true;
  Entries entries = film_all(options, scenarios, good);
  const std::string page = (std::filesystem::path(options.out) / "index.html").string();
  write_file(page, gallery_page(in_chapters(chapters, std::move(entries)), way_to_project(folder, options.out)));
  if (!options.common.quiet) say("The gallery is " + page + ".");
  return good ? 0 : 2;
}

}  // namespace

Subcommand gallery_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "gallery", "Film all scenarios and show them on a page beside their sources",
                              "proofreel gallery -o gallery", options->common);
  app->add_option("DIR", options->scenarios, "A folder of scenarios with a contents.json, instead of the collection");
  app->add_option("-o,--output", options->out, "The folder of the page and its films")->required()->type_name("DIR");
  app->add_option("--jobs", options->jobs, "Scenarios filmed side by side; as many as there are cores unless told")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  return {app, [options] { return gallery(*options); }};
}

}  // namespace proofreel
