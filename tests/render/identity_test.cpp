#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <string>

namespace {

/// What picture_hash prints under the given environment.
std::string printed(const std::string& environment, const std::string& backend) {
  const std::string command = "env " + environment + " " PICTURE_HASH " " + backend;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  std::array<char, 256> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) text += buffer.data();
  CHECK(pclose(pipe) == 0);
  return text;
}

}  // namespace

TEST_CASE("A picture has the same bytes through both backends") {
  const std::string expected = printed("", "osmesa");
  CHECK(expected.size() == 4 * 17);
  CHECK(printed("", "egl") == expected);
}

TEST_CASE("A picture has the same bytes for all thread counts, vector widths and instruction sets") {
  const std::string expected = printed("", "osmesa");
  for (const char* environment :
       {"LP_NUM_THREADS=0", "LP_NUM_THREADS=2", "LP_NATIVE_VECTOR_WIDTH=128", "LP_NATIVE_VECTOR_WIDTH=256",
        "GALLIUM_OVERRIDE_CPU_CAPS=sse2", "GALLIUM_OVERRIDE_CPU_CAPS=sse4.1", "GALLIUM_OVERRIDE_CPU_CAPS=avx"}) {
    INFO(environment);
    CHECK(printed(environment, "osmesa") == expected);
  }
}

TEST_CASE("A wish for another driver is overruled, since it would draw other bytes") {
  CHECK(printed("GALLIUM_DRIVER=softpipe", "osmesa") == printed("", "osmesa"));
}
