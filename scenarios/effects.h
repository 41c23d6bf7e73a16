#pragma once

/// Compares the effects a scenario lists with those its scene calls for.

#include <optional>
#include <string>
#include <vector>

#include "engine/scene.h"

namespace proofreel {

/// The effect of that name, or nothing.
std::optional<Effect> effect_named(std::string_view name);

/// What this body calls for by its own numbers: what its surfaces do, drag, ccd, sensors.
EffectSet called_for_by(const BodyDef& body);
/// What this joint calls for.
EffectSet called_for_by(const JointDef& joint);

/// One sentence per effect in `wanted` that `listed` omits.
std::vector<std::string> omission_warnings(EffectSet wanted, EffectSet listed);

/// Everything the whole scene calls for, whatever its list says.
EffectSet called_for_by(const Scene& scene);

}  // namespace proofreel
