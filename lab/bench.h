#pragma once

/// Speed, told as ratios: both sides of each are measured in turns in one run, because seconds of different days or
/// machines do not compare. Prints; never judges.

namespace proofreel {

/// From the scenario to the finished film, beside the encoder alone.
void bench_clip();
/// From the command to the first picture.
void bench_first();
/// Stepping a hundred rows of boxes, beside Box2D.
void bench_pyramid();

}  // namespace proofreel
