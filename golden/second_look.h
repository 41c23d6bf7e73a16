#pragma once

/// What a second run of a failing scenario adds to what is said of it: since which tick, who was first, and whose the
/// pixels are that differ.

#include "golden/judge.h"

namespace proofreel {

/// Why a picture differs.
struct PictureWhy {
  std::vector<Cause> causes;
  std::string likeness;  ///< a sentence, or empty
};

/// Explains a picture that differs; the frame and the observed frame are today's.
using ExplainPicture =
    std::function<PictureWhy(const Golden&, const GoldenFrame&, const Scenario&, const Frame&, const ObservedFrame&)>;

/// All that is done about pictures; left empty where only states are compared.
struct PictureTools {
  MakePicture make;
  JudgePicture judge;
  ExplainPicture explain;
};

/// Runs the scenario, which must be loaded afresh, once more. When it does not do the same again, the findings are
/// that; else they are those of the first run with their reasons.
std::vector<Finding> findings_of_second_run(Scenario& again, const GoldenStore& store, const Golden& golden,
                                            const PictureTools& tools, const Observation& first,
                                            std::vector<Finding> findings);

}  // namespace proofreel
