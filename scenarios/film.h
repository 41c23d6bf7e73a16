#pragma once

/// Turns what a scenario wants shown into one frame of it.

#include "scenarios/frame.h"
#include "scenarios/recorder.h"

namespace proofreel {

/// What is written at `tick`, as far as the script has come: in any pane, and once what several say.
std::vector<CaptionView> captions_at(const Scenario& scenario, std::int64_t tick);
/// Makes a frame the whole film's: `pane` beside those it has, and what is written there with what is written already.
void add_pane(Frame pane, Frame& frame);

/// The frame of the moment `snapshot` was taken, which is the last one recorded.
Frame make_frame(const Scenario& scenario, const Recorder& recorder, Snapshot snapshot, std::int64_t index);

/// How long the layer forces draws a newton, in metres: what an average body weighs becomes a share of the picture's
/// height that leaves room for what many of them weigh together. From what the scene starts with, so that it never
/// changes.
double usual_force_scale(const Scenario& scenario);

}  // namespace proofreel
