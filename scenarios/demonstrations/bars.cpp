#include "scenarios/demonstrations/bars.h"

#include <algorithm>

namespace proofreel {

void show_bars(Storyboard& board, int pane, const std::vector<Bar>& bars, double whole) {
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double top = -static_cast<double>(i);
    const double length = std::clamp(bars[i].length / whole, 0.0, 1.0);
    const auto box = [&](Role role, double to) {
      return bar_mark(role, {{0, top - 0.78}, {to, top - 0.78}, {to, top - 0.42}, {0, top - 0.42}});
    };
    board.show(in_pane(path_mark(Role::quiet, {{0, top - 0.78}, {1, top - 0.78}}), pane));
    if (length > 0) board.show(in_pane(keyed(box(bars[i].role, length), bars[i].key), pane));
    board.show(in_pane(text_mark(bars[i].role, {0, top - 0.22}, {1, 0}, bars[i].name), pane));
  }
  board.show(in_pane(path_mark(Role::quiet, {{0, 0}, {0, -static_cast<double>(bars.size())}}), pane));
}

}  // namespace proofreel
