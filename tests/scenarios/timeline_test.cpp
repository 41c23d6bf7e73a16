#include "scenarios/timeline.h"

#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

TEST_CASE("Ten seconds at 60 frames per second are frames 0 to 599") {
  const auto frames = film_timeline(*load_text("scenario{duration=10}"));
  REQUIRE(frames.size() == 600);
  CHECK(frames[1] == 4);
  CHECK(frames.back() == 599 * 4);
}

TEST_CASE("A run lasts the nearest whole number of ticks") {
  CHECK(load_text("scenario{duration=0.1}")->ticks() == 24);
  CHECK(load_text("scenario{duration=1.006}")->ticks() == 241);
}

TEST_CASE("A film that ends between two frames shows the frames before its end") {
  CHECK(film_timeline(*load_text("scenario{duration=5/240}")).size() == 2);
}

TEST_CASE("Rates that do not fit the film name those that do") {
  CHECK_THROWS_WITH(film_timeline(*load_text("scenario{rate=250}")),
                    Contains("the nearest rates that work are 240 or 300"));
  CHECK_THROWS_WITH(film_timeline(*load_text("scenario{rate=50}")), Contains("the nearest rates that work are 60"));
}

TEST_CASE("Slow motion shows more frames of its stretch") {
  const auto frames = film_timeline(*load_text("scenario{duration=1}\nslow{from=0.5, to=0.6, factor=0.25}"));
  CHECK(frames.size() == 30 + 24 + 24);
  CHECK(frames[30] == 120);
  CHECK(frames[31] == 121);
  CHECK(frames[30 + 24] == 144);
  CHECK(frames[30 + 25] == 148);
}

TEST_CASE("Slow motion between two ticks names factors and rates that work") {
  const auto scenario = load_text("scenario{}\nslow{from=0, to=1, factor=0.3}");
  CHECK_THROWS_WITH(film_timeline(*scenario),
                    Contains("a frame every 1.2 ticks") && Contains("factor = 0.25 or 0.5") && Contains("rate = 600"));
  CHECK_THROWS_WITH(film_timeline(*load_text("scenario{}\nslow{from=0, to=1, factor=0.1}")),
                    Contains("factor = 0.25 or 0.5, or rate = 600"));
}

TEST_CASE("Samples lie at the frames and at the end") {
  const auto scenario = load_text("scenario{duration=10/240}");
  for (std::int64_t tick = 0; tick <= 10; ++tick)
    CHECK(is_sample_tick(*scenario, tick) == (tick % 4 == 0 || tick == 10));
}

TEST_CASE("Where frames fall between ticks, samples lie at the nearest") {
  const auto scenario = load_text("scenario{duration=1, rate=100}");
  int samples = 0;
  for (std::int64_t tick = 0; tick <= 100; ++tick) samples += is_sample_tick(*scenario, tick) ? 1 : 0;
  CHECK(samples == 61);
  CHECK(is_sample_tick(*scenario, 2));
  CHECK(is_sample_tick(*scenario, 3));
  CHECK_FALSE(is_sample_tick(*scenario, 4));
}
