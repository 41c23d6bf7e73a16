#pragma once

/// The programs a canvas draws with. Every shape is a quad a little larger than itself, and the fragment shader works
/// out how far each pixel's centre is from the shape's edge.
///
/// To give the same bytes on every processor, shaders compute with gl_FragCoord and flat inputs only, using + - * /,
/// sqrt, min, max, abs and comparisons. Interpolated inputs, inversesqrt and pow round differently between instruction
/// sets. Loops over corners are unrolled here: local arrays indexed by a variable are slow and were seen to crash
/// llvmpipe (Mesa 22.3).

#include <cstddef>
#include <string>

namespace proofreel {

/// What a quad holds. Instances of one kind are drawn by one program.
enum class ShapeKind : unsigned char {
  box,        ///< a rounded, turned rectangle: discs, capsules, lines and boxes too
  edges8,     ///< a sharp convex polygon as up to 8 half-planes
  edges16,    ///< the same with up to 16
  rounded8,   ///< a convex polygon with up to 8 corners, rounded outward
  rounded20,  ///< the same with up to 20: 16 and the 4 that clipping to the picture may add
  stroke,     ///< one segment of a polyline, which shares no pixel with its neighbours
  glyph,      ///< pixels of the glyph atlas
};
inline constexpr std::size_t shape_kind_count = 7;

/// How many vec4 describe one instance. The first four are the same for all kinds:
/// 0: the quad's centre and the direction of its first axis; 1: its half extents, outline width, radius;
/// 2: fill; 3: outline, both premultiplied. Fragments see the rest flat.
std::size_t vectors_per_instance(ShapeKind kind);

/// Vertices of one quad, drawn as two triangles. Not as a strip of four: at LP_NATIVE_VECTOR_WIDTH=128 on a processor
/// with AVX, llvmpipe (Mesa 22.3) shades eight vertices at a time but makes room for a multiple of four, and writes
/// past it. Six are rounded up to eight either way.
inline constexpr int vertices_per_quad = 6;

/// What is painted: colours blended over each other, or bare the number of the topmost mark's owner.
enum class DrawMode : unsigned char { colors, owners };
inline constexpr std::size_t draw_mode_count = 2;

std::string vertex_source(ShapeKind kind);
/// In the mode `owners` fill and outline hold the number where colours have red, green and blue.
std::string fragment_source(ShapeKind kind, DrawMode mode);

}  // namespace proofreel
