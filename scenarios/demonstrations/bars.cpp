#include "scenarios/demonstrations/bars.h"

#include <algorithm>

namespace proofreel {

void show_bars(Storyboard& board, int pane, const std::vector<Bar>& bars, double whole) {
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double top = -static_cast<double>(i);
    const double length = std::clamp(bars[i].length / whole, 0.0, 1.0);
    const double end = std::clamp((bars[i].length + bars[i].further) / whole, 0.0, 1.0);
    const auto show = [&](Role role, double from, double to, const std::string& key) {
      StoryMark mark = bar_mark(role, {{from, top - 0.78}, {to, top - 0.78}, {to, top - 0.42}, {from, top - 0.42}});
      if (to > from) board.show(in_pane(keyed(std::move(mark), key), pane));
    };
    board.show(in_pane(path_mark(Role::quiet, {{0, top - 0.78}, {1, top - 0.78}}), pane));
    show(bars[i].role, 0, length, bars[i].key);
    show(bars[i].further_role, length, end, bars[i].key.empty() ? "" : bars[i].key + " further");
    board.show(in_pane(text_mark(bars[i].role, {0, top - 0.22}, {1, 0}, bars[i].name), pane));
  }
  board.show(in_pane(path_mark(Role::quiet, {{0, 0}, {0, -static_cast<double>(bars.size())}}), pane));
}

}  // namespace proofreel
