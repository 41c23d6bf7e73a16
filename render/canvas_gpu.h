#pragma once

/// The GL side of a canvas: programs, buffers and the picture being drawn. All GL calls of drawing are made here.

#include <array>

#include "render/canvas.h"
#include "render/canvas_batches.h"
#include "render/changed_tiles.h"
#include "render/font_atlas.h"
#include "render/gl.h"

namespace proofreel {

class CanvasGpu {
 public:
  /// A picture: marks upon a colour or upon another picture of the same size.
  struct Request {
    DrawMode mode = DrawMode::colors;
    Color ground;
    const Image* background = nullptr;  ///< in place of the colour
    const BatchList& marks;             ///< whose hashes tell the ground, too, when it is a colour
  };

  CanvasGpu(GlContext& context, int width_px, int height_px);
  ~CanvasGpu();
  CanvasGpu(const CanvasGpu&) = delete;
  CanvasGpu& operator=(const CanvasGpu&) = delete;

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  /// Makes the picture what is asked for, and `image` a copy of it: draws where it differs from the one before, and
  /// reads where it differs from what the image holds. Throws EnvironmentError when OpenGL fails.
  void draw(const Request& request, FontAtlas& atlas, Image& image);

 private:
  /// Instances of one kind that lie side by side in `values_`.
  struct Call {
    ShapeKind kind = ShapeKind::box;
    std::size_t first_float = 0;
    std::size_t instances = 0;
  };
  /// What of the marks touches a part of the picture.
  struct Pass {
    PixelRect area;
    std::vector<Call> calls;
  };

  std::vector<Pass> passes_over(std::span<const TileSpan> parts, const BatchList& marks);
  Call gather(const Batch& batch, const TileSpan& part);
  void put(const Image& background);
  void upload_values();
  void upload(FontAtlas& atlas);
  void draw_pass(const Pass& pass, const Request& request);
  void draw_call(const Call& call, GLuint program);
  void read(std::span<const TileSpan> parts, Image& image);
  GLuint program_for(ShapeKind kind, DrawMode mode);

  GlContext& context_;
  Gl gl_;
  int width_px_;
  int height_px_;
  RenderTarget target_;
  TileGrid grid_;
  ChangedTiles tiles_;  // of what is in the target
  std::array<std::array<GLuint, shape_kind_count>, draw_mode_count>
      programs_{};  // those for owners once they are asked for
  GLuint vertex_array_ = 0;
  GLuint instances_ = 0;
  GLuint atlas_ = 0;
  std::size_t atlas_glyphs_ = 0;  // how many of them the texture has
  std::vector<float> values_;     // of all calls, one after the other
  std::size_t enabled_attributes_ = 0;
};

}  // namespace proofreel
