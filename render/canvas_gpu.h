#pragma once

/// The GL side of a canvas: programs, buffers and the picture being drawn. All GL calls of drawing are made here.

#include <array>

#include "render/canvas.h"
#include "render/canvas_batches.h"
#include "render/font_atlas.h"
#include "render/gl.h"

namespace proofreel {

class CanvasGpu {
 public:
  CanvasGpu(GlContext& context, int width_px, int height_px);
  ~CanvasGpu();
  CanvasGpu(const CanvasGpu&) = delete;
  CanvasGpu& operator=(const CanvasGpu&) = delete;

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  void clear(Color background);
  /// Replaces all pixels by those of an image of the same size.
  void put(const Image& background);
  /// Draws the batches over what is there and reads the result.
  void draw(DrawMode mode, std::span<const Batch> batches, FontAtlas& atlas, Image& image);

 private:
  void upload(std::span<const Batch> batches);
  void upload(FontAtlas& atlas);
  void draw_batch(const Batch& batch, GLuint program, std::size_t first_float);
  GLuint program_for(ShapeKind kind, DrawMode mode);

  GlContext& context_;
  Gl gl_;
  int width_px_;
  int height_px_;
  RenderTarget target_;
  std::array<std::array<GLuint, shape_kind_count>, draw_mode_count>
      programs_{};  // those for owners once they are asked for
  GLuint vertex_array_ = 0;
  GLuint instances_ = 0;
  GLuint atlas_ = 0;
  std::vector<float> values_;  // of all batches, one after the other
  std::size_t enabled_attributes_ = 0;
};

}  // namespace proofreel
