#pragma once

#include <string>

#include "render/canvas.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// What a film says before it begins.
struct TitleCard {
  std::string title;
  std::string description;  ///< may be empty
};

/// The title large, a rule, and the description below it, in the theme's colours: a picture of the canvas' size. Throws
/// UsageError when they do not fit into it.
void draw_title_card(Canvas& canvas, const TitleCard& card, Theme theme, Image& image);

/// Number `i` of the `count` pictures a film opens with: `card`, which stands still at first and, within the last of
/// them, fades into the theme's background, out of which `first` appears. That takes 0.8 s at `fps`, or half of a
/// shorter card. Both images have the same size.
void mix_into(const Image& card, const Image& first, Theme theme, std::int64_t i, std::int64_t count, int fps,
              Image& out);

}  // namespace proofreel
