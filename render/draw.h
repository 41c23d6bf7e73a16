#pragma once

#include "render/canvas.h"
#include "scenarios/frame.h"

namespace proofreel {

/// What of a frame is drawn, and how. Layers are drawn in the order of `Layer`, not of this list.
struct Style {
  Theme theme = Theme::light;
  std::vector<Layer> layers;
};

/// Draws one frame to fill the canvas. A pure function of its arguments. Captions and plots are always drawn: whoever
/// wrote them asked for them.
void draw_frame(Canvas& canvas, const Frame& frame, const Style& style, Image& image);

}  // namespace proofreel
