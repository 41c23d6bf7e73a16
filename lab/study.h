#pragma once

/// What accuracy costs: one scenario stepped by several methods, each at several step sizes, and how far every run is
/// from what is right. After the work-precision diagrams of numerical analysis (E. Hairer, S. P. Norsett and G. Wanner,
/// Solving Ordinary Differential Equations I, 1987).
///
/// The rules are the same for all methods, and every page repeats them: one error function, the same sample times, the
/// same scene; peers at their declared defaults and at one declared accurate preset; runs that failed are shown.

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lab/axis.h"
#include "lab/peers/peers.h"

namespace proofreel {

/// A quantity whose error is looked at.
struct StudiedMeasure {
  std::string name;
  int index = 0;               ///< in Scenario::measures
  bool has_reference = false;  ///< without one, a method is compared with itself at a step `finer_steps` times smaller
};
inline constexpr int finer_steps = 16;

/// Who steps: a curve of the diagram.
struct StudiedMethod {
  std::string name;          ///< "suzuki4", "Box2D", "Chipmunk, accurate"
  std::optional<Peer> peer;  ///< without one, our engine
  PeerPreset preset = PeerPreset::standard;
  std::vector<Override> set;  ///< what is replaced in scenario{}, beside the step size
};

/// How a run ended.
enum class RunStatus : std::uint8_t {
  ended,        ///< it has an error
  failed,       ///< its numbers became infinite, its script failed, or the engine crashed
  too_slow,     ///< it was stopped at the limit of its CPU time
  not_offered,  ///< the engine, or this method of it, does not do what the scene asks for
};
/// "ended", "too slow".
const char* name_of(RunStatus status);
std::optional<RunStatus> run_status_named(std::string_view name);

/// A method at one step size: a point of the diagram.
struct StudyRun {
  std::size_t method = 0;           ///< in Study::methods
  std::vector<Override> set;        ///< all that is replaced in scenario{}
  std::vector<std::string> values;  ///< of Study::keys; empty for what a peer has no choice in
  double step_s = 0;                ///< length of a step (a substep, where ticks have several), s
  std::string key;                  ///< the same exactly for runs that can only come out the same
};

struct StudyResult {
  RunStatus status = RunStatus::failed;
  std::string why;                            ///< it did not end well; a sentence
  std::vector<std::optional<double>> errors;  ///< of Study::measures: max over the samples of |q - reference| / scale
  std::optional<double> energy_error;         ///< largest deviation from initial energy and booked work, over its scale
  double simulated_s = 0;
  std::optional<double> cpu_s;               ///< of its steps, the least of several runs
  std::optional<double> collision_share;     ///< of that: finding contacts, not solving them
  std::optional<std::int64_t> row_updates;   ///< of constraint rows, in all steps; peers do not count
  std::optional<std::int64_t> evaluations;   ///< of the forces on a body, in all steps; peers do not count
  std::optional<std::int64_t> instructions;  ///< of all steps
};

/// What is to be run.
struct Study {
  std::string file;
  std::string scenario;  ///< its id
  std::string title;     ///< the scenario's
  double duration_s = 0;
  std::vector<Override> set;      ///< what is replaced in all runs
  std::vector<std::string> keys;  ///< of scenario{}, which vary
  std::string refined;            ///< the one of them that orders a method's runs: rate or substeps; empty for none
  std::vector<StudiedMeasure> measures;  ///< the first one is drawn
  std::vector<StudiedMethod> methods;
  std::vector<StudyRun> runs;         ///< method by method, from the largest step to the smallest
  std::vector<std::string> left_out;  ///< who cannot take part, and why; sentences
  int fps = 60;                       ///< the scenario's: references that are functions speak of the times of frames
  int samples_per_s = 0;              ///< samples are taken at these times and at the end, in every run
};

struct StudyRequest {
  std::string file;
  std::vector<Override> set;  ///< for all runs
  std::vector<Axis> axes;     ///< empty: every integrator at rates from 60 to 3840
  std::vector<Peer> peers;
  std::vector<std::string> measures;  ///< by name; empty: those with a reference, or all when none has one
};

/// Beyond this the user has to say that it is meant.
inline constexpr std::size_t most_runs_unasked = 10'000;

/// The largest number of samples per second that fall on ticks of all these rates, and are not too many for a run.
int samples_for(const std::set<int>& rates, double duration_s);

/// Throws UsageError for axes and measures the scenario does not have, and for a scenario that measures nothing;
/// ScenarioError for one that cannot be loaded.
Study plan_study(const StudyRequest& request);

/// The runs of one method, in the order of Study::runs: [first, second).
std::pair<std::size_t, std::size_t> runs_of(const Study& study, std::size_t method);

}  // namespace proofreel
