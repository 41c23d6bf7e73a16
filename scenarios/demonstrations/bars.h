#pragma once

/// Lengths side by side: one bar below the other, each with its name above it.

#include "scenarios/demonstrations/storyboard.h"

namespace proofreel {

struct Bar {
  Role role = Role::quiet;
  double length = 0;
  std::string name;
  std::string key;     ///< unless empty, its end moves there from where it was
  double further = 0;  ///< another length, which begins where the first ends
  Role further_role = Role::quiet;
};

/// Shows the bars in a diagram pane whose full width is `whole`, from the top down.
void show_bars(Storyboard& board, int pane, const std::vector<Bar>& bars, double whole);

}  // namespace proofreel
