#pragma once

/// What the drawing tests share: one context for the whole program, and measures of pictures.

#include <cstdint>
#include <functional>

#include "render/canvas.h"

namespace proofreel::painted {

/// OSMesa, or EGL where there is none; made once, since each costs a tenth of a second.
GlContext& context();

inline constexpr Color black{0, 0, 0, 255};
inline constexpr Color white{255, 255, 255, 255};
inline constexpr Color nothing{0, 0, 0, 0};

/// Black fill without outline.
inline constexpr Paint solid{black, black, 0};

/// What `draw` paints onto white.
Image picture(int width_px, int height_px, const std::function<void(Canvas&)>& draw);

/// The area of black on white, in pixels: each counts by how dark it is.
double ink(const Image& image);

/// The red channel of one pixel.
int red(const Image& image, int x, int y);

/// The largest difference of any channel of any pixel.
int largest_difference(const Image& a, const Image& b);

/// FNV-1a of all bytes: enough to tell pictures apart in a test.
std::uint64_t fingerprint(const Image& image);

}  // namespace proofreel::painted
