// A scenario's film for the gallery, and the moment of it that stands for all.

#include <algorithm>
#include <filesystem>

#include "golden/plain_path.h"
#include "lab/gallery.h"
#include "render/output_file.h"
#include "render/png.h"
#include "scenarios/source.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

constexpr Size box{960, 540};
constexpr int gallery_fps = 30;
constexpr double longest_clip_s = 12;  // of what tells no story: one sees by then what it is about

/// The scenario's proportions in the box, with even sides, as films need them.
Size fitted(Size size) {
  const double scale =
      std::min(static_cast<double>(box.width_px) / size.width_px, static_cast<double>(box.height_px) / size.height_px);
  const auto even = [scale](int side) { return std::max(2, 2 * static_cast<int>(scale * side / 2 + 0.5)); };
  return {even(size.width_px), even(size.height_px)};
}

bool tells_a_story(const Scenario& scenario) { return !scenario.stories.empty() || !scenario.picture.sections.empty(); }

/// The tick of the golden frame in the middle of all: somebody has chosen those.
std::int64_t telling_tick(const Scenario& scenario) {
  if (!scenario.golden || scenario.golden->frames.empty()) return scenario.ticks() / 2;
  const std::vector<std::int64_t> timeline = film_timeline(scenario);
  const std::vector<std::int64_t>& frames = scenario.golden->frames;
  const auto frame = static_cast<std::size_t>(frames[frames.size() / 2]);
  return timeline[std::min(frame, timeline.size() - 1)];
}

/// Hands all on, and keeps one picture as PNG.
class WithStill : public Sink {
 public:
  WithStill(std::unique_ptr<Sink> film, std::int64_t wanted, std::string path)
      : film_(std::move(film)), wanted_(wanted), path_(std::move(path)) {}
  void frame(const Image& image) override {
    if (next_++ == wanted_) still_ = encode_png(image);
    film_->frame(image);
  }
  void finish() override {
    film_->finish();
    write_file(path_, still_);
  }

 private:
  std::unique_ptr<Sink> film_;
  std::int64_t wanted_;
  std::string path_;
  std::int64_t next_ = 0;
  std::vector<std::uint8_t> still_;
};

/// Thirty frames a second, where they fit the rates.
int fitting_fps(const Scenario& scenario) {
  const auto fits = [](const Scenario& one) { return one.scene.rate % gallery_fps == 0; };
  const bool all = fits(scenario) && std::all_of(scenario.other_panes.begin(), scenario.other_panes.end(),
                                                 [&](const auto& pane) { return fits(*pane); });
  return all ? std::min(gallery_fps, scenario.picture.fps) : scenario.picture.fps;
}

}  // namespace

GalleryEntry film_for_gallery(const GalleryScenario& which, const std::vector<Override>& overrides,
                              const std::string& folder, std::optional<GlBackend> gl, const Progress& progress) {
  const std::unique_ptr<Scenario> scenario = load_scenario(which.file, overrides);
  const std::int64_t telling = telling_tick(*scenario);
  scenario->picture.fps = fitting_fps(*scenario);
  scenario->picture.size = fitted(scenario->picture.size);
  const double fps = scenario->picture.fps;
  FilmRequest request{film_timeline(*scenario), {}, gl, false, 1};
  const auto whole = static_cast<std::int64_t>(request.timeline.size());
  const std::int64_t clip =
      tells_a_story(*scenario) ? whole : std::min(whole, static_cast<std::int64_t>(longest_clip_s * fps));
  request.frames = FrameRange{0, clip - 1}.frames();
  const auto still = std::lower_bound(request.timeline.begin(), request.timeline.begin() + clip - 1, telling);
  const std::string name = plain_path(which.id);
  GalleryEntry entry{which.id,
                     scenario->title,
                     scenario->description,
                     static_cast<double>(whole) / fps,
                     static_cast<double>(clip) / fps,
                     "films/" + name + ".mp4",
                     "stills/" + name + ".png",
                     read_source(which.file),
                     engine_files_of(*scenario),
                     which.argument};
  for (const std::string& made : {entry.film, entry.still})
    make_folder((std::filesystem::path(folder) / made).parent_path().string());
  std::unique_ptr<Sink> film = make_sink(folder + "/" + entry.film, {.size = scenario->picture.size,
                                                                     .fps = scenario->picture.fps,
                                                                     .quality = Quality::draft,
                                                                     .preset = {},
                                                                     .crf = {},
                                                                     .threads = 1});
  WithStill sink(std::move(film), still - request.timeline.begin(), folder + "/" + entry.still);
  render_film(*scenario, request, sink, progress);
  return entry;
}

}  // namespace proofreel
