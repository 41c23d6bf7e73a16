#include <GL/osmesa.h>

#include <array>

#include "render/context_backends.h"
#include "render/context_library.h"

namespace proofreel {
namespace {

/// The few functions of OSMesa that are used. Only their types come from the header.
struct Osmesa {
  LoadedLibrary library{{"libOSMesa.so.8", "libOSMesa.so.6"}, "libosmesa6"};
  decltype(OSMesaCreateContextAttribs)* create =
      library.function<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
  decltype(OSMesaDestroyContext)* destroy = library.function<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext");
  decltype(OSMesaMakeCurrent)* make_current = library.function<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
  decltype(OSMesaGetProcAddress)* proc = library.function<decltype(OSMesaGetProcAddress)>("OSMesaGetProcAddress");
};

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext() {
    const std::array<int, 13> attributes{OSMESA_FORMAT,
                                         OSMESA_RGBA,
                                         OSMESA_DEPTH_BITS,
                                         0,
                                         OSMESA_PROFILE,
                                         OSMESA_CORE_PROFILE,
                                         OSMESA_CONTEXT_MAJOR_VERSION,
                                         3,
                                         OSMESA_CONTEXT_MINOR_VERSION,
                                         3,
                                         0,
                                         0,
                                         0};
    context_ = osmesa_.create(attributes.data(), nullptr);
    if (context_ == nullptr) throw EnvironmentError("it makes no OpenGL 3.3 core context; install a newer libosmesa6");
  }
  ~OsmesaContext() override { osmesa_.destroy(context_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void make_current() override {
    if (osmesa_.make_current(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE) {
      throw EnvironmentError("OSMesa does not let its context be used by this thread");
    }
  }
  void release() override { osmesa_.make_current(nullptr, nullptr, 0, 0, 0); }
  void* proc(const char* name) const override { return reinterpret_cast<void*>(osmesa_.proc(name)); }
  GlBackend backend() const override { return GlBackend::osmesa; }

 private:
  Osmesa osmesa_;
  OSMesaContext context_ = nullptr;
  // OSMesa insists on a buffer of its own. Ours are framebuffer objects, as with EGL.
  std::array<unsigned char, 4> pixel_{};
};

}  // namespace

std::unique_ptr<GlContext> make_osmesa_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace proofreel
