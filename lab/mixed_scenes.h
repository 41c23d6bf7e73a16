#pragma once

/// Small scenes in which much happens at once: all that contacts can do, and joints of all kinds.

#include "lab/effect_scenes.h"

namespace proofreel {

const std::vector<EffectScene>& mixed_scenes();

}  // namespace proofreel
