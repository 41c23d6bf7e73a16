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

TEST_CASE("A freeze shows its frame for so long again, and nothing else changes") {
  const auto frames = film_timeline(*load_text("scenario{duration=1}\nfreeze{at=0.5, seconds=0.2}"));
  REQUIRE(frames.size() == 60 + 12);
  for (std::size_t i = 30; i <= 42; ++i) CHECK(frames[i] == 120);
  CHECK(frames[29] == 116);
  CHECK(frames[43] == 124);
  CHECK(frames.back() == 236);
}

TEST_CASE("A freeze between two frames holds the one after it, at the beginning the first one") {
  const auto frames = film_timeline(*load_text("scenario{duration=1}\nfreeze{at=0.505, seconds=0.1}"));
  CHECK(frames[30] == 120);
  CHECK(frames[31] == 124);
  CHECK(frames[37] == 124);
  CHECK(frames[38] == 128);
  CHECK(film_timeline(*load_text("scenario{duration=1}\nfreeze{at=0, seconds=1}")).size() == 120);
}

TEST_CASE("Freezes and slow motion go together") {
  const auto frames =
      film_timeline(*load_text("scenario{duration=1}\nslow{from=0.5, to=0.6, factor=0.25}\nfreeze{at=0.5, seconds=0.1} "
                               "freeze{at=0.5, seconds=0.1}"));
  CHECK(frames.size() == 30 + 24 + 24 + 12);
}

TEST_CASE("Slow stretches may follow one another but not overlap") {
  CHECK(error_of("scenario{}\nslow{from=1, to=2, factor=0.5} slow{from=2, to=3, factor=0.25}").empty());
  CHECK_THAT(error_of("scenario{}\nslow{from=1, to=2, factor=0.5}\nslow{from=1.5, to=3, factor=0.5}"),
             Contains("line 3") && Contains("overlap"));
}

TEST_CASE("Sections are parts of the film, each as long as it takes to the next one") {
  const auto scenario = load_text(
      "scenario{duration=1}\nfreeze{at=0.6, seconds=0.5}\nsection{at=0, name='up'} section{at=0.5, name='down'}");
  const auto sections = film_sections(*scenario, film_timeline(*scenario));
  REQUIRE(sections.size() == 2);
  CHECK(sections[0].name == "up");
  CHECK(sections[0].first == 0);
  CHECK(sections[0].last == 29);
  CHECK(sections[1].first == 30);
  CHECK(sections[1].last == 89);
}

TEST_CASE("A section without a frame of its own is left out") {
  const auto scenario = load_text(
      "scenario{duration=1}\nsection{at=0.5, name='a'} section{at=0.505, name='b'} "
      "section{at=0.51, name='c'} section{at=0.99, name='d'}");
  const auto sections = film_sections(*scenario, film_timeline(*scenario));
  REQUIRE(sections.size() == 2);
  CHECK(sections[0].name == "a");
  CHECK(sections[0].last == 30);
  CHECK(sections[1].name == "c");
}

TEST_CASE("What is demonstrated has its headings for sections") {
  const auto scenario = load_text(
      "scenario{}\ndemonstrate{algorithm='gift_wrapping', points={{0,0},{1,0},{0,1}}}\n"
      "demonstrate{algorithm='centroid', points={{0,0},{1,0},{0,1}}}");
  const auto timeline = film_timeline(*scenario);
  const auto sections = film_sections(*scenario, timeline);
  REQUIRE(sections.size() == 2);
  CHECK(sections[0].first == 0);
  CHECK(sections[1].first == sections[0].last + 1);
  CHECK(sections[1].last == static_cast<std::int64_t>(timeline.size()) - 1);
}

TEST_CASE("Sections and freezes that make no sense are refused by name") {
  CHECK_THAT(error_of("scenario{}\nsection{at=2, name='a'} section{at=1, name='b'}"),
             Contains("line 2") && Contains("section: at must come after that of the section before, \"a\""));
  CHECK_THAT(error_of("scenario{}\nsection{at=1}"), Contains("section") && Contains("name"));
  CHECK_THAT(error_of("scenario{}\nsection{at=1, name=''}"), Contains("name must not be empty"));
  CHECK_THAT(error_of("scenario{duration=5}\nsection{at=6, name='late'}"),
             Contains("\"late\"") && Contains("never comes"));
  CHECK_THAT(error_of("scenario{duration=5}\nfreeze{at=6, seconds=1}"), Contains("freeze: at = 6 never comes"));
  CHECK_THAT(error_of("scenario{}\nfreeze{at=1}"), Contains("seconds"));
  CHECK_THAT(error_of("scenario{}\nfreeze{at=1, seconds=0}"), Contains("seconds") && Contains("positive"));
  CHECK_THAT(error_of("scenario{}\nfreeze{at=1, seconds=4000}"), Contains("3600"));
  CHECK_THAT(error_of("scenario{}\nat(1, function() freeze{at=2, seconds=1} end)\n"), !Contains("line 1"));
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
