#include "render/png.h"

#include <libdeflate.h>
#include <spng.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <new>

#include "render/mapped_file.h"
#include "render/output_file.h"

namespace {

/// What stb_image_write calls instead of its own, slower and weaker compressor. The result is freed by stb.
unsigned char* compress_zlib(unsigned char* data, int size, int* compressed_size, int level) {
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(level);
  if (compressor == nullptr) return nullptr;
  const auto in_size = static_cast<std::size_t>(size);
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor, in_size);
  auto* out = static_cast<unsigned char*>(std::malloc(bound));
  const std::size_t used = out == nullptr ? 0 : libdeflate_zlib_compress(compressor, data, in_size, out, bound);
  libdeflate_free_compressor(compressor);
  *compressed_size = static_cast<int>(used);
  return out;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress_zlib
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace proofreel {
namespace {

/// What texts, colour profiles and the like may take once unpacked. A few kilobytes can unpack to gigabytes.
constexpr std::size_t max_extra_bytes = std::size_t{16} << 20U;

bool opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 255) return false;
  }
  return true;
}

std::vector<std::uint8_t> without_alpha(const Image& image) {
  std::vector<std::uint8_t> rgb(image.rgba.size() / 4 * 3);
  for (std::size_t from = 0, to = 0; from < image.rgba.size(); from += 4, to += 3) {
    std::copy_n(&image.rgba[from], 3, &rgb[to]);
  }
  return rgb;
}

std::vector<std::uint8_t> encode(const Image& image, const std::uint8_t* pixels, int channels) {
  int size = 0;
  const std::unique_ptr<unsigned char, decltype(&std::free)> bytes(
      stbi_write_png_to_mem(pixels, image.width_px * channels, image.width_px, image.height_px, channels, &size),
      &std::free);
  if (!bytes) throw std::bad_alloc();
  return {bytes.get(), bytes.get() + size};
}

bool has_signature(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  return bytes.size() >= signature.size() && std::equal(signature.begin(), signature.end(), bytes.begin());
}

[[noreturn]] void refuse_size(const std::string& name) {
  throw ImageError(name + " is too large: at most " + std::to_string(max_image_side_px) + " pixels a side and " +
                   std::to_string(max_image_pixels) + " in all are read.");
}

/// Asks for memory in large pages, where there are such: a large picture then takes a sixth less time to decode, since
/// its memory is not handed out in 4 KB pieces. Nothing is lost when the answer is no.
void prefer_large_pages(PixelBytes& bytes) {
  constexpr std::uintptr_t page = 4096;
  constexpr std::size_t worth_it = std::size_t{8} << 20U;
  if (bytes.size() < worth_it) return;
  const auto start = reinterpret_cast<std::uintptr_t>(bytes.data());
  const std::uintptr_t first = (start + page - 1) / page * page;
  ::madvise(reinterpret_cast<void*>(first), (start + bytes.size() - first) / page * page, MADV_HUGEPAGE);
}

using Decoder = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

void check(int status, const std::string& name) {
  if (status == SPNG_OK) return;
  if (status == SPNG_EOF || status == SPNG_IO_EOF) throw ImageError(name + " is truncated: its end is missing.");
  if (status == SPNG_EUSER_WIDTH || status == SPNG_EUSER_HEIGHT) refuse_size(name);
  if (status == SPNG_ECHUNK_LIMITS) throw ImageError(name + " is not read: it carries too much beside its pixels.");
  if (status == SPNG_EMEM) throw std::bad_alloc();
  throw ImageError(name + " is damaged: " + spng_strerror(status) + ".");
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image) {
  // Level and filter by measurement on drawn frames: flat areas compress best when no row is filtered, and level 6
  // takes a third of the time of level 9 for 13 % more bytes.
  stbi_write_png_compression_level = 6;
  stbi_write_force_png_filter = 0;
  return opaque(image) ? encode(image, without_alpha(image).data(), 3) : encode(image, image.rgba.data(), 4);
}

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  const Decoder decoder(spng_ctx_new(0), &spng_ctx_free);
  if (!decoder) throw std::bad_alloc();
  if (!has_signature(bytes)) throw ImageError(name + " is not a PNG file.");
  spng_set_image_limits(decoder.get(), max_image_side_px, max_image_side_px);
  spng_set_chunk_limits(decoder.get(), max_extra_bytes, max_extra_bytes);
  check(spng_set_png_buffer(decoder.get(), bytes.data(), bytes.size()), name);
  spng_ihdr header{};
  check(spng_get_ihdr(decoder.get(), &header), name);
  if (std::int64_t{header.width} * header.height > max_image_pixels) refuse_size(name);
  Image image = Image::uncleared(static_cast<int>(header.width), static_cast<int>(header.height));
  prefer_large_pages(image.rgba);
  check(spng_decode_image(decoder.get(), image.rgba.data(), image.rgba.size(), SPNG_FMT_RGBA8, SPNG_DECODE_TRNS), name);
  check(spng_decode_chunks(decoder.get()), name);
  return image;
}

Image read_png(const std::string& path) {
  const MappedFile file(path);
  if (!file.problem().empty()) throw ImageError("Cannot read " + path + ": " + file.problem() + ".");
  return decode_png(file.bytes(), path);
}

void write_png(const std::string& path, const Image& image) { write_file(path, encode_png(image)); }

}  // namespace proofreel
