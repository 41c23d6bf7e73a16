#include "render/canvas_gpu.h"

#include <string>

namespace proofreel {
namespace {

[[noreturn]] void refuse_shader(const std::string& log) {
  throw EnvironmentError("OpenGL does not accept a shader of this program; install another Mesa version. It says: " +
                         log);
}

GLuint compile(const Gl& gl, GLenum stage, const std::string& source) {
  const GLuint shader = gl.CreateShader(stage);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint good = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == 0) {
    std::string log(4096, '\0');
    gl.GetShaderInfoLog(shader, 4096, nullptr, log.data());
    refuse_shader(log.c_str());
  }
  return shader;
}

GLuint link(const Gl& gl, ShapeKind kind, DrawMode mode) {
  const GLuint vertex = compile(gl, GL_VERTEX_SHADER, vertex_source(kind));
  const GLuint fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_source(kind, mode));
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, vertex);
  gl.AttachShader(program, fragment);
  gl.LinkProgram(program);
  gl.DeleteShader(vertex);
  gl.DeleteShader(fragment);
  GLint good = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &good);
  if (good == 0) {
    std::string log(4096, '\0');
    gl.GetProgramInfoLog(program, 4096, nullptr, log.data());
    refuse_shader(log.c_str());
  }
  return program;
}

Gl loaded_current(GlContext& context) {
  context.make_current();
  return Gl(context);
}

GLfloat part(std::uint8_t channel) { return static_cast<GLfloat>(channel) / 255.0F; }

}  // namespace

CanvasGpu::CanvasGpu(GlContext& context, int width_px, int height_px)
    : context_(context),
      gl_(loaded_current(context)),
      width_px_(width_px),
      height_px_(height_px),
      target_(gl_, width_px, height_px),
      grid_(width_px, height_px),
      tiles_(grid_) {
  for (std::size_t i = 0; i < shape_kind_count; ++i) program_for(static_cast<ShapeKind>(i), DrawMode::colors);
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.GenBuffers(1, &instances_);
  gl_.GenTextures(1, &atlas_);
  gl_.BindTexture(GL_TEXTURE_2D, atlas_);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

CanvasGpu::~CanvasGpu() {
  context_.make_current();
  for (const auto& programs : programs_) {
    for (const GLuint program : programs) gl_.DeleteProgram(program);
  }
  gl_.DeleteVertexArrays(1, &vertex_array_);
  gl_.DeleteBuffers(1, &instances_);
  gl_.DeleteTextures(1, &atlas_);
}

/// By way of a texture, because what is drawn into is none.
void CanvasGpu::put(const Image& background) {
  GLuint texture = 0, source = 0;
  gl_.GenTextures(1, &texture);
  gl_.BindTexture(GL_TEXTURE_2D, texture);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_px_, height_px_, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 background.rgba.data());
  gl_.GenFramebuffers(1, &source);
  target_.bind();
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, source);
  gl_.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  gl_.BlitFramebuffer(0, 0, width_px_, height_px_, 0, 0, width_px_, height_px_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  target_.bind();
  gl_.DeleteFramebuffers(1, &source);
  gl_.DeleteTextures(1, &texture);
  gl_.BindTexture(GL_TEXTURE_2D, atlas_);
}

void CanvasGpu::draw(const Request& request, FontAtlas& atlas, Image& image) {
  context_.make_current();
  target_.bind();
  if (request.background != nullptr) tiles_.forget();
  const std::vector<TileSpan> parts = tiles_.begin(request.marks.tile_hashes());
  const std::vector<Pass> passes = passes_over(parts, request.marks);
  upload_values();
  upload(atlas);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, request.mode == DrawMode::colors ? GL_ONE_MINUS_SRC_ALPHA : GL_ZERO);
  for (const Pass& pass : passes) draw_pass(pass, request);
  image.width_px = width_px_;
  image.height_px = height_px_;
  image.rgba.resize(static_cast<std::size_t>(width_px_) * static_cast<std::size_t>(height_px_) * 4);
  read(tiles_.parts_since(image.rgba.edition()), image);
  if (gl_.GetError() != GL_NO_ERROR) {
    atlas_glyphs_ = 0;
    throw EnvironmentError("OpenGL failed while drawing; is there enough memory?");
  }
  image.rgba.become(tiles_.edition());
  if (request.background == nullptr) tiles_.settle();
}

