#pragma once

#include <string>
#include <vector>

#include "golden/second_look.h"

namespace proofreel {

/// How one scenario stands against its references and its own expectations.
struct CheckResult {
  std::string scenario;
  std::vector<std::string> warnings;  ///< of loading it
  std::vector<Finding> findings;
  std::vector<ExpectationResult> expectations;
  bool passed() const;
};

/// Runs the scenario file and judges it. A scenario without `golden` that was never blessed is only asked for its
/// expectations. When something differs the scenario is run once more, to find out why; if today's two runs differ,
/// that is the finding. Throws ScenarioError, and EnvironmentError when it draws.
CheckResult check_scenario(const std::string& path, const std::vector<Override>& overrides, const GoldenStore& store,
                           const PictureTools& tools);

/// The ids of a store that are not among `scenarios` (sorted).
std::vector<std::string> orphan_ids(const GoldenStore& store, const std::vector<std::string>& scenarios);

}  // namespace proofreel
