#pragma once

#include <string>

namespace proofreel {

/// Instructions that one more body takes in one substep of an effect scene: the slope over the number of bodies, so
/// that what a step costs whatever the number of bodies does not count. In double precision. `scene` as in
/// effect_scenes(), or "by hand" for a loop written for just gravity. Throws EnvironmentError where valgrind is
/// missing.
double effect_cost(const std::string& scene);

}  // namespace proofreel
