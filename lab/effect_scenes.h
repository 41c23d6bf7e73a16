#pragma once

/// Scenes that differ in size and in the one effect they call for: what their steps cost apart from each other is what
/// the effect costs.

#include <string>
#include <vector>

#include "engine/scene.h"

namespace proofreel {

struct EffectScene {
  std::string name;
  Scene (*make)(int bodies);
};

/// In the order of the table.
const std::vector<EffectScene>& effect_scenes();

}  // namespace proofreel
