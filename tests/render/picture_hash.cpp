// Prints the fingerprint of the sample frame drawn through the backend named by the first argument, and once more when
// it is drawn upon a picture that lacks some of it. The environment decides how Mesa draws it, and Mesa reads it only
// once, so the test starts this program anew for each.

#include <cstdio>

#include "tests/render/painted.h"
#include "tests/render/sample_frame.h"

int main(int count, char** arguments) {
  using namespace proofreel;
  if (count != 2) return 2;
  const std::unique_ptr<GlContext> context = make_context(gl_backend_named(arguments[1]));
  Image image;
  for (const Theme theme : {Theme::light, Theme::dark}) {
    Canvas canvas(*context, 640, 360);
    for (int round = 0; round < 2; ++round) {
      draw_frame(canvas, sample_frame(), {theme}, image);
      std::printf("%016llx\n", static_cast<unsigned long long>(painted::fingerprint(image)));
      draw_frame(canvas, with_layers(sample_frame(), {Layer::bodies, Layer::grid}), {theme}, image);
    }
  }
  return 0;
}
