#pragma once

#include "render/draw.h"

namespace proofreel {

/// A frame with something in every layer: discs, boxes, hexagons, capsules, rounded and compound bodies on a ground,
/// joints of all kinds, contacts, a tree, trails, arrows, labels, captions and plots. All layers show.
Frame sample_frame();

/// All layers there are.
std::vector<Layer> all_layers();

/// The frame with these layers only.
Frame with_layers(Frame frame, std::vector<Layer> layers);

}  // namespace proofreel
