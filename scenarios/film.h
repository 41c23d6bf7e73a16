#pragma once

/// Turns what a scenario wants shown into one frame of it.

#include "scenarios/frame.h"
#include "scenarios/recorder.h"

namespace proofreel {

/// The frame of the moment `snapshot` was taken, which is the last one recorded.
Frame make_frame(const Scenario& scenario, const Recorder& recorder, Snapshot snapshot, std::int64_t index);

}  // namespace proofreel
