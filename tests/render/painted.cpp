#include "tests/render/painted.h"

#include <algorithm>
#include <cstdlib>

namespace proofreel::painted {

GlContext& context() {
  static GlContext& shared = *make_context(std::nullopt).release();  // at the program's end Mesa may be gone before it
  return shared;
}

Image picture(int width_px, int height_px, const std::function<void(Canvas&)>& draw) {
  Canvas canvas(context(), width_px, height_px);
  canvas.clear(white);
  draw(canvas);
  Image image;
  canvas.finish(image);
  return image;
}

double ink(const Image& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += (255 - image.rgba[i]) / 255.0;
  return sum;
}

int red(const Image& image, int x, int y) {
  return image
      .rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width_px) + static_cast<std::size_t>(x))];
}

int largest_difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) largest = std::max(largest, std::abs(a.rgba[i] - b.rgba[i]));
  return largest;
}

std::uint64_t fingerprint(const Image& image) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const std::uint8_t byte : image.rgba) hash = (hash ^ byte) * 1099511628211ULL;
  return hash;
}

}  // namespace proofreel::painted
