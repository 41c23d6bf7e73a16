#include "cli/options.h"

#include <iostream>
#include <string_view>

#include "render/usage_error.h"

namespace proofreel {
namespace {

/// An option with nothing after its `=`, such as "--csv=".
bool ends_in_equals(std::string_view word) { return word.starts_with("--") && word.find('=') == word.size() - 1; }

}  // namespace

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

void refuse_empty_words(std::span<char* const> words) {
  const std::string advice = "\": write there what is meant, or leave it out.";
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string word = words[i];
    if (word.empty()) throw UsageError("There is an empty word after \"" + std::string(words[i - 1]) + advice);
    if (ends_in_equals(word)) throw UsageError("There is nothing after \"" + word + advice);
  }
}

void say(const std::string& words) { std::cerr << words << "\n"; }

void say_all(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) say(sentence);
}

}  // namespace proofreel
