#pragma once

/// The planner: which method reaches an error at the least price.

#include <optional>
#include <string>
#include <vector>

#include "lab/study.h"
#include "lab/study_work.h"

namespace proofreel {

/// Rates are looked for among the multiples of this, in steps per second. Samples are those of a study at that rate.
inline constexpr int rate_grain = 30;
/// No higher rates are tried.
inline constexpr int highest_rate = 122'880;

/// What it takes one method to reach the error.
struct PlannedMethod {
  std::string name;
  std::optional<int> rate;            ///< the least that is good enough while the next lower one is not
  double error = 0;                   ///< at that rate
  std::optional<double> error_below;  ///< at the next lower rate; nothing when that is none
  std::optional<double> cost_ms;      ///< CPU time per simulated second
  std::string line;                   ///< for scenario{}: `method = { ... }, rate = 120`; empty for peers
  std::string why_not;                ///< it has no rate; a sentence
};

/// The axes of a search: those given, or every integrator, and a rate to be changed.
std::vector<Axis> axes_of_search(std::vector<Axis> given);

/// For every method of the study (its rates do not matter) the least rate at which the first measure's error is at most
/// `target`, by bisection, and what that costs; the cheapest first, those that do not reach it last. Without a
/// reference a run is compared with one at a step `finer_steps` times smaller.
std::vector<PlannedMethod> plan_for(const Study& study, double target, const StudyWork& work,
                                    const WorkProgress& progress);

/// The error of a method at a rate; nothing when it does not come to its end or the measure has nothing to be compared
/// with.
std::optional<double> error_at_rate(const Study& study, std::size_t method, int rate, double limit_s);

}  // namespace proofreel
