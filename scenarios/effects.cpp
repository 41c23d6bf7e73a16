#include "scenarios/effects.h"

#include <string_view>

#include "engine/simulation.h"

namespace proofreel {
namespace {

EffectSet united(EffectSet a, EffectSet b) {
  for (int i = 0; i < effect_count; ++i) {
    if (b.has(static_cast<Effect>(i))) a.add(static_cast<Effect>(i));
  }
  return a;
}

}  // namespace

std::optional<Effect> effect_named(std::string_view name) {
  for (int i = 0; i < effect_count; ++i) {
    if (name == name_of(static_cast<Effect>(i))) return static_cast<Effect>(i);
  }
  return std::nullopt;
}

EffectSet called_for_by(const BodyDef& body) {
  EffectSet set;
  for (const ShapeDef& shape : body.shapes) {
    if (shape.rolling_resistance > 0) set.add(Effect::rolling_resistance);
    if (shape.restitution > 0) set.add(Effect::restitution);
    if (shape.surface_speed != 0) set.add(Effect::surface_speed);
  }
  if (body.drag && body.drag->acts()) set.add(Effect::drag);
  if (body.bullet) set.add(Effect::ccd);
  if (body.sensor) set.add(Effect::sensors);
  return set;
}

EffectSet called_for_by(const JointDef& joint) {
  Scene only_it;
  only_it.gravity = {};
  only_it.joints = {joint};
  return effects_of(only_it);
}

EffectSet called_for_by(const Scene& scene) {
  Scene free_of_list = scene;
  free_of_list.effects.reset();
  const EffectSet inferred = effects_of(free_of_list);
  EffectSet set;
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    // Contacts always bring continuous collision along; only a bullet asks for it.
    if (effect != Effect::ccd && inferred.has(effect)) set.add(effect);
  }
  for (const BodyDef& body : scene.bodies) set = united(set, called_for_by(body));
  return set;
}

std::vector<std::string> omission_warnings(EffectSet wanted, EffectSet listed) {
  std::vector<std::string> warnings;
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    if (!wanted.has(effect) || listed.has(effect)) continue;
    warnings.push_back(std::string("the scene calls for \"") + name_of(effect) +
                       "\", but the list of effects omits it: it does not act");
  }
  return warnings;
}

}  // namespace proofreel
