#pragma once

/// A simulation whose bodies fly straight on, with contacts and failures on order: tests of scripts do not depend on
/// the engine's motion.

#include <map>
#include <optional>
#include <vector>

#include "engine/simulation.h"

namespace proofreel {

class FakeSimulation : public Simulation {
 public:
  explicit FakeSimulation(const Scene& scene);

  /// What contact_events() gives after the step that ends at that tick.
  std::map<std::int64_t, std::vector<ContactEvent>> events_at;
  /// What separation_events() gives after that step.
  std::map<std::int64_t, std::vector<SeparationEvent>> separations_at;
  /// What contacts() gives.
  std::vector<ContactView> touching;
  /// The tick at which body 1 stops being finite.
  std::optional<std::int64_t> fails_at;
  /// Everything applied, in order.
  std::vector<Command> log;

  void step() override;
  void apply(const Command& command) override;
  std::int64_t tick() const override { return tick_; }
  const std::vector<ContactEvent>& contact_events() const override { return events_; }
  const std::vector<SeparationEvent>& separation_events() const override { return separations_; }
  bool exists(BodyId body) const override;
  bool exists(JointId joint) const override;
  BodyState body(BodyId body) const override;
  JointView joint(JointId joint) const override;
  std::vector<ContactView> contacts() const override { return touching; }
  void observe(Snapshot& snapshot) const override;
  Energy energy() const override;
  std::uint64_t state_hash() const override;
  const std::optional<Failure>& failure() const override { return failure_; }

 private:
  struct Flier {
    BodyState state;
    bool removed = false;
  };
  void add(const BodyDef& def);
  Flier& flier(BodyId body) { return fliers_[static_cast<std::size_t>(body) - 1]; }

  int rate_;
  std::int64_t tick_ = 0;
  std::vector<Flier> fliers_;
  std::vector<std::pair<JointDef, bool>> joints_;  ///< and whether it is still there
  std::vector<ContactEvent> events_;
  std::vector<SeparationEvent> separations_;
  std::optional<Failure> failure_;
};

}  // namespace proofreel
