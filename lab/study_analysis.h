#pragma once

/// What a study's results say: which runs are worth their price, of which order the methods are, where rounding ends
/// their progress, and who is cheapest for a given error.

#include <optional>
#include <string>
#include <vector>

#include "lab/study.h"

namespace proofreel {

/// What work is counted in.
enum class WorkAxis : std::uint8_t {
  cpu,           ///< ms of CPU time per simulated second
  updates,       ///< of constraint rows and body forces, per simulated second: exact, whatever the machine
  instructions,  ///< per simulated second
};
inline constexpr int work_axis_count = 3;

/// Nothing where it is not known.
std::optional<double> work_of(const StudyResult& result, WorkAxis axis);

/// For every point, whether no other one is both cheaper (or as cheap) and more accurate (or as accurate). Points that
/// lack one of the two are not.
std::vector<bool> pareto_front(const std::vector<std::optional<double>>& work,
                               const std::vector<std::optional<double>>& errors);

/// error ~ step^order, between two of a method's runs.
struct FittedOrder {
  double order = 0;
  std::size_t first = 0;  ///< of the coarsest run that was used, counted from the method's first
  std::size_t last = 0;   ///< of the finest one
};

/// The order over the finest runs that agree upon one: at least three in a row, halvings or the like, between each two
/// of which the order is the same to `order_agreement`. Nothing when there are none, as it is with impacts or rounding.
std::optional<FittedOrder> fitted_order(const std::vector<double>& steps_s,
                                        const std::vector<std::optional<double>>& errors);
inline constexpr double order_agreement = 0.15;

/// The least error a method gets to before smaller steps make it larger again, or no smaller: rounding, or an error of
/// the model. Nothing when the finest run is still the best by far, and for who never got better in the first place.
std::optional<double> error_floor(const std::vector<std::optional<double>>& errors);

/// The cheapest run with an error of at most `target`, of each method; nothing where it is not reached.
struct Winner {
  std::size_t run = 0;  ///< in Study::runs
  double work = 0;
};
std::vector<std::optional<Winner>> cheapest_by_method(const Study& study, const std::vector<StudyResult>& results,
                                                      WorkAxis axis, double target);

/// Errors a table may ask for: whole powers of ten that at least one run reaches and another does not, from the
/// largest.
std::vector<double> worthwhile_targets(const std::vector<StudyResult>& results);

/// "for an error of 1e-4, suzuki4 at rate 120 is the cheapest: 0.21 ms per simulated second; verlet needs 5.1 times
/// that". The target is the middle one of the worthwhile ones. Empty when nothing can be said.
std::string verdict_of(const Study& study, const std::vector<StudyResult>& results);
std::string verdict_for(const Study& study, const std::vector<StudyResult>& results, double target);

/// The errors of the first measure.
std::vector<std::optional<double>> first_errors(const std::vector<StudyResult>& results);

/// "rate 120", or empty where nothing is refined.
std::string step_name(const Study& study, const StudyRun& run);

/// "1e-4"; other numbers with three digits.
std::string power_text(double value);

}  // namespace proofreel
