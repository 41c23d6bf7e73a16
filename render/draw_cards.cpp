#include "render/draw_layers.h"

#include <algorithm>

namespace proofreel {
namespace {

double left_edge(const Aabbd& safe, double width, Corner at) {
  if (at == Corner::top_left || at == Corner::bottom_left) return safe.lower.x;
  if (at == Corner::top_right || at == Corner::bottom_right) return safe.upper.x - width;
  return 0.5 * (safe.lower.x + safe.upper.x - width);
}

Aabbd moved(const Aabbd& card, double x, double y) { return {card.lower + Vec2d{x, y}, card.upper + Vec2d{x, y}}; }

Aabbd whole_pixels(const Aabbd& card) {
  const Vec2d low{std::floor(card.lower.x), std::floor(card.lower.y)};
  return {low, low + Vec2d{std::ceil(card.upper.x - card.lower.x), std::ceil(card.upper.y - card.lower.y)}};
}

/// Moves a card away from its edge until it covers no other.
Aabbd stacked(Aabbd card, const std::vector<Aabbd>& taken, double gap, bool downwards) {
  for (std::size_t i = 0; i < taken.size();) {
    const Aabbd& other = taken[i];
    if (!overlaps(card, other)) {
      ++i;
      continue;
    }
    card = moved(card, 0, downwards ? other.upper.y + gap - card.lower.y : other.lower.y - gap - card.upper.y);
    i = 0;
  }
  return card;
}

}  // namespace

Aabbd Cards::place(Vec2d size, Corner at) {
  constexpr int columns = 3;
  const double gap = 0.25 * safe_.lower.y;
  const double top = is_at_top(at) ? safe_.lower.y : safe_.upper.y - size.y;
  const double left = left_edge(safe_, size.x, at);
  const double inward = left > 0.5 * (safe_.lower.x + safe_.upper.x - size.x) ? -1 : 1;
  const auto at_column = [&](int column) {
    const double x = left + inward * column * (size.x + gap);
    return whole_pixels({{x, top}, {x + size.x, top + size.y}});
  };
  Aabbd card = at_column(0);  // stays when the picture is too small for all its cards
  for (int column = 0; column < columns; ++column) {
    const Aabbd fitting = stacked(at_column(column), taken_, gap, is_at_top(at));
    if (!contains(expanded(safe_, 1.0), fitting)) continue;
    card = fitting;
    break;
  }
  take(card);
  return card;
}

bool Cards::free(const Aabbd& card) const {
  return contains(safe_, card) &&
         std::none_of(taken_.begin(), taken_.end(), [&card](const Aabbd& other) { return overlaps(card, other); });
}

}  // namespace proofreel
