#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>

#include "cli/commands.h"
#include "cli/in_order.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/scenario_files.h"
#include "lab/gallery.h"
#include "render/output_file.h"
#include "scenarios/source.h"

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

Filmed filmed(const Options& options, const std::string& file, std::optional<GlBackend> gl) {
  try {
    return {film_for_gallery(file, options.common.overrides(), options.out, gl,
                             [](std::int64_t, std::int64_t) { stop_if_interrupted(); }),
            {}};
  } catch (const ScenarioError& error) {
    return {std::nullopt, error.what()};
  }
}

using Entries = std::map<std::string, GalleryEntry>;

/// Films all, several at a time, and tells what could not be filmed.
Entries film_all(const Options& options, const std::vector<std::string>& files, bool& good) {
  const std::optional<GlBackend> gl = gl_backend_named(options.common.gl);
  InOrder<Filmed> films(
      [&]() -> InOrder<Filmed>::Worker { return [&](std::size_t i) { return filmed(options, files[i], gl); }; });
  Entries entries;
  ProgressLine line("scenarios", options.common.quiet);
  std::int64_t done = 0;
  films.run(files.size(), jobs_or_cores(options.jobs), [&](Filmed one) {
    stop_if_interrupted();
    line.update(++done, static_cast<std::int64_t>(files.size()));
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

int gallery(const Options& options) {
  const std::string folder = options.scenarios.empty() ? scenarios_folder() : options.scenarios;
  const std::vector<std::string> files = scenario_files_in(folder);
  std::vector<std::string> ids;
  std::transform(files.begin(), files.end(), std::back_inserter(ids), id_of);
  const std::vector<GalleryChapter> chapters = gallery_chapters(folder, ids);
  make_folder(options.out);
  note_interrupts();
  setenv("LP_NUM_THREADS", "0",
         0);  // films are made side by side; the drawer's own threads would only take turns with them
  bool good = true;
  Entries entries = film_all(options, files, good);
  const std::filesystem::path project = std::filesystem::absolute(folder).lexically_normal() / "..";
  const std::string to_project = std::filesystem::relative(project, options.out).generic_string();
  const std::string page = (std::filesystem::path(options.out) / "index.html").string();
  write_file(page, gallery_page(in_chapters(chapters, std::move(entries)), to_project));
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
