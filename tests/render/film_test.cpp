#include "render/film.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "render/pixel_hash.h"
#include "scenarios/timeline.h"
#include "tests/render/scratch_folder.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

/// Half a second, 30 frames, of a ball in free fall; `extra` acts on it.
std::unique_ptr<Scenario> falling_ball(const ScratchFolder& folder, const std::string& extra = "") {
  write_text(folder / "ball.lua",
             "scenario { duration = 0.5, size = {64, 48}, view = { center = {0, 2}, height = 8 } }\n"
             "local ball = body { at = {0, 5}, shape = circle { radius = 0.5 } }\n" +
                 extra);
  return load_scenario(folder / "ball.lua", {});
}

/// Keeps the hash of every picture; fails at picture `fails_at`.
class HashList final : public Sink {
 public:
  explicit HashList(std::size_t fails_at = 1000) : fails_at_(fails_at) {}
  void frame(const Image& image) override {
    if (hashes.size() == fails_at_) throw EnvironmentError("the disk is full");
    hashes.push_back(pixel_hash(image));
  }
  void finish() override { finished = true; }

  std::vector<std::string> hashes;
  bool finished = false;

 private:
  std::size_t fails_at_;
};

FilmRequest whole_film(const Scenario& scenario) {
  return {film_timeline(scenario), FrameRange{0, 29}.frames(), std::nullopt, false, 0};
}

HashList film(Scenario& scenario, FrameRange range) {
  HashList sink;
  render_film(scenario, {film_timeline(scenario), range.frames(), std::nullopt, false, 0}, sink, {});
  return sink;
}

TEST_CASE("A film has one picture per frame, in order, each another while the ball falls", "[film]") {
  const ScratchFolder folder;
  const HashList list = film(*falling_ball(folder), {0, 29});
  REQUIRE(list.finished);
  REQUIRE(list.hashes.size() == 30);
  for (std::size_t i = 10; i < 30; ++i) REQUIRE(list.hashes[i] != list.hashes[i - 1]);
}

TEST_CASE("A part of a film is exactly that part of the whole film", "[film]") {
  const ScratchFolder folder;
  const HashList whole = film(*falling_ball(folder), {0, 29});
  const HashList part = film(*falling_ball(folder), {11, 13});
  REQUIRE(part.hashes == std::vector<std::string>(whole.hashes.begin() + 11, whole.hashes.begin() + 14));
  REQUIRE(film(*falling_ball(folder), {29, 29}).hashes == std::vector<std::string>{whole.hashes.back()});
}

TEST_CASE("Nothing is stepped beyond the last frame of the range", "[film]") {
  const ScratchFolder folder;
  const auto scenario = falling_ball(folder, "at(0.4, function() error(\"too far\") end)\n");
  REQUIRE_NOTHROW(film(*scenario, {0, 10}));
}

TEST_CASE("A script that fails stops the film with its own words, and the sink stays unfinished", "[film]") {
  const ScratchFolder folder;
  const auto scenario = falling_ball(folder, "at(0.25, function() error(\"no ground below\") end)\n");
  HashList sink;
  const auto run = [&] { render_film(*scenario, whole_film(*scenario), sink, {}); };
  REQUIRE_THROWS_WITH(run(), Contains("no ground below"));
  REQUIRE_FALSE(sink.finished);
}

TEST_CASE("A sink that fails, at any picture, stops the film with its own error", "[film]") {
  const ScratchFolder folder;
  for (const std::size_t fails_at : {0U, 1U, 7U, 29U}) {
    const auto scenario = falling_ball(folder);
    HashList sink(fails_at);
    const auto run = [&] { render_film(*scenario, whole_film(*scenario), sink, {}); };
    REQUIRE_THROWS_AS(run(), EnvironmentError);
    REQUIRE(sink.hashes.size() == fails_at);
    REQUIRE_FALSE(sink.finished);
  }
}

TEST_CASE("A canvas nobody can draw stops the film with an error of the environment", "[film]") {
  const ScratchFolder folder;
  const auto scenario = falling_ball(folder);
  scenario->picture.size = {1 << 20, 1 << 20};
  REQUIRE_THROWS_AS(film(*scenario, {0, 29}), EnvironmentError);
}

TEST_CASE("Progress counts the frames of the range, and may stop the film", "[film]") {
  const ScratchFolder folder;
  HashList sink;
  std::vector<std::int64_t> counted;
  const auto count = [&](std::int64_t done, std::int64_t total) {
    REQUIRE(total == 5);
    counted.push_back(done);
  };
  const auto scenario = falling_ball(folder);
  render_film(*scenario, {film_timeline(*scenario), FrameRange{10, 14}.frames(), std::nullopt, false, 0}, sink, count);
  REQUIRE(counted == std::vector<std::int64_t>{1, 2, 3, 4, 5});

  const auto stop = [](std::int64_t, std::int64_t) { throw std::runtime_error("stopped"); };
  const auto again = falling_ball(folder);
  HashList unfinished;
  REQUIRE_THROWS_WITH(render_film(*again, whole_film(*again), unfinished, stop), "stopped");
  REQUIRE_FALSE(unfinished.finished);
}

TEST_CASE("A slow sink keeps the script from running ahead", "[film]") {
  const ScratchFolder folder;
  /// Notes how far the script was ahead when a picture arrived.
  class SlowSink final : public Sink {
   public:
    explicit SlowSink(const std::atomic<std::int64_t>& made) : made_(made) {}
    void frame(const Image&) override {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      furthest = std::max(furthest, made_ - taken_++);
    }
    void finish() override {}
    std::int64_t furthest = 0;

   private:
    const std::atomic<std::int64_t>& made_;
    std::int64_t taken_ = 0;
  };
  std::atomic<std::int64_t> made{0};
  SlowSink sink(made);
  const auto scenario = falling_ball(folder);
  render_film(*scenario, whole_film(*scenario), sink, [&made](std::int64_t done, std::int64_t) { made = done; });
  REQUIRE(sink.furthest <= 8);
}

}  // namespace
}  // namespace proofreel
