#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/scenario_files.h"

namespace proofreel {
namespace {

struct Options {
  CommonOptions common;
  std::string folder;
};

std::string effects_text(const Scene& scene) {
  const EffectSet effects = effects_of(scene);
  std::string text;
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    if (effects.has(effect)) text.append(text.empty() ? "" : " ").append(name_of(effect));
  }
  return text;
}

void print(const Scenario& scenario) {
  const std::size_t panes = 1 + scenario.other_panes.size();
  const std::string split = panes > 1 ? ", " + std::to_string(panes) + " panes" : "";
  std::printf("%-24s %6g s %5zu bodies  %s  (%s%s)\n", scenario.id.c_str(), scenario.duration,
              scenario.scene.bodies.size(), scenario.title.c_str(), effects_text(scenario.scene).c_str(),
              split.c_str());
}

int list(const Options& options) {
  int status = 0;
  for (const std::string& file : scenario_files_in(options.folder.empty() ? scenarios_folder() : options.folder)) {
    try {
      print(*load_scenario(file, options.common.overrides()));
    } catch (const ScenarioError& error) {
      say(error.what());
      status = 2;
    }
  }
  return status;
}

}  // namespace

Subcommand list_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "list", "Scenarios with title, duration, bodies and effects",
                              "proofreel list scenarios", options->common);
  app->add_option("DIR", options->folder, "Folder to look in, instead of the collection");
  return {app, [options] { return list(*options); }};
}

}  // namespace proofreel
