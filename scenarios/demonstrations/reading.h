#pragma once

/// Nothing is taken away before it could be read.

#include <set>
#include <string>

#include "scenarios/demonstration.h"

namespace proofreel {

/// Seconds an audience needs for a caption: one to find it, 0.3 for every word, 0.2 for those in `known`, which are
/// recognised rather than read. Captions of a loop, in which nothing but figures and single letters is new, are looked
/// at: half a second, and 0.3 for every new figure. What was read is known from then on. Formulas count by what stands
/// between their spaces; signs are not counted.
double seconds_to_read(const std::string& text, std::set<std::string>& known);

/// Makes what stands under one caption last as long as it takes to read, heading included where that is new, times
/// `stretch`, after the stories `before`: the last of its steps stands still for the rest. Motions keep their speed.
void give_time_to_read(Story& story, const std::vector<Story>& before, double stretch);

}  // namespace proofreel
