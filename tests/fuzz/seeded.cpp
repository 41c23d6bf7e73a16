// Stands in for a fuzzer where there is none: a fixed number of seeded random inputs, the same every time, and the
// files named on the command line.

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

#include "tests/engine/random.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::vector<std::uint8_t> random_input(proofreel::Random& random) {
  std::vector<std::uint8_t> bytes(16 + random.below(480));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits() >> 56);
  return bytes;
}

std::vector<std::uint8_t> contents_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

/// seeded COUNT [FILE...]
int main(int argc, char** argv) {
  proofreel::Random random(2020);
  const int count = argc > 1 ? std::atoi(argv[1]) : 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<std::uint8_t> input = random_input(random);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  for (int i = 2; i < argc; ++i) {
    const std::vector<std::uint8_t> input = contents_of(argv[i]);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
}
