#include "lab/study_analysis.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "scenarios/formatted.h"

namespace proofreel {
namespace {

bool usable(std::optional<double> number) { return number && std::isfinite(*number) && *number > 0; }

/// Orders between neighbours; nothing where one of them has no error.
std::vector<std::optional<double>> local_orders(const std::vector<double>& steps_s,
                                                const std::vector<std::optional<double>>& errors) {
  std::vector<std::optional<double>> orders;
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
    const bool both = usable(errors[i]) && usable(errors[i + 1]) && steps_s[i] > steps_s[i + 1];
    orders.push_back(both ? std::optional(std::log(*errors[i] / *errors[i + 1]) / std::log(steps_s[i] / steps_s[i + 1]))
                          : std::nullopt);
  }
  return orders;
}

/// Least squares through log(error) over log(step) of the runs `first` to `last`.
double slope(const std::vector<double>& steps_s, const std::vector<std::optional<double>>& errors, std::size_t first,
             std::size_t last) {
  double n = 0;
  double sx = 0;
  double sy = 0;
  double sxx = 0;
  double sxy = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const double x = std::log(steps_s[i]);
    const double y = std::log(*errors[i]);
    n += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// A method beside the winner: how many times the work it needs, or that it never gets there.
std::string comparison(const StudiedMethod& method, const std::optional<Winner>& own, const Winner& best) {
  if (!own) return method.name + " does not reach it";
  return method.name + " needs " + formatted("%.2g", own->work / best.work) + " times that";
}

}  // namespace

std::optional<double> work_of(const StudyResult& result, WorkAxis axis) {
  if (result.simulated_s <= 0) return std::nullopt;
  const auto rate = [&](auto count) { return static_cast<double>(count) / result.simulated_s; };
  if (axis == WorkAxis::cpu) return result.cpu_s ? std::optional(1e3 * rate(*result.cpu_s)) : std::nullopt;
  if (axis == WorkAxis::instructions)
    return result.instructions ? std::optional(rate(*result.instructions)) : std::nullopt;
  if (!result.row_updates || !result.evaluations) return std::nullopt;
  return rate(*result.row_updates + *result.evaluations);
}

std::vector<bool> pareto_front(const std::vector<std::optional<double>>& work,
                               const std::vector<std::optional<double>>& errors) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < work.size(); ++i) {
    if (work[i] && errors[i] && std::isfinite(*errors[i])) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(*work[a], *errors[a], a) < std::tuple(*work[b], *errors[b], b);
  });
  std::vector<bool> front(work.size(), false);
  std::optional<double> best;
  for (const std::size_t i : order) {
    if (best && *errors[i] >= *best) continue;
    best = *errors[i];
    front[i] = true;
  }
  return front;
}

std::optional<FittedOrder> fitted_order(const std::vector<double>& steps_s,
                                        const std::vector<std::optional<double>>& errors) {
  constexpr double least_order = 0.3;    // below, smaller steps do not pay
  constexpr double largest_error = 0.3;  // above, the run has lost its way, and what looks like an order is chance
  const std::vector<std::optional<double>> orders = local_orders(steps_s, errors);
  for (std::size_t last = orders.size(); last-- > 1;) {
    if (!orders[last] || !orders[last - 1] || *orders[last] < least_order) continue;
    if (std::abs(*orders[last] - *orders[last - 1]) > order_agreement || *errors[last - 1] > largest_error) continue;
    return FittedOrder{slope(steps_s, errors, last - 1, last + 1), last - 1, last + 1};
  }
  return std::nullopt;
}