/// Puts together in `values_` what is to be uploaded.
std::vector<CanvasGpu::Pass> CanvasGpu::passes_over(std::span<const TileSpan> parts, const BatchList& marks) {
  std::vector<Pass> passes;
  values_.clear();
  for (const TileSpan& part : parts) {
    passes.push_back({grid_.pixels_of(part), {}});
    for (const Batch& batch : marks.batches()) {
      const Call call = gather(batch, part);
      if (call.instances > 0) passes.back().calls.push_back(call);
    }
  }
  return passes;
}

CanvasGpu::Call CanvasGpu::gather(const Batch& batch, const TileSpan& part) {
  const std::size_t floats = 4 * vectors_per_instance(batch.kind);
  Call call{batch.kind, values_.size(), 0};
  const float* instance = batch.values.data();
  for (const TileSpan& place : batch.places) {
    if (overlaps(place, part)) {
      values_.insert(values_.end(), instance, instance + floats);
      ++call.instances;
    }
    instance += floats;
  }
  return call;
}

void CanvasGpu::upload_values() {
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, instances_);
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values_.size() * sizeof(float)), values_.data(),
                 GL_STREAM_DRAW);
}

void CanvasGpu::upload(FontAtlas& atlas) {
  gl_.BindTexture(GL_TEXTURE_2D, atlas_);
  if (atlas_glyphs_ == atlas.glyphs()) return;
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, atlas.width_px(), atlas.height_px(), 0, GL_RED, GL_UNSIGNED_BYTE,
                 atlas.coverage().data());
  atlas_glyphs_ = atlas.glyphs();
}

void CanvasGpu::draw_pass(const Pass& pass, const Request& request) {
  gl_.Scissor(pass.area.x_px, pass.area.y_px, pass.area.width_px, pass.area.height_px);
  gl_.ClearColor(part(request.ground.r), part(request.ground.g), part(request.ground.b), part(request.ground.a));
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  if (request.background != nullptr) put(*request.background);
  for (const Call& call : pass.calls) draw_call(call, program_for(call.kind, request.mode));
}

/// Into the parts of an image of the picture's size.
void CanvasGpu::read(std::span<const TileSpan> parts, Image& image) {
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.PixelStorei(GL_PACK_ROW_LENGTH, width_px_);
  for (const TileSpan& part : parts) {
    const PixelRect area = grid_.pixels_of(part);
    gl_.ReadPixels(area.x_px, area.y_px, area.width_px, area.height_px, GL_RGBA, GL_UNSIGNED_BYTE,
                   image.row(area.y_px) + 4 * area.x_px);
  }
}

GLuint CanvasGpu::program_for(ShapeKind kind, DrawMode mode) {
  GLuint& program = programs_[static_cast<std::size_t>(mode)][static_cast<std::size_t>(kind)];
  if (program != 0) return program;
  program = link(gl_, kind, mode);
  gl_.UseProgram(program);
  gl_.Uniform2f(gl_.GetUniformLocation(program, "to_clip"), 2.0F / static_cast<float>(width_px_),
                2.0F / static_cast<float>(height_px_));
  return program;
}

void CanvasGpu::draw_call(const Call& call, GLuint program) {
  const std::size_t vectors = vectors_per_instance(call.kind);
  const auto stride = static_cast<GLsizei>(vectors * 4 * sizeof(float));
  for (std::size_t i = 0; i < vectors; ++i) {
    const auto attribute = static_cast<GLuint>(i);
    if (i >= enabled_attributes_) {
      gl_.EnableVertexAttribArray(attribute);
      gl_.VertexAttribDivisor(attribute, 1);
      enabled_attributes_ = i + 1;
    }
    const std::uintptr_t offset = (call.first_float + i * 4) * sizeof(float);
    gl_.VertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offset));
  }
  gl_.UseProgram(program);
  gl_.DrawArraysInstanced(GL_TRIANGLES, 0, vertices_per_quad, static_cast<GLsizei>(call.instances));
}

}  // namespace proofreel
