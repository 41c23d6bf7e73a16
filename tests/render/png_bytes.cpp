#include "tests/render/png_bytes.h"

#include <libdeflate.h>

namespace proofreel {
namespace {

void append(PngBytes& bytes, const PngBytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

void append_word(PngBytes& bytes, std::uint32_t word) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(word >> shift & 255U));
}

}  // namespace

PngBytes png_chunk(const std::string& type, const PngBytes& data) {
  PngBytes named(type.begin(), type.end());
  append(named, data);
  PngBytes chunk;
  append_word(chunk, static_cast<std::uint32_t>(data.size()));
  append(chunk, named);
  append_word(chunk, libdeflate_crc32(0, named.data(), named.size()));
  return chunk;
}

PngBytes compressed(const PngBytes& data) {
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(9);
  PngBytes out(libdeflate_zlib_compress_bound(compressor, data.size()));
  out.resize(libdeflate_zlib_compress(compressor, data.data(), data.size(), out.data(), out.size()));
  libdeflate_free_compressor(compressor);
  return out;
}

PngBytes png_file(const PngHeader& header, const PngBytes& rows, const PngBytes& before) {
  PngBytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  PngBytes words;
  append_word(words, header.width);
  append_word(words, header.height);
  append(words, {header.bit_depth, header.color_type, 0, 0, header.interlace});
  append(file, png_chunk("IHDR", words));
  append(file, before);
  append(file, png_chunk("IDAT", compressed(rows)));
  append(file, png_chunk("IEND", {}));
  return file;
}

}  // namespace proofreel
