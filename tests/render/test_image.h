#pragma once

#include <random>

#include "render/image.h"

namespace proofreel {

inline Image filled_image(int width, int height, std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a = 255) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    image.rgba[i] = r;
    image.rgba[i + 1] = g;
    image.rgba[i + 2] = b;
    image.rgba[i + 3] = a;
  }
  return image;
}

inline Image noise_image(int width, int height, unsigned seed, bool opaque) {
  Image image(width, height);
  std::mt19937 random(seed);
  for (std::uint8_t& byte : image.rgba) byte = static_cast<std::uint8_t>(random() & 255U);
  for (std::size_t i = 3; opaque && i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

}  // namespace proofreel
