#pragma once

/// Explains pixels that differ: whose they were and are, and what became of those.

#include <string>
#include <vector>

#include "golden/state_change.h"
#include "render/image.h"
#include "render/owner.h"

namespace proofreel {

/// Who explains how many of the pixels that differ.
struct Cause {
  std::string name;  ///< as users know it: `box 3.2`, `contact box 3.2 - box 2.2`, `label "v0"`, `the background`
  std::int64_t pixels = 0;  ///< that differ and are its
  std::string change;     ///< what became of it: "moved 0.41 m, turned 12 deg", "gone", "drawn only now"; often nothing
  bool explains = false;  ///< whether it is known to have changed; else the pixels merely lie there
  OwnerKind kind = OwnerKind::nothing;
};

/// Two pictures of one frame, whose their pixels are, and how the states differ.
struct TwoPictures {
  const Image& expected;
  const Image& actual;
  const OwnerPicture* owners_then = nullptr;  ///< null when nobody knows
  const OwnerPicture& owners_now;
  const StateChange& change;
  bool same_state = false;
};

/// All pixels that differ, each counted once: those that explain first, then by number. A pixel is explained by whose
/// it is or was when that has moved, come, gone, or hangs on what has; paths, plots and the hierarchy follow the state.
/// Pixels of the background belong to what is written or drawn near them, if anything is.
std::vector<Cause> causes_of(const TwoPictures& pictures, const BodyNames& names);

/// "Explains 96 % of 5,310 differing pixels; the rest is near label "2"." For frames whose state differs.
std::string share_explained(const std::vector<Cause>& causes);
/// "They are in ball (290), label "v0" and 2 more labels (22) and elsewhere (5)." For frames whose state is the same.
std::string whereabouts(const std::vector<Cause>& causes);

}  // namespace proofreel
