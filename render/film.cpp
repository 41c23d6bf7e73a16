#include "render/film.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <numeric>
#include <string>
#include <thread>

#include "render/bounded_queue.h"
#include "render/canvas.h"
#include "render/draw.h"
#include "scenarios/runner.h"

namespace proofreel {
namespace {

/// Frames and pictures waiting between two stages. More would only hold memory, because the slowest stage sets the
/// pace.
constexpr std::size_t waiting_frames = 2;
constexpr std::size_t waiting_pictures = 1;
/// One picture being drawn, one being encoded, and those waiting.
constexpr std::size_t picture_buffers = waiting_pictures + 2;

/// The encoder is the wall: llvmpipe gets half the cores, unless the user has decided, so that its workers do not take
/// turns with the encoder's threads. The pixels are the same for every number.
void limit_drawing_threads(int cores) {
  const int drawing = std::max(1, cores / 2);
  setenv("LP_NUM_THREADS", std::to_string(drawing).c_str(), 0);
}

class FilmPipeline {
 public:
  FilmPipeline(Scenario& scenario, const FilmRequest& request, Sink& sink)
      : scenario_(scenario),
        request_(request),
        sink_(sink),
        size_(scenario.picture.size),
        style_{scenario.picture.theme, request.transparent} {
    for (std::size_t i = 0; i < picture_buffers; ++i) spare_.push(Image{});
  }

  void run(const Progress& progress) {
    {
      const std::jthread drawer([this] { guarded([this] { draw(); }); });
      const std::jthread encoder([this] { guarded([this] { encode(); }); });
      guarded([&] { film(progress); });
    }
    if (error_) std::rethrow_exception(error_);
    sink_.finish();
  }

 private:
  void film(const Progress& progress) {
    const auto total = static_cast<std::int64_t>(request_.frames.size());
    Runner runner(scenario_);
    std::int64_t done = 0;
    for (const std::int64_t i : request_.frames) {
      while (runner.tick() < request_.timeline[static_cast<std::size_t>(i)]) runner.step();
      if (!frames_.push(runner.frame(i))) return;
      if (progress) progress(++done, total);
    }
    frames_.close();
  }

  void draw() {
    const std::unique_ptr<GlContext> context = make_context(request_.gl);
    Canvas canvas(*context, size_.width_px, size_.height_px);
    while (std::optional<Frame> frame = frames_.pop()) {
      std::optional<Image> image = spare_.pop();
      if (!image) return;
      draw_frame(canvas, *frame, style_, *image);
      if (!pictures_.push(std::move(*image))) return;
    }
    pictures_.close();
  }

  void encode() {
    while (std::optional<Image> image = pictures_.pop()) {
      sink_.frame(*image);
      spare_.push(std::move(*image));
    }
  }

  /// Runs one stage; its failure stops the others.
  template <typename Stage>
  void guarded(const Stage& stage) {
    try {
      stage();
    } catch (...) {
      const std::lock_guard lock(error_mutex_);
      if (!error_) error_ = std::current_exception();
      frames_.abandon();
      pictures_.abandon();
      spare_.abandon();
    }
  }

  Scenario& scenario_;
  const FilmRequest& request_;
  Sink& sink_;
  const Size size_;
  const Style style_;
  BoundedQueue<Frame> frames_{waiting_frames};
  BoundedQueue<Image> pictures_{waiting_pictures};
  BoundedQueue<Image> spare_{picture_buffers};
  std::mutex error_mutex_;
  std::exception_ptr error_;
};

}  // namespace

std::vector<std::int64_t> FrameRange::frames() const {
  std::vector<std::int64_t> list(static_cast<std::size_t>(last - first + 1));
  std::iota(list.begin(), list.end(), first);
  return list;
}

std::string svg_of(Scenario& scenario, const FilmRequest& request) {
  const std::int64_t index = request.frames.at(0);
  Runner runner(scenario);
  while (runner.tick() < request.timeline.at(static_cast<std::size_t>(index))) runner.step();
  return svg_of(runner.frame(index), {scenario.picture.theme, request.transparent}, scenario.picture.size);
}

void render_film(Scenario& scenario, const FilmRequest& request, Sink& sink, const Progress& progress) {
  const int machine_cores = static_cast<int>(std::thread::hardware_concurrency());
  limit_drawing_threads(request.threads > 0 ? request.threads : machine_cores);
  FilmPipeline(scenario, request, sink).run(progress);
}

}  // namespace proofreel
