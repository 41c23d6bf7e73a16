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
#include "render/draw_layers.h"
#include "render/exposure.h"
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
        fps_(scenario.picture.fps),
        style_{scenario.picture.theme, request.transparent} {
    for (const Caption& caption : scenario.picture.captions)
      captions_.push_back({caption.text, caption.at, caption.place});
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
  /// A moment the shutter sees; a picture is of one or more.
  struct Moment {
    Frame frame;
    bool closes = true;  ///< the last of its picture
  };

  void film(const Progress& progress) {
    const auto total = static_cast<std::int64_t>(request_.frames.size());
    Runner runner(scenario_);
    std::int64_t done = 0;
    for (const std::int64_t i : request_.frames) {
      while (runner.tick() < request_.timeline[static_cast<std::size_t>(i)]) runner.step();
      if (!expose(runner, i)) return;
      if (progress) progress(++done, total);
    }
    moments_.close();
  }

  /// All moments of frame `i`; false when nobody takes them any more.
  bool expose(Runner& runner, std::int64_t i) {
    const std::int64_t open = request_.exposures.empty() ? 1 : request_.exposures[static_cast<std::size_t>(i)];
    for (std::int64_t n = 0;; runner.step()) {
      const bool closes = ++n == open || runner.finished();
      if (!moments_.push({runner.frame(i), closes})) return false;
      if (closes) return true;
    }
  }

  void draw() {
    const std::unique_ptr<GlContext> context = make_context(request_.gl);
    Canvas canvas(*context, size_.width_px, size_.height_px);
    require_room(canvas, captions_);
    bool begun = !request_.title_card;
    while (std::optional<Image> image = spare_.pop()) {
      if (!take_picture(canvas, *image)) break;
      if (!begun && !open_with_card(canvas, *image)) return;
      begun = true;
      if (!pictures_.push(std::move(*image))) return;
    }
    pictures_.close();
  }

  /// False when there are no more.
  bool take_picture(Canvas& canvas, Image& image) {
    std::optional<Moment> moment = moments_.pop();
    if (!moment) return false;
    if (moment->closes) {
      draw_frame(canvas, moment->frame, style_, image);
      return true;
    }
    const Frame written = moment->frame;  // the first: later ones would say what the frame's tick does not know
    Image world;
    for (; moment; moment = moments_.pop()) {
      draw_world(canvas, moment->frame, style_, world);
      exposure_.add(world);
      if (moment->closes) break;
    }
    if (!moment) return false;
    exposure_.develop(world);
    draw_written(canvas, written, style_, world, image);
    return true;
  }

  /// The card, and how it gives way to the first picture; false when nobody takes them any more.
  bool open_with_card(Canvas& canvas, const Image& first) {
    Image card;
    draw_title_card(canvas, *request_.title_card, style_.theme, card);
    for (std::int64_t i = 0; i < request_.card_pictures; ++i) {
      std::optional<Image> image = spare_.pop();
      if (!image) return false;
      mix_into(card, first, style_.theme, i, request_.card_pictures, fps_, *image);
      if (!pictures_.push(std::move(*image))) return false;
    }
    return true;
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
      moments_.abandon();
      pictures_.abandon();
      spare_.abandon();
    }
  }

  Scenario& scenario_;
  const FilmRequest& request_;
  Sink& sink_;
  const Size size_;
  const int fps_;
  const Style style_;
  std::vector<CaptionView> captions_;  ///< that are known before the film begins
  Exposure exposure_;
  BoundedQueue<Moment> moments_{waiting_frames};
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
