#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>

#include "lab/bench.h"
#include "lab/bench_process.h"
#include "render/film.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

/// What is filmed, and how many times the encoder's own time that may take.
struct Clip {
  const char* path;
  const char* what;
  double target_ratio;
};
constexpr Clip crowd{PROOFREEL_SCENARIOS "/bench/clip.lua", "four hundred falling bodies", 1.3};
constexpr Clip lecture{PROOFREEL_SCENARIOS "/bench/lecture.lua", "a lecture with plots, captions and formulas", 1.15};
constexpr const char* preset = "veryfast";
constexpr int crf = 18;
constexpr int rounds = 5;
constexpr double target_megabytes = 400;

/// Keeps the first `most` pictures of a film, as pictures that come from anywhere: how they differ from one another is
/// not known.
class KeepingSink final : public Sink {
 public:
  explicit KeepingSink(std::size_t most) : most_(most) {}
  void frame(const Image& image) override {
    if (images_.size() == most_) return;
    images_.push_back(image);
    images_.back().rgba.become({});
  }
  void finish() override {}
  std::vector<Image> take() { return std::move(images_); }

 private:
  std::size_t most_;
  std::vector<Image> images_;
};

/// Bytes the machine could give us now.
std::int64_t free_memory() {
  std::ifstream info("/proc/meminfo");
  std::string word;
  while (info >> word) {
    std::int64_t kilobytes = 0;
    if (word == "MemAvailable:" && info >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

struct Film {
  std::vector<Image> images;
  std::int64_t frames = 0;  ///< of the whole film; may be more than there are images
  FilmSettings settings;
};

/// As many of the clip's pictures as fit into half of the free memory.
Film draw(const Clip& clip) {
  const std::unique_ptr<Scenario> scenario = load_scenario(clip.path, {});
  const Picture& picture = scenario->picture;
  FilmRequest request;
  request.timeline = film_timeline(*scenario);
  const auto frames = static_cast<std::int64_t>(request.timeline.size());
  const std::int64_t bytes = std::int64_t{4} * picture.size.width_px * picture.size.height_px;
  const std::int64_t kept = std::clamp(free_memory() / 2 / bytes, std::int64_t{2}, frames);
  request.frames = FrameRange{0, kept - 1}.frames();
  KeepingSink sink(static_cast<std::size_t>(kept));
  render_film(*scenario, request, sink, {});
  return {sink.take(), frames, {.size = picture.size, .fps = picture.fps, .preset = preset, .crf = crf}};
}

/// Too few images are played forth and back: no cut, which would cost the encoder more.
std::size_t image_of_frame(std::int64_t frame, std::size_t images) {
  const auto last = static_cast<std::int64_t>(images) - 1;
  const std::int64_t step = frame % (2 * last);
  return static_cast<std::size_t>(step <= last ? step : 2 * last - step);
}

Cost encode(const Film& film, const std::string& out) {
  const Stopwatch watch;
  const std::unique_ptr<Sink> sink = make_sink(out, film.settings);
  for (std::int64_t i = 0; i < film.frames; ++i) sink->frame(film.images[image_of_frame(i, film.images.size())]);
  sink->finish();
  return watch.elapsed();
}

std::vector<std::string> command_for(const Clip& clip, const std::string& out) {
  return {"render", clip.path, "-o", out, "--preset", preset, "--crf", std::to_string(crf), "--quiet"};
}

void print_memory(const TemporaryFolder& folder) {
  std::vector<std::string> command = command_for(crowd, folder / "memory.mp4");
  const double once = 1e-6 * static_cast<double>(peak_memory_of_program(command));
  command.insert(command.end(), {"--set", "duration=10"});
  const double twice = 1e-6 * static_cast<double>(peak_memory_of_program(command));
  std::printf("  memory at most: %.0f MB; with a clip twice as long: %.0f MB (target %.0f MB, both)\n", once, twice,
              target_megabytes);
}

void print_side(const char* what, Cost cost, std::int64_t frames) {
  std::printf("  %-44s %5.2f s wall, %5.2f s CPU, %3.0f frames per second\n", what, cost.wall_s, cost.cpu_s,
              static_cast<double>(frames) / cost.wall_s);
}

void print_film(const Clip& clip, const Film& film) {
  std::printf("  %s: %lld frames of %dx%d, x264 %s, crf %d; both sides in turns, medians of %d\n", clip.what,
              static_cast<long long>(film.frames), film.settings.size.width_px, film.settings.size.height_px, preset,
              crf, rounds);
  if (static_cast<std::int64_t>(film.images.size()) == film.frames) return;
  std::printf("  the encoder alone gets only %zu different frames, forth and back: there is no memory for more\n",
              film.images.size());
}

void compare(const Clip& clip, const TemporaryFolder& folder) {
  const Film film = draw(clip);
  print_film(clip, film);
  std::vector<Cost> whole;
  std::vector<Cost> encoder;
  for (int i = 0; i < rounds; ++i) {
    whole.push_back(cost_of_program(command_for(clip, folder / "whole.mp4")));
    encoder.push_back(encode(film, folder / "encoded.mp4"));
  }
  const Cost ours = median(whole);
  const Cost theirs = median(encoder);
  print_side("proofreel render, from start to finished MP4", ours, film.frames);
  print_side("encoder alone, from RGBA in memory", theirs, film.frames);
  std::printf("  ratio: %.2f wall (target %.2f), %.2f CPU\n", ours.wall_s / theirs.wall_s, clip.target_ratio,
              ours.cpu_s / theirs.cpu_s);
}

}  // namespace

void bench_clip() {
  const TemporaryFolder folder;
  compare(crowd, folder);
  print_memory(folder);
  compare(lecture, folder);
}

}  // namespace proofreel
