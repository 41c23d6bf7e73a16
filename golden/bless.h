#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "golden/pictures.h"

namespace proofreel {

/// What blessing will do. Nothing is written or removed before `carry_out`, so that it can be told first.
struct BlessPlan {
  std::string scenario;
  std::vector<std::string> warnings;  ///< of loading it
  std::vector<std::string> changes;   ///< one sentence each; empty when all stays as it is
  std::vector<ExpectationResult> expectations;
  std::vector<std::pair<std::filesystem::path, std::vector<std::uint8_t>>> files;  ///< what will be in them
  std::vector<std::filesystem::path> removed;

  /// Pictures first, golden.json last. Throws EnvironmentError.
  void carry_out() const;
};

/// Runs the scenario to find out what has to be kept so that it passes. Frames that pass stay as they are, and so does
/// the tolerance; what only explains failures (see golden/store.h) is added where it is missing. Pictures no golden
/// frame uses are removed when `prune`, else only told about. Throws ScenarioError and EnvironmentError.
BlessPlan plan_blessing(const std::string& path, const std::vector<Override>& overrides, const GoldenStore& store,
                        Pictures& pictures, bool prune);

/// Removes what is kept of a scenario that is gone.
BlessPlan plan_removal(const GoldenStore& store, const std::string& id);

}  // namespace proofreel
