#pragma once

/// A simulation with a stopwatch that runs while it steps, and at no other time: scripts, measures and pictures are not
/// the engine's cost.

#include <ctime>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/simulation.h"

namespace proofreel {

/// CPU seconds of the calling thread so far.
inline double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Steps another simulation and notes what that takes, and what it refuses to do.
class TimedSimulation final : public Simulation {
 public:
  struct Notes {
    double cpu_s = 0;     ///< of all steps
    std::string refused;  ///< why a command could not be given; empty when all could
  };

  /// `notes` must outlive it.
  TimedSimulation(std::unique_ptr<Simulation> stepped, Notes& notes) : stepped_(std::move(stepped)), notes_(notes) {}

  void step() override {
    const double before = thread_cpu_s();
    stepped_->step();
    notes_.cpu_s += thread_cpu_s() - before;
  }
  void apply(const Command& command) override {
    try {
      stepped_->apply(command);
    } catch (const std::runtime_error& error) {
      notes_.refused = error.what();
      throw;
    }
  }
  std::int64_t tick() const override { return stepped_->tick(); }
  const std::vector<ContactEvent>& contact_events() const override { return stepped_->contact_events(); }
  const std::vector<BreakEvent>& break_events() const override { return stepped_->break_events(); }
  const std::vector<SleepEvent>& sleep_events() const override { return stepped_->sleep_events(); }
  bool exists(BodyId body) const override { return stepped_->exists(body); }
  bool exists(JointId joint) const override { return stepped_->exists(joint); }
  BodyState body(BodyId body) const override { return stepped_->body(body); }
  bool asleep(BodyId body) const override { return stepped_->asleep(body); }
  JointView joint(JointId joint) const override { return stepped_->joint(joint); }
  std::vector<ContactView> contacts() const override { return stepped_->contacts(); }
  void observe(Snapshot& snapshot) const override { stepped_->observe(snapshot); }
  Energy energy() const override { return stepped_->energy(); }
  std::uint64_t state_hash() const override { return stepped_->state_hash(); }
  const std::optional<Failure>& failure() const override { return stepped_->failure(); }
  std::vector<EffectDecision> effects() const override { return stepped_->effects(); }
  void keep_forces() override { stepped_->keep_forces(); }
  std::vector<std::byte> save() const override { return stepped_->save(); }
  std::optional<std::string> restore(std::span<const std::byte> bytes) override { return stepped_->restore(bytes); }
  void keep_islands() override { stepped_->keep_islands(); }
  void time_stages(StageTimes* times) override { stepped_->time_stages(times); }

 private:
  std::unique_ptr<Simulation> stepped_;
  Notes& notes_;
};

}  // namespace proofreel
