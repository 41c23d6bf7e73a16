#include "scenarios/runner.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "scenarios/examiner.h"
#include "scenarios/film.h"
#include "scenarios/formatted.h"
#include "scenarios/recorder.h"
#include "scenarios/replay.h"
#include "scenarios/run_saver.h"
#include "scenarios/suggest.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

/// Binds a script to a simulation for as long as this lives.
class Binding {
 public:
  Binding(Script& script, Simulation& simulation) : script_(script) { script_.bind(&simulation); }
  ~Binding() { script_.bind(nullptr); }
  Binding(const Binding&) = delete;
  Binding& operator=(const Binding&) = delete;

 private:
  Script& script_;
};

/// What simulations find out only when asked, since it takes a look at every body.
void ask_for_what_is_drawn(const Picture& picture, Simulation& simulation) {
  const bool forces = std::any_of(picture.vectors.begin(), picture.vectors.end(), [](const VectorMark& mark) {
    return mark.of == VectorOf::force || mark.of == VectorOf::acceleration;
  });
  if (forces) simulation.keep_forces();
  if (ever_shows(picture, Layer::islands)) simulation.keep_islands();
}

std::string sentence(const Scenario& scenario, const Failure& failure) {
  const auto body = static_cast<std::size_t>(failure.body);
  const bool named = body >= 1 && body <= scenario.body_names.size();
  const std::string who = named ? "body " + quote(scenario.body_names[body - 1]) : std::string("the scene");
  const std::string time = formatted("%.6g s", static_cast<double>(failure.tick) / scenario.scene.rate);
  return in_file(scenario) + "the simulation stopped at tick " + std::to_string(failure.tick) + " (" + time + "): in " +
         failure.stage + " the motion of " + who + " " + failure.what +
         "; use smaller forces or stiffness, or a higher rate";
}

void add(const Energy& more, Energy& energy) {
  energy.kinetic += more.kinetic;
  energy.potential += more.potential;
  energy.booked_work += more.booked_work;
}

}  // namespace

void must_be_one_scene(const Scenario& scenario) {
  if (scenario.other_panes.empty()) return;
  throw ScenarioError(scenario.path + ": this can be done with one scene only, and the file shows " +
                      std::to_string(scenario.other_panes.size() + 1) +
                      " side by side: put what a pane{...} of it holds into scenario{...} of a file of its own");
}

struct Runner::Impl {
  Impl(Scenario& owner, std::unique_ptr<Simulation> stepped)
      : scenario(owner),
        simulation(std::move(stepped)),
        binding(std::in_place, *scenario.script, *simulation),
        last_tick(scenario.ticks()),
        recorder(scenario),
        examiner(scenario, last_tick),
        energy_watch(scenario.scene.gravity, scenario.picture.view.height) {
    ask_for_what_is_drawn(scenario.picture, *simulation);
    report.scenario = scenario.id;
    for (const auto& pane : scenario.other_panes) others.push_back(std::make_unique<Runner>(*pane));
  }

  void start(const std::vector<std::int64_t>& saved_ticks) {
    if (!saved_ticks.empty()) saver.emplace(scenario, saved_ticks);
    report.initial_energy = simulation->energy();
    energy_watch.start_from(report.initial_energy.total());
    recorder.note_energy(report.initial_energy);
    const std::uint64_t shown = scenario.stories.empty() ? 0 : hash_of(scenario.stories);
    report.trajectory_hash = chained_hash(shown, simulation->state_hash());
    look();
  }

  void resume(const SavedRun& run, const std::string& file) {
    const auto problem = simulation->restore(run.state);
    if (problem || simulation->tick() != run.tick)
      throw ScenarioError(file + " cannot be resumed: the state in it " + problem.value_or("contradicts itself"));
    for (const Command& command : run.made) scenario.script->adopt(command);
    examiner.take_up(run);
    report.initial_energy = run.initial_energy;
    energy_watch.start_from(report.initial_energy.total());
    recorder.note_energy(report.initial_energy);
    report.trajectory_hash = run.trajectory_hash;
    report.resumed_at = run.tick;
    replay.emplace(run, file);
    look();
  }

  bool finished() const { return simulation->tick() >= last_tick || failed() != nullptr; }

