#pragma once

/// Which effects a scene calls for. A scene pays only for what is on.

#include <optional>
#include <string>
#include <vector>

#include "engine/scene.h"

namespace proofreel {

/// Whether an effect acts, and the reason in words: "no shape has restitution".
struct EffectDecision {
  Effect effect{};
  bool on = false;
  std::string why;
  std::string how = {};  ///< what its solver found out while it ran, where that decided how it went on; mostly empty
};

/// Counts what a scene holds, to infer from it what must be simulated. Only ever grows: an effect that is on with
/// nothing to act on changes no bit of the motion.
class EffectCensus {
 public:
  /// Counts what belongs to the scene as a whole; bodies and joints are added one by one.
  explicit EffectCensus(const Scene& scene);
  void add(const BodyDef& body);
  void add(const JointDef& joint);
  void allow_sleep() { sleeping_ = true; }
  EffectSet inferred() const;
  /// What is inferred, effect by effect, with the reasons.
  std::vector<EffectDecision> decisions() const;
  /// The same when a list has decided.
  std::vector<EffectDecision> decisions(EffectSet listed) const;
  /// For archives (scene_archive.h).
  template <typename Archive, typename Self>
  static void exchange(Archive& archive, Self& census);

 private:
  /// Bodies that meet the same others; most scenes have very few of these.
  struct MeetingClass {
    FilterDef filter;
    bool dynamic = false;
    int bodies = 0;
    template <typename Archive, typename Self>
    static void exchange(Archive& archive, Self& one) {
      auto& [filter, dynamic, bodies] = one;
      archive(filter, dynamic, bodies);
    }
  };
  bool anything_meets() const;

  bool gravity_ = false;
  bool drag_ = false;
  bool wind_ = false;
  bool attractor_ = false;
  bool nbody_ = false;
  bool rocket_ = false;
  bool buoyancy_ = false;
  bool field_ = false;
  std::vector<MeetingClass> classes_;
  bool friction_ = false;
  bool rolling_resistance_ = false;
  bool restitution_ = false;
  bool surface_speed_ = false;
  bool sensor_ = false;
  bool spring_ = false;
  bool rigid_joint_ = false;
  bool limit_ = false;
  bool motor_ = false;
  bool breakable_ = false;
  bool sleeping_ = false;
};

/// The effects a simulation of this scene runs: its list, or what can be inferred from what it holds.
EffectSet effects_of(const Scene& scene);

/// Whether an integrator goes together with whatever a scene may hold.
bool steps_everything(Integrator integrator);
/// Whether the method as a whole does.
bool steps_everything(const Method& method);
/// Why the scene's method cannot step what the scene holds and what to choose instead, as a sentence; nothing when they
/// go together.
std::optional<std::string> problem_with_method(const Scene& scene);

/// As the scenario language writes it.
const char* name_of(Effect effect);

}  // namespace proofreel
