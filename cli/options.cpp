#include "cli/options.h"

#include <iostream>

#include "render/usage_error.h"

namespace proofreel {

std::vector<Override> CommonOptions::overrides() const {
  std::vector<Override> overrides;
  for (const std::string& text : set) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw UsageError("--set takes KEY=VALUE, such as duration=2, not \"" + text + "\".");
    }
    overrides.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return overrides;
}

CLI::App* add_command(CLI::App& program, const char* name, const char* description, const char* example,
                      CommonOptions& options) {
  CLI::App* command = program.add_subcommand(name, description);
  command->footer(std::string("Example: ").append(example));
  command->add_option("--set", options.set, "Replace a key of scenario{}: duration=2, substeps=8; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--gl", options.gl, "Draw through osmesa or egl, instead of the first that works")
      ->check(CLI::IsMember({"osmesa", "egl"}));
  command->add_option("--threads", options.threads, "Cores to use for drawing and encoding")->check(CLI::Range(1, 256));
  command->add_flag("--quiet", options.quiet, "No words but errors");
  return command;
}

void say(const std::string& words) { std::cerr << words << "\n"; }

void say_all(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) say(sentence);
}

}  // namespace proofreel