  /// The pane whose simulation has failed; null while all is well.
  const Impl* failed() const {
    if (simulation->failure()) return this;
    for (const auto& other : others) {
      if (const Impl* pane = other->impl_->failed()) return pane;
    }
    return nullptr;
  }

  /// One tick; false when a simulation failed in it.
  bool advance() {
    act(false);
    if (saver) saver->watch(ScriptFunction::field, 0, simulation->tick());
    simulation->step();
    if (simulation->failure()) return false;
    report.trajectory_hash = chained_hash(report.trajectory_hash, simulation->state_hash());
    act(true);
    if (!follow()) return false;
    look();
    return true;
  }

  /// Steps the other panes up to this one's time; false when one failed.
  bool follow() {
    const std::int64_t rate = scenario.scene.rate, tick = simulation->tick();
    for (const auto& other : others) {
      Impl& pane = *other->impl_;
      while (!pane.finished() && pane.is_behind(tick, rate)) {
        if (!pane.advance()) return false;
      }
    }
    return true;
  }

  /// Whether the next tick is due by the time tick / rate.
  bool is_behind(std::int64_t tick, std::int64_t rate) const {
    return (simulation->tick() + 1) * rate <= tick * scenario.scene.rate;
  }

  /// What the script does before a step, or when it has heard what the step set off; or what it did in the saved run.
  void act(bool heard) {
    if (replay) return replay->act(heard, *simulation, *scenario.script);
    if (heard) {
      scenario.script->after_step();
    } else {
      scenario.script->before_step();
    }
    if (saver) saver->log(simulation->tick(), heard);
  }

  /// Everything that is measured, recorded and expected at this tick.
  void look() {
    const std::int64_t tick = simulation->tick();
    const bool sampled = is_sample_tick(scenario, tick);
    recorder.record(*simulation);
    if (sampled) {
      if (!replay) recorder.sample_plots(tick);
      book_energy();
    }
    examiner.look_at_measures(tick, sampled, saver_or_null());
    if (sampled) {
      for (const auto& other : others) examiner.add_last_sample_of(other->samples());
    }
    examiner.look_at_expectations(tick, saver_or_null());
    if (saver && saver->wants(tick)) saver->keep(as_it_is());
  }

  RunSaver* saver_or_null() { return saver ? &*saver : nullptr; }

  std::uint64_t hash_of_all() const {
    std::uint64_t hash = report.trajectory_hash;
    for (const auto& other : others) hash = chained_hash(hash, other->trajectory_hash());
    return hash;
  }

  SavedRun as_it_is() const {
    SavedRun run;
    run.tick = simulation->tick();
    run.state = simulation->save();
    run.trajectory_hash = report.trajectory_hash;
    run.initial_energy = report.initial_energy;
    run.expectations = examiner.to_be_saved();
    return run;
  }

  void book_energy() {
    const Energy now = simulation->energy();
    const double drift = now.total() - now.booked_work - report.initial_energy.total();
    report.max_energy_drift = std::max(report.max_energy_drift, std::abs(drift));
    report.final_energy = now;
    energy_watch.look(*simulation, now);
    recorder.note_energy(now);
  }

  /// What is known of this pane by now, but for what is found out at the end.
  RunReport report_so_far() const {
    RunReport now = report;
    now.measures = examiner.measures();
    now.expectations = examiner.expectations();
    return now;
  }

  /// What another pane reports at the end. Where one has failed, none is stepped on.
  void add_report_of(Runner& other, bool over, RunReport& whole) {
    if (over) other.impl_->examiner.give_up(other.tick());
    const RunReport pane = over ? other.impl_->report_so_far() : other.finish();
    whole.state_hash = chained_hash(whole.state_hash, other.simulation().state_hash());
    whole.measures.insert(whole.measures.end(), pane.measures.begin(), pane.measures.end());
    whole.expectations.insert(whole.expectations.end(), pane.expectations.begin(), pane.expectations.end());
    add(pane.initial_energy, whole.initial_energy);
    add(pane.final_energy, whole.final_energy);
    whole.max_energy_drift = std::max(whole.max_energy_drift, pane.max_energy_drift);
    if (!whole.energy_grew) whole.energy_grew = pane.energy_grew;
  }

