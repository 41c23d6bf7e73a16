// PNG files out of arbitrary bytes: chunks with right checksums around any content, so that more than the first check
// is reached. Whatever they are: a picture of the size it says, or a sentence with the file's name; no crash, no end of
// memory.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "render/png.h"
#include "tests/fuzz/bytes.h"
#include "tests/render/png_bytes.h"

namespace proofreel::fuzz {
namespace {

void require(bool holds, const char* claim) {
  if (holds) return;
  std::fprintf(stderr, "It does not hold that %s.\n", claim);
  std::abort();
}

PngBytes some_of(Bytes& bytes, int most) {
  PngBytes some;
  for (int left = bytes.below(most + 1); left > 0 && !bytes.empty(); --left) some.push_back(bytes.byte());
  return some;
}

/// Mostly small and valid, now and then anything.
PngHeader header_from(Bytes& bytes) {
  constexpr std::uint8_t depths[] = {1, 2, 4, 8, 16}, colors[] = {0, 2, 3, 4, 6};
  const auto side = [&bytes]() -> std::uint32_t {
    return bytes.below(16) == 0 ? static_cast<std::uint32_t>(bytes.word())
                                : 1U + static_cast<std::uint32_t>(bytes.below(40));
  };
  const std::uint32_t width = side(), height = side();
  const std::uint8_t depth = depths[bytes.below(5)], color = colors[bytes.below(5)];
  return {width, height, depth, color, static_cast<std::uint8_t>(bytes.below(2))};
}

PngBytes chunks_from(Bytes& bytes) {
  const std::string types[] = {"PLTE", "tRNS", "zTXt", "iTXt", "tEXt", "iCCP", "gAMA", "sBIT",
                               "sPLT", "bKGD", "hIST", "eXIf", "IDAT", "IEND", "anIm"};
  PngBytes chunks;
  for (int left = bytes.below(5); left > 0; --left) {
    const std::string& type = types[bytes.below(15)];
    PngBytes data = some_of(bytes, 60);
    if (bytes.below(3) == 0) {
      const PngBytes packed = compressed(some_of(bytes, 60));
      data.insert(data.end(), packed.begin(), packed.end());
    }
    const PngBytes chunk = png_chunk(type, data);
    chunks.insert(chunks.end(), chunk.begin(), chunk.end());
  }
  return chunks;
}

PngBytes file_from(Bytes& bytes) {
  const PngHeader header = header_from(bytes);
  const PngBytes chunks = chunks_from(bytes);
  PngBytes rows = some_of(bytes, 255);
  if (bytes.below(2) == 0) rows.resize(20000);  // enough for any of these sizes
  PngBytes file = png_file(header, rows, chunks);
  for (int flips = bytes.below(8) == 0 ? 3 : 0; flips > 0; --flips) file[bytes.word() % file.size()] = bytes.byte();
  if (bytes.below(8) == 0) file.resize(bytes.word() % file.size());
  return file;
}

void check(const PngBytes& file) {
  try {
    const Image image = decode_png(file, "fuzzed.png");
    require(image.width_px > 0 && image.height_px > 0, "a picture has a size");
    require(
        image.rgba.size() == static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.height_px) * 4,
        "a picture has all its bytes");
  } catch (const ImageError& error) {
    require(std::string(error.what()).find("fuzzed.png") != std::string::npos, "a refusal names the file");
  }
}

}  // namespace
}  // namespace proofreel::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  proofreel::fuzz::Bytes bytes({data, size});
  proofreel::fuzz::check(proofreel::fuzz::file_from(bytes));
  return 0;
}
