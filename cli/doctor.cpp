#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "render/context.h"
#include "render/png.h"
#include "render/video.h"

namespace proofreel {
namespace {

/// Tries one backend and says how it went; true when it works.
bool try_backend(GlBackend backend, const char* name) {
  std::cout << "GL " << name << ": ";
  try {
    const std::unique_ptr<GlContext> context = make_context(backend);
    const GlInfo info = info_of(*context);
    std::cout << "works: " << info.renderer << ", OpenGL " << info.version << "\n";
    return true;
  } catch (const EnvironmentError& error) {
    std::cout << "does not work. " << error.what() << "\n";
    return false;
  }
}

void tell_of_encoder(const VideoEncoder& encoder) {
  std::cout << "encoder " << encoder.name << ": ";
  if (encoder.available) {
    std::cout << "works: " << encoder.purpose << "\n";
    return;
  }
  try {
    require_encoder(encoder.name);
  } catch (const EnvironmentError& error) {
    std::cout << "missing. " << error.what() << "\n";
  }
}

int doctor() {
  const bool osmesa = try_backend(GlBackend::osmesa, "osmesa");
  const bool egl = try_backend(GlBackend::egl, "egl");
  for (const VideoEncoder& encoder : video_encoders()) tell_of_encoder(encoder);
  std::cout << "font: DejaVu Sans, compiled into the program\n";
  std::cout << "limits: pictures up to " << max_image_side_px << "x" << max_image_side_px
            << " pixels; films of even width and height\n";
  if (osmesa || egl) return 0;
  say("Nothing can be drawn here: install libosmesa6, or libegl1 with libgl1-mesa-dri. Stepping and hashing work.");
  return 3;
}

}  // namespace

Subcommand doctor_command(CLI::App& program) {
  const auto options = std::make_shared<CommonOptions>();
  CLI::App* app =
      add_command(program, "doctor", "What works on this machine, and what to install", "proofreel doctor", *options);
  return {app, [options] { return doctor(); }};
}

}  // namespace proofreel
