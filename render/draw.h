#pragma once

#include <string>

#include "render/canvas.h"
#include "scenarios/frame.h"

namespace proofreel {

struct Style {
  Theme theme = Theme::light;
  bool transparent = false;  ///< nothing behind what is drawn: alpha says how much of a pixel is covered
};

/// Draws one frame to fill the canvas. Whatever the order of its layers, from the back to the front lie the grid,
/// water, fixed bodies, trails, moving bodies, highlights, parts, bvh, aabbs, joints, contacts, forces, vectors,
/// centres of mass, and then what is written. A pure function of its arguments. Water, captions, plots and highlights
/// are always drawn: whoever wrote them asked for them. A demonstration takes the place of everything but the captions.
void draw_frame(Canvas& canvas, const Frame& frame, const Style& style, Image& image);

/// The same frame as an SVG document, as large on the page as in pixels.
std::string svg_of(const Frame& frame, const Style& style, Size size);

/// The same in two goes, for pictures whose world is the mean of several: what moves alone, and then what is written,
/// on a picture of the world, opaque and of the canvas' size. The two give what draw_frame gives, byte for byte.
void draw_world(Canvas& canvas, const Frame& frame, const Style& style, Image& image);
void draw_written(Canvas& canvas, const Frame& frame, const Style& style, const Image& world, Image& image);

}  // namespace proofreel
