#pragma once

#include <optional>
#include <string>

#include "lab/grid.h"
#include "render/context.h"

namespace proofreel {

/// A run's result, and the picture of its last moment as the bytes of a PNG (empty when there is none).
struct RunOutcome {
  RunResult result;
  std::string still;
};

/// A scenario's script may take this many times what its steps may.
inline constexpr double whole_limit = 3;

/// Steps the scenario to its end, or until its steps have taken `limit_s` seconds of CPU time, and draws what it has
/// come to: 480 x 270 pixels, bodies, joints and contacts. Time is measured around the steps alone. A step that hangs
/// is the caller's to end. Throws EnvironmentError where nothing can be drawn.
RunOutcome run_once(const RunRequest& request, double limit_s, std::optional<GlBackend> gl);

}  // namespace proofreel
