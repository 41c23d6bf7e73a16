#pragma once

#include <string>
#include <vector>

#include "golden/pictures.h"

namespace proofreel {

/// What blessing one scenario did.
struct BlessResult {
  std::string scenario;
  std::vector<std::string> warnings;  ///< of loading it
  std::vector<std::string> changes;   ///< one sentence each; empty when all was as kept
  std::vector<ExpectationResult> expectations;
};

/// Runs the scenario and keeps what it shows now as its reference. Writes only what changed; the tolerance is kept.
/// Pictures no golden frame uses are removed when `prune`, else only told about. Throws ScenarioError and
/// EnvironmentError.
BlessResult bless_scenario(const std::string& path, const std::vector<Override>& overrides, const GoldenStore& store,
                           Pictures& pictures, bool prune);

}  // namespace proofreel
