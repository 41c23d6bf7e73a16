#include "render/context.h"

#include <catch2/catch.hpp>

#include "tests/render/painted.h"

using namespace proofreel;

TEST_CASE("Backends go by the names of the command line") {
  CHECK(gl_backend_named("osmesa") == GlBackend::osmesa);
  CHECK(gl_backend_named("egl") == GlBackend::egl);
  CHECK_FALSE(gl_backend_named("glx").has_value());
  CHECK_FALSE(gl_backend_named("").has_value());
}

TEST_CASE("Both backends draw with llvmpipe, and with OpenGL 3.3 or newer") {
  for (const GlBackend backend : {GlBackend::osmesa, GlBackend::egl}) {
    const std::unique_ptr<GlContext> context = make_context(backend);
    const GlInfo info = info_of(*context);
    CHECK(context->backend() == backend);
    CHECK(gl_backend_named(info.backend) == backend);
    CHECK(info.renderer.rfind("llvmpipe", 0) == 0);
    CHECK(info.version.find("Mesa") != std::string::npos);
  }
}

TEST_CASE("A released context can be used by another canvas later") {
  const std::unique_ptr<GlContext> context = make_context(std::nullopt);
  Image first;
  Image second;
  {
    Canvas canvas(*context, 8, 8);
    canvas.clear({10, 20, 30, 255});
    canvas.finish(first);
  }
  context->release();
  Canvas canvas(*context, 8, 8);
  canvas.clear({10, 20, 30, 255});
  canvas.finish(second);
  CHECK(first.rgba == second.rgba);
  CHECK(first.rgba[1] == 20);
}

TEST_CASE("A picture of impossible size is refused with its size") {
  for (const int width : {0, -5, 1000000}) {
    try {
      Canvas canvas(painted::context(), width, 10);
      FAIL("accepted a width of " << width);
    } catch (const EnvironmentError& error) {
      CHECK_THAT(error.what(), Catch::Contains(std::to_string(width) + "x10"));
    }
  }
}
