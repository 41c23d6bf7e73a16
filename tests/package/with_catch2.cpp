#define CATCH_CONFIG_MAIN
#define CATCH_CONFIG_FAST_COMPILE
#include <proofreel/golden_catch2.h>

#include "drawn.h"

using namespace proofreel;

TEST_CASE("The gradient is drawn as it was") {
  const std::vector<std::uint8_t> rgba = drawn();
  CHECK_THAT((Pixels{rgba.data(), 96, 64}), MatchesGolden("art/gradient"));
}
