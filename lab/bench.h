#pragma once

/// Speed, told as ratios: both sides of each are measured in turns in one run, because seconds of different days or
/// machines do not compare. Prints; never judges.

namespace proofreel {

/// From the scenario to the finished film, beside the encoder alone.
void bench_clip();
/// Manifolds of random pairs, beside Box2D and Chipmunk.
void bench_manifolds();
/// What each effect costs in instructions, beside the committed figures.
void bench_effects();
/// Stepping heavy scenes, beside Box2D and Chipmunk: what it costs and how well it holds together.
void bench_engine();
/// From the command to the first picture.
void bench_first();
/// Comparing two long pages, beside decoding one of them; what a golden frame that passes costs; and checking a
/// thousand.
void bench_golden();
/// Distances and times of impact of two polygons, beside Box2D.
void bench_gjk();
/// Finding the pairs of overlapping boxes and querying them, beside Box2D and Chipmunk; and how that grows.
void bench_tree();

}  // namespace proofreel