  Scenario& scenario;
  std::unique_ptr<Simulation> simulation;
  std::optional<Binding> binding;
  std::int64_t last_tick;
  Recorder recorder;
  Examiner examiner;
  EnergyWatch energy_watch;
  RunReport report;                             ///< without what the examiner knows
  std::optional<RunSaver> saver;                ///< of a run that is to be saved
  std::optional<Replay> replay;                 ///< of a run that was
  std::vector<std::unique_ptr<Runner>> others;  ///< of Scenario::other_panes
};

Runner::Runner(Scenario& scenario) : Runner(scenario, std::vector<std::int64_t>{}) {}

Runner::Runner(Scenario& scenario, std::unique_ptr<Simulation> simulation) {
  must_be_one_scene(scenario);
  impl_ = std::make_unique<Impl>(scenario, std::move(simulation));
  impl_->start({});
}

Runner::Runner(Scenario& scenario, const std::vector<std::int64_t>& saved_ticks) {
  if (!saved_ticks.empty()) must_be_one_scene(scenario);
  impl_ = std::make_unique<Impl>(scenario, make_simulation(scenario.scene));
  impl_->start(saved_ticks);
}

Runner::Runner(Scenario& scenario, const SavedRun& run, const std::string& file) {
  must_be_one_scene(scenario);
  check_resumable(run, scenario, file);
  impl_ = std::make_unique<Impl>(scenario, make_simulation(scenario.scene));
  impl_->resume(run, file);
}

Runner::~Runner() = default;

void Runner::step() {
  assert(!finished());
  if (impl_->advance()) return;
  const Impl& pane = *impl_->failed();
  throw ScenarioError(sentence(pane.scenario, *pane.simulation->failure()));
}

bool Runner::finished() const { return impl_->finished(); }
std::int64_t Runner::tick() const { return impl_->simulation->tick(); }
std::uint64_t Runner::trajectory_hash() const { return impl_->hash_of_all(); }
const Simulation& Runner::simulation() const { return *impl_->simulation; }
const std::vector<Sample>& Runner::samples() const { return impl_->examiner.samples(); }

Frame Runner::frame(std::int64_t index) const {
  Snapshot snapshot;
  impl_->simulation->observe(snapshot);
  Frame frame = make_frame(impl_->scenario, impl_->recorder, std::move(snapshot), index);
  for (const auto& other : impl_->others) add_pane(other->frame(index), frame);
  return frame;
}

SavedRun Runner::saved(std::int64_t tick) const {
  assert(finished() && impl_->saver);
  return impl_->saver->saved(tick, impl_->last_tick, impl_->report.trajectory_hash);
}

void Runner::move_to(std::unique_ptr<Simulation> fresh) {
  const std::vector<std::byte> state = impl_->simulation->save();
  if (state.empty()) throw ScenarioError(impl_->scenario.path + ": this kind of simulation cannot be saved");
  if (const auto problem = fresh->restore(state))
    throw ScenarioError(impl_->scenario.path + ": the state of the simulation " + *problem);
  ask_for_what_is_drawn(impl_->scenario.picture, *fresh);
  impl_->binding.reset();
  impl_->simulation = std::move(fresh);
  impl_->binding.emplace(*impl_->scenario.script, *impl_->simulation);
}

RunReport Runner::finish(const std::function<void()>& after_tick) {
  while (!finished()) {
    if (impl_->advance() && after_tick) after_tick();
  }
  const Impl* failed = impl_->failed();
  if (failed != nullptr) impl_->examiner.give_up(tick());
  if (impl_->replay && impl_->replay->ended_elsewhere(*impl_->simulation, impl_->report.trajectory_hash))
    impl_->scenario.warnings.push_back("the motion is not that of the saved run: the program has changed since");
  RunReport report = impl_->report_so_far();
  report.energy_grew = impl_->energy_watch.growth();
  if (report.energy_grew) impl_->scenario.warnings.push_back(sentence(*report.energy_grew, impl_->scenario.scene.rate));
  report.ticks = impl_->simulation->tick();
  report.trajectory_hash = impl_->hash_of_all();
  report.state_hash = impl_->simulation->state_hash();
  for (const auto& other : impl_->others) impl_->add_report_of(*other, failed != nullptr, report);
  if (failed != nullptr) report.failure = failed->simulation->failure();
  return report;
}

}  // namespace proofreel
