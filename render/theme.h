#pragma once

/// The look of all pictures: colours by meaning, sizes by the height of the picture.

#include <array>

#include "engine/snapshot.h"
#include "render/canvas.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// A flat fill and an outline of the same hue, darker.
struct Tone {
  Color fill;
  Color outline;
};

/// What each colour means. Neighbours differ in lightness too, not in hue alone, so that colour-blind readers and
/// black-and-white printers tell them apart.
struct Palette {
  Color background;
  Color ink;        ///< text
  Color quiet_ink;  ///< numbers, units, what explains rather than tells
  Color plate;      ///< under captions, labels and plots
  Color plate_edge;
  Color grid;
  Color grid_axis;
  Color water;       ///< see-through, over the background and the grid
  Color water_line;  ///< its surface
  Tone dynamic;
  Tone kinematic;
  Tone fixed;
  Color contact;
  Color tree;
  Color box;                     ///< tight boxes of shapes
  Color joint;                   ///< pivots, rods, springs
  std::array<Color, 6> vectors;  ///< by VectorOf
  std::array<Color, 6> curves;
  std::array<Color, 3> forces;  ///< of contacts along the normal, by friction, of joints
  std::array<Tone, 7> islands;
  Color highlight;
  bool gray = false;  ///< colours of bodies are turned into grays
};

const Palette& palette_of(Theme theme);

/// How a body is filled and outlined: by its type or its own colour, paler when it sleeps, see-through when it is a
/// sensor.
Tone tone_of(const Palette& palette, const BodyView& body);

/// Paler, as what sleeps is drawn.
Tone asleep(Tone tone, const Palette& palette);

/// Sizes in pixels. They follow the height of the picture, or where it is narrower than 16:9 the height of one of
/// 16:9 and the same area: an upright picture is looked at from as near as a wide one.
struct Sizes {
  double unit = 1;     ///< a pixel of a picture 720 high
  double outline = 2;  ///< of bodies
  double thin = 1;     ///< boxes, grid lines
  double margin = 0;   ///< what is written keeps this distance from the picture's edges
  int title = 0;       ///< 1/18 of the height
  int text = 0;        ///< 1/28
  int small = 0;       ///< 1/40, or as small as can be read
};

Sizes sizes_of(int width_px, int height_px);

}  // namespace proofreel