std::optional<double> error_floor(const std::vector<std::optional<double>>& errors) {
  constexpr double still_falls = 0.8;
  constexpr double has_fallen = 0.1;
  std::optional<std::size_t> best;
  double most = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (!usable(errors[i])) continue;
    if (!best || *errors[i] < *errors[*best]) best = i;
    most = std::max(most, *errors[i]);
  }
  if (!best || *best == 0 || *errors[*best] > has_fallen * most) return std::nullopt;
  const auto later = errors.begin() + static_cast<std::ptrdiff_t>(*best) + 1;
  if (std::any_of(later, errors.end(), usable)) return *errors[*best];
  if (later != errors.end()) return std::nullopt;  // nobody knows what smaller steps would have done
  const std::optional<double>& before = errors[*best - 1];
  return usable(before) && *errors[*best] > still_falls * *before ? errors[*best] : std::nullopt;
}

std::vector<std::optional<Winner>> cheapest_by_method(const Study& study, const std::vector<StudyResult>& results,
                                                      WorkAxis axis, double target) {
  std::vector<std::optional<Winner>> winners(study.methods.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::optional<double> work = work_of(results[i], axis);
    const std::optional<double> error = results[i].errors.empty() ? std::nullopt : results[i].errors[0];
    if (!work || !error || !(*error <= target)) continue;
    std::optional<Winner>& winner = winners[study.runs[i].method];
    if (!winner || *work < winner->work) winner = Winner{i, *work};
  }
  return winners;
}

std::vector<double> worthwhile_targets(const std::vector<StudyResult>& results) {
  double least = INFINITY;
  double most = 0;
  for (const std::optional<double>& error : first_errors(results)) {
    if (!error || !std::isfinite(*error)) continue;
    least = std::min(least, *error);
    most = std::max(most, *error);
  }
  std::vector<double> targets;
  for (int exponent = 0; exponent >= -14; --exponent) {
    const double target = std::pow(10.0, exponent);
    if (target >= least && target < most) targets.push_back(target);
  }
  return targets;
}

std::string verdict_for(const Study& study, const std::vector<StudyResult>& results, double target) {
  const std::vector<std::optional<Winner>> winners = cheapest_by_method(study, results, WorkAxis::cpu, target);
  std::size_t best = winners.size();
  for (std::size_t i = 0; i < winners.size(); ++i) {
    if (winners[i] && (best == winners.size() || winners[i]->work < winners[best]->work)) best = i;
  }
  if (best == winners.size()) return {};
  const Winner& winner = *winners[best];
  const std::string step = step_name(study, study.runs[winner.run]);
  const std::string error = study.measures.front().has_reference
                                ? "an error of " + power_text(target)
                                : "a difference of " + power_text(target) + " from itself at a far smaller step";
  std::string sentence = "For " + error + ", " + study.methods[best].name + (step.empty() ? "" : " at " + step) +
                         " is the cheapest: " + formatted("%.2g", winner.work) + " ms per simulated second";
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < winners.size(); ++i) {
    if (i != best) others.push_back(i);
  }
  std::stable_sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) {
    const auto work = [&](std::size_t i) { return winners[i] ? winners[i]->work : INFINITY; };
    return work(a) < work(b);
  });
  for (const std::size_t i : others) sentence += "; " + comparison(study.methods[i], winners[i], winner);
  return sentence + ".";
}

std::string verdict_of(const Study& study, const std::vector<StudyResult>& results) {
  const std::vector<double> targets = worthwhile_targets(results);
  return targets.empty() ? std::string() : verdict_for(study, results, targets[targets.size() / 2]);
}

std::vector<std::optional<double>> first_errors(const std::vector<StudyResult>& results) {
  std::vector<std::optional<double>> errors;
  for (const StudyResult& result : results) errors.push_back(result.errors.empty() ? std::nullopt : result.errors[0]);
  return errors;
}

std::string step_name(const Study& study, const StudyRun& run) {
  if (study.refined.empty() || run.values.empty()) return {};
  return (study.methods[run.method].peer ? "rate" : study.refined) + " " + run.values.back();
}

std::string power_text(double value) {
  const double exponent = std::round(std::log10(value));
  if (value == 1) return "1";
  if (std::abs(value / std::pow(10.0, exponent) - 1) < 1e-9) return "1e" + std::to_string(static_cast<int>(exponent));
  return formatted("%.3g", value);
}

}  // namespace proofreel
