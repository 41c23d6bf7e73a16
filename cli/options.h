#pragma once

/// What the subcommands' options have in common. The command line library enters here and nowhere else.

#include <CLI/CLI.hpp>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace proofreel {

/// A subcommand: the words it is called by, and what it does once they are read. `run` returns the exit status.
struct Subcommand {
  CLI::App* app = nullptr;
  std::function<int()> run;
};

/// The options every subcommand takes.
struct CommonOptions {
  std::vector<std::string> set;  ///< KEY=VALUE each
  std::string gl;                ///< "osmesa", "egl" or empty
  int threads = 0;               ///< 0: as many as the machine has cores
  bool quiet = false;

  /// Throws UsageError for a `--set` without `=`.
  std::vector<Override> overrides() const;
};

/// A subcommand of `program` that takes the common options; `example` ends its help. `options` must outlive it.
CLI::App* add_command(CLI::App& program, const char* name, const char* description, const char* example,
                      CommonOptions& options);

/// Throws UsageError for a word without a letter and for an option that ends in `=`: what nobody wrote would otherwise
/// count as an option that was not given.
void refuse_empty_words(std::span<char* const> words);

/// Words for the user, on standard error, each on a line of its own.
void say(const std::string& words);
void say_all(const std::vector<std::string>& sentences);

}  // namespace proofreel
