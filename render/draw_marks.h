#pragma once

/// Draws the marks of a demonstration into their pane. What a mark looks like follows from its role alone.

#include <vector>

#include "render/draw_layers.h"

namespace proofreel {

/// A pane's place in the picture, and what of its coordinates lies where.
struct PanePlace {
  bool diagram = false;
  Aabbd room;    ///< px, the whole pane: labels stay within it
  Aabbd area;    ///< px, where marks lie
  Vec2d scale;   ///< px per unit; y up
  Vec2d middle;  ///< what lies in the middle of the area
  Vec2d to_px(Vec2d p) const {
    const Vec2d offset = p - middle;
    return center(area) + Vec2d{scale.x * offset.x, -scale.y * offset.y};
  }
};

/// The marks of one pane: areas first, then lines, then points, and what is written on top.
void draw_marks(const Stage& stage, const PanePlace& place, const std::vector<const StoryMark*>& marks);

}  // namespace proofreel
