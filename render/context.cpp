#include "render/context.h"

#include <array>
#include <cstdlib>
#include <mutex>

#include "render/context_backends.h"
#include "render/gl.h"

namespace proofreel {
namespace {

const char* name_of(GlBackend backend) { return backend == GlBackend::osmesa ? "osmesa" : "egl"; }

std::string text_of(const Gl& gl, GLenum what) {
  const GLubyte* text = gl.GetString(what);
  return text == nullptr ? std::string("(nothing)") : std::string(reinterpret_cast<const char*>(text));
}

/// Both backends read these when they are loaded. Only llvmpipe draws the bytes the golden pictures were made of. Done
/// once: while one thread makes a context, another may already draw, and Mesa reads the environment as it likes.
void force_llvmpipe() {
  static std::once_flag done;
  std::call_once(done, [] {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  });
}

void require_version(const Gl& gl) {
  GLint major = 0;
  GLint minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major < 3 || (major == 3 && minor < 3)) {
    throw EnvironmentError("it offers OpenGL " + text_of(gl, GL_VERSION) + ", and 3.3 is needed; install a newer Mesa");
  }
}

void require_llvmpipe(const Gl& gl) {
  const std::string renderer = text_of(gl, GL_RENDERER);
  if (renderer.rfind("llvmpipe", 0) != 0) {
    throw EnvironmentError("it draws with " + renderer +
                           ", whose pixels differ from llvmpipe's; install a Mesa built with LLVM (libgl1-mesa-dri)");
  }
}

/// A library that answers but draws nothing is found out here.
void require_pixel(const Gl& gl) {
  const RenderTarget target(gl, 1, 1);
  target.bind();
  gl.ClearColor(1, 0, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  std::array<unsigned char, 4> pixel{};
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  if (pixel != std::array<unsigned char, 4>{255, 0, 255, 255}) {
    throw EnvironmentError("it draws nothing: a magenta pixel came back as another colour; reinstall Mesa");
  }
}

std::unique_ptr<GlContext> make_tested(GlBackend backend) {
  force_llvmpipe();
  try {
    std::unique_ptr<GlContext> context = backend == GlBackend::osmesa ? make_osmesa_context() : make_egl_context();
    context->make_current();
    const Gl gl(*context);
    require_version(gl);
    require_llvmpipe(gl);
    require_pixel(gl);
    return context;
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(std::string(name_of(backend)) + ": " + error.what());
  }
}

}  // namespace

std::optional<GlBackend> gl_backend_named(std::string_view name) {
  if (name == "osmesa") return GlBackend::osmesa;
  if (name == "egl") return GlBackend::egl;
  return std::nullopt;
}

GlInfo info_of(GlContext& context) {
  const Gl gl(context);
  return {name_of(context.backend()), text_of(gl, GL_RENDERER), text_of(gl, GL_VERSION)};
}

std::unique_ptr<GlContext> make_context(std::optional<GlBackend> backend) {
  if (backend) return make_tested(*backend);
  try {
    return make_tested(GlBackend::osmesa);
  } catch (const EnvironmentError& first) {
    try {
      return make_tested(GlBackend::egl);
    } catch (const EnvironmentError& second) {
      throw EnvironmentError("no software OpenGL works here. Tried " + std::string(first.what()) + ". Tried " +
                             second.what() + ".");
    }
  }
}

}  // namespace proofreel
