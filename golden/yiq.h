#pragma once

/// How different two colours look, and whether a pixel is the smoothed edge of something. Both count exactly as
/// pixelmatch 7 does, in double precision, so that figures can be compared with those of other tools.

#include <cstdint>

#include "golden/flat_rows.h"
#include "render/image.h"

namespace proofreel {

/// The largest distance there is. A threshold t of 0..1 allows distances up to largest * t * t.
inline constexpr double largest_yiq_distance = 35215;

/// The squared distance of two colours in YIQ, the colour space of NTSC television, each axis weighed by how well it
/// is seen (Kotsarenko and Ramos 2010). `a` and `b` are four bytes each. Translucent colours are seen against a
/// background that changes with `index`, the pixel's number in its picture, so that no colour can hide.
double yiq_distance(const std::uint8_t* a, const std::uint8_t* b, std::int64_t index);

/// Whether the pixel of `image` looks like anti-aliasing (Vysniauskas 2009): it has darker and brighter neighbours, at
/// most two equal ones, and the darkest or the brightest neighbour lies in a flat area in both pictures. `flat` is of
/// both pictures and has `y` as its middle row.
bool is_antialiased(const Image& image, const FlatRows& flat, int x, int y);

}  // namespace proofreel
