#pragma once

/// A software OpenGL context without a screen. The GL libraries are loaded when one is made, never linked, so the
/// program starts and steps scenes on machines that have none.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scenarios/environment_error.h"

namespace proofreel {

enum class GlBackend { osmesa, egl };
std::optional<GlBackend> gl_backend_named(std::string_view name);

class GlContext {
 public:
  virtual ~GlContext() = default;
  /// Makes this the context of the calling thread.
  virtual void make_current() = 0;
  /// Gives it up, so that another thread may take it.
  virtual void release() = 0;
  virtual void* proc(const char* name) const = 0;
  virtual GlBackend backend() const = 0;
};

/// What the GL behind a context calls itself.
struct GlInfo {
  std::string backend;   ///< "osmesa" or "egl"
  std::string renderer;  ///< GL_RENDERER, "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version;   ///< GL_VERSION, with the Mesa version
};
GlInfo info_of(GlContext& context);

/// A context of the given kind, or without one of the first kind that works (OSMesa, then EGL), current on the calling
/// thread. It has passed a self-test: GL 3.3 or newer, llvmpipe, and one drawn pixel read back.
/// Throws EnvironmentError that says what was tried and what to install.
std::unique_ptr<GlContext> make_context(std::optional<GlBackend> backend);

}  // namespace proofreel
