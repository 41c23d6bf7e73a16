#include "render/gl.h"

#include <string>

namespace proofreel {
namespace {

template <typename Function>
void load(const GlContext& context, const char* name, Function& function) {
  function = reinterpret_cast<Function>(context.proc(name));
  if (function == nullptr) throw EnvironmentError(std::string("OpenGL has no function ") + name);
}

}  // namespace

Gl::Gl(const GlContext& context) {
  load(context, "glGetIntegerv", GetIntegerv);
  load(context, "glGetString", GetString);
  load(context, "glGetError", GetError);
  load(context, "glCreateShader", CreateShader);
  load(context, "glShaderSource", ShaderSource);
  load(context, "glCompileShader", CompileShader);
  load(context, "glGetShaderiv", GetShaderiv);
  load(context, "glGetShaderInfoLog", GetShaderInfoLog);
  load(context, "glDeleteShader", DeleteShader);
  load(context, "glCreateProgram", CreateProgram);
  load(context, "glAttachShader", AttachShader);
  load(context, "glLinkProgram", LinkProgram);
  load(context, "glGetProgramiv", GetProgramiv);
  load(context, "glGetProgramInfoLog", GetProgramInfoLog);
  load(context, "glDeleteProgram", DeleteProgram);
  load(context, "glUseProgram", UseProgram);
  load(context, "glGetUniformLocation", GetUniformLocation);
  load(context, "glUniform2f", Uniform2f);
  load(context, "glGenVertexArrays", GenVertexArrays);
  load(context, "glBindVertexArray", BindVertexArray);
  load(context, "glDeleteVertexArrays", DeleteVertexArrays);
  load(context, "glGenBuffers", GenBuffers);
  load(context, "glBindBuffer", BindBuffer);
  load(context, "glBufferData", BufferData);
  load(context, "glDeleteBuffers", DeleteBuffers);
  load(context, "glEnableVertexAttribArray", EnableVertexAttribArray);
  load(context, "glVertexAttribPointer", VertexAttribPointer);
  load(context, "glVertexAttribDivisor", VertexAttribDivisor);
  load(context, "glDrawArraysInstanced", DrawArraysInstanced);
  load(context, "glGenTextures", GenTextures);
  load(context, "glBindTexture", BindTexture);
  load(context, "glTexImage2D", TexImage2D);
  load(context, "glTexParameteri", TexParameteri);
  load(context, "glDeleteTextures", DeleteTextures);
  load(context, "glPixelStorei", PixelStorei);
  load(context, "glGenFramebuffers", GenFramebuffers);
  load(context, "glBindFramebuffer", BindFramebuffer);
  load(context, "glDeleteFramebuffers", DeleteFramebuffers);
  load(context, "glFramebufferRenderbuffer", FramebufferRenderbuffer);
  load(context, "glFramebufferTexture2D", FramebufferTexture2D);
  load(context, "glBlitFramebuffer", BlitFramebuffer);
  load(context, "glCheckFramebufferStatus", CheckFramebufferStatus);
  load(context, "glGenRenderbuffers", GenRenderbuffers);
  load(context, "glBindRenderbuffer", BindRenderbuffer);
  load(context, "glRenderbufferStorage", RenderbufferStorage);
  load(context, "glDeleteRenderbuffers", DeleteRenderbuffers);
  load(context, "glViewport", Viewport);
  load(context, "glScissor", Scissor);
  load(context, "glEnable", Enable);
  load(context, "glDisable", Disable);
  load(context, "glBlendFunc", BlendFunc);
  load(context, "glClearColor", ClearColor);
  load(context, "glClear", Clear);
  load(context, "glReadPixels", ReadPixels);
}

RenderTarget::RenderTarget(const Gl& gl, int width_px, int height_px)
    : gl_(gl), width_px_(width_px), height_px_(height_px) {
  GLint largest = 0;
  gl_.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (width_px < 1 || height_px < 1 || width_px > largest || height_px > largest) {
    throw EnvironmentError("a picture of " + std::to_string(width_px) + "x" + std::to_string(height_px) +
                           " pixels cannot be drawn: each side must be 1 to " + std::to_string(largest));
  }
  gl_.GenRenderbuffers(1, &renderbuffer_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
  gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_px, height_px);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer_);
  if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw EnvironmentError("OpenGL has no memory for a picture of " + std::to_string(width_px) + "x" +
                           std::to_string(height_px) + " pixels; choose a smaller --size");
  }
}

RenderTarget::~RenderTarget() {
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteRenderbuffers(1, &renderbuffer_);
}

void RenderTarget::bind() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, width_px_, height_px_);
}

}  // namespace proofreel
