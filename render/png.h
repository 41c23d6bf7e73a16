#pragma once

/// PNG files, written through stb_image_write with libdeflate, read through libspng.

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/image.h"

namespace proofreel {

/// A picture file that cannot be used: a sentence with the file's name and what is wrong with it.
class ImageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The longest side of a picture anybody draws, reads or writes: what llvmpipe can draw into.
inline constexpr int max_image_side_px = 16384;

/// The most pixels a PNG may have to be read, 256 MB of them: a file of a few kilobytes can claim any size.
inline constexpr std::int64_t max_image_pixels = std::int64_t{1} << 26;

/// The bytes of a PNG file: 24 bits per pixel when the image is opaque, else 32. The same image gives the same bytes.
std::vector<std::uint8_t> encode_png(const Image& image);

/// Any PNG, as RGBA8 (of 16 bits per channel the upper 8); `name` is what errors call it. Whatever the bytes are, no
/// more memory is taken than the picture needs and 16 MB. Throws ImageError: not a PNG, truncated, damaged, too large.
Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name);

/// Throws ImageError, also when the file cannot be read.
Image read_png(const std::string& path);

/// Throws EnvironmentError when the file cannot be written.
void write_png(const std::string& path, const Image& image);

}  // namespace proofreel
