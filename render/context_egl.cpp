#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <sstream>

#include "render/context_backends.h"
#include "render/context_library.h"

namespace proofreel {
namespace {

/// The few functions of EGL that are used. Only their types come from the header.
struct Egl {
  LoadedLibrary library{{"libEGL.so.1"}, "libegl1, libegl-mesa0 and libgl1-mesa-dri"};
  decltype(eglGetProcAddress)* proc = library.function<decltype(eglGetProcAddress)>("eglGetProcAddress");
  decltype(eglInitialize)* initialize = library.function<decltype(eglInitialize)>("eglInitialize");
  decltype(eglBindAPI)* bind_api = library.function<decltype(eglBindAPI)>("eglBindAPI");
  decltype(eglChooseConfig)* choose_config = library.function<decltype(eglChooseConfig)>("eglChooseConfig");
  decltype(eglCreateContext)* create = library.function<decltype(eglCreateContext)>("eglCreateContext");
  decltype(eglDestroyContext)* destroy = library.function<decltype(eglDestroyContext)>("eglDestroyContext");
  decltype(eglMakeCurrent)* make_current = library.function<decltype(eglMakeCurrent)>("eglMakeCurrent");
  decltype(eglGetError)* error = library.function<decltype(eglGetError)>("eglGetError");
};

[[noreturn]] void fail(const Egl& egl, const char* what) {
  std::ostringstream sentence;
  sentence << what << " (EGL error 0x" << std::hex << egl.error() << "); install libegl-mesa0 and libgl1-mesa-dri";
  throw EnvironmentError(sentence.str());
}

EGLDisplay surfaceless_display(const Egl& egl) {
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl.proc("eglGetPlatformDisplayEXT"));
  if (get_display == nullptr) fail(egl, "it has no eglGetPlatformDisplayEXT");
  const EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (display == EGL_NO_DISPLAY) fail(egl, "it has no display without a surface");
  if (egl.initialize(display, nullptr, nullptr) == EGL_FALSE) fail(egl, "its surfaceless display does not start");
  return display;
}

EGLConfig any_config(const Egl& egl, EGLDisplay display) {
  const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (egl.choose_config(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
    fail(egl, "its surfaceless display does not draw with OpenGL");
  }
  return config;
}

class EglContext final : public GlContext {
 public:
  EglContext() : display_(surfaceless_display(egl_)) {
    const std::array<EGLint, 7> attributes{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    egl_.bind_api(EGL_OPENGL_API);
    context_ = egl_.create(display_, any_config(egl_, display_), EGL_NO_CONTEXT, attributes.data());
    if (context_ == EGL_NO_CONTEXT) fail(egl_, "it makes no OpenGL 3.3 core context");
  }
  // The display is shared by all contexts of the process and stays open until its end.
  ~EglContext() override { egl_.destroy(display_, context_); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() override {
    egl_.bind_api(EGL_OPENGL_API);  // each thread has its own, and starts with OpenGL ES
    if (egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
      fail(egl_, "EGL does not let its context be used by this thread");
    }
  }
  void release() override { egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
  void* proc(const char* name) const override { return reinterpret_cast<void*>(egl_.proc(name)); }
  GlBackend backend() const override { return GlBackend::egl; }

 private:
  Egl egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context() { return std::make_unique<EglContext>(); }

}  // namespace proofreel
