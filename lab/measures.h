#pragma once

/// How well a snapshot keeps what it should, measured from places and shapes alone, and by our own narrow phase: the
/// same yardstick for every engine.

#include <vector>

#include "engine/snapshot.h"

namespace proofreel {

/// Two bodies that are nearer than they may be, or just touch.
struct PairFit {
  BodyId a{};
  BodyId b{};
  double separation = 0;  ///< m, of the deepest pair of their shapes; negative on overlap
  double thickness = 0;   ///< m, of the thinner one of these: what an overlap is small or large against
};

/// All pairs of bodies that may meet and are at most `margin` metres apart, in order of ids. `filters` are by id, the
/// first body's first; bodies beyond its end have the default one. Bodies that share a joint which lets them overlap
/// are left out, and so are sensors and pairs that neither forces nor contacts move.
std::vector<PairFit> fit_of_pairs(const Snapshot& snapshot, const std::vector<FilterDef>& filters, double margin);

struct Penetration {
  int pairs = 0;           ///< that overlap or are within the margin
  double largest = 0;      ///< m
  double mean = 0;         ///< m, over all these pairs, 0 for those apart
  double of_smaller = 0;   ///< largest share of the thinner body's thickness
  double largest_air = 0;  ///< m between bodies that carry each other
  double mean_air = 0;     ///< m, over the pairs that carry each other, 0 for those that overlap
};

/// Overlaps within the snapshot, and the air between bodies whose contact carries something: a skin that an engine
/// keeps around its shapes shows there.
Penetration penetration_of(const Snapshot& snapshot, const std::vector<FilterDef>& filters);

/// How far a joint's anchors are from where the joint wants them, m; 0 for what is soft.
double joint_gap(const JointView& joint);

struct JointGaps {
  double largest = 0;  ///< m
  double mean = 0;     ///< m, over all rigid joints
};
JointGaps joint_gaps(const Snapshot& snapshot);

}  // namespace proofreel
