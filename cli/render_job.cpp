#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/render.h"
#include "cli/render_options.h"
#include "render/exposure.h"
#include "render/output_file.h"
#include "render/subtitles.h"

namespace proofreel {
namespace {

Quality quality_of(const RenderOptions& options) {
  if (const std::optional<Quality> quality = quality_named(options.quality)) return *quality;
  throw UsageError("There is no quality \"" + options.quality + "\"; there are draft, final and lossless.");
}

/// What of the sections lies within the frames that are filmed, counted from the first picture. A title card is a
/// chapter of its own, because players expect the first one at the film's beginning.
std::vector<Chapter> chapters_of(const RenderJob& job) {
  const std::int64_t card = job.request.card_pictures;
  std::vector<Chapter> chapters;
  for (const FilmSection& section : job.sections) {
    const std::int64_t first = std::max(section.first, job.range.first);
    const std::int64_t last = std::min(section.last, job.range.last);
    if (first <= last)
      chapters.push_back({section.name, card + first - job.range.first, card + last - job.range.first});
  }
  if (card > 0 && !chapters.empty()) chapters.insert(chapters.begin(), {job.scenario.title, 0, card - 1});
  return chapters;
}

/// The last frame of every section: what it has led to.
std::vector<std::int64_t> stills_of(const RenderJob& job) {
  if (job.options.out.find('%') == std::string::npos)
    throw UsageError("--stills makes a picture per section: name them -o NAME%02d.png.");
  if (job.sections.empty()) throw UsageError("--stills: " + job.scenario.path + " has no section{at=, name=}.");
  std::vector<std::int64_t> frames;
  for (const FilmSection& section : job.sections) frames.push_back(section.last);
  return frames;
}

void add_title_card(RenderJob& job) {
  const RenderOptions& options = job.options;
  if (options.title_card.empty()) return;
  const double seconds = parse_card_seconds(options.title_card);
  if (is_single_picture(options.out) || options.stills)
    throw UsageError("--title-card opens films; " + options.out + " gets single pictures.");
  if (options.transparent) throw UsageError("--title-card has a background, which --transparent leaves out.");
  job.request.title_card = TitleCard{job.scenario.title, job.scenario.description};
  job.request.card_pictures = std::max<std::int64_t>(1, std::llround(seconds * job.scenario.picture.fps));
}

void open_shutter(RenderJob& job) {
  if (!job.options.shutter) return;
  const double degrees = *job.options.shutter;
  if (!(degrees >= 1 && degrees <= 360))
    throw UsageError("--shutter goes from 1 to 360 degrees; 180 is half of the way to the next frame.");
  if (job.options.transparent)
    throw UsageError("--shutter mixes bodies with what is behind them, which --transparent leaves out.");
  if (!job.scenario.stories.empty())
    throw UsageError("--shutter blurs what moves, and " + job.scenario.path +
                     " demonstrates an algorithm step by step.");
  job.request.exposures = exposures(job.scenario, job.request.timeline, degrees);
}

FilmSettings settings_of(const RenderJob& job) {
  const RenderOptions& options = job.options;
  const bool counts_anew = options.stills || job.request.title_card.has_value();
  return {.size = job.scenario.picture.size,
          .fps = job.scenario.picture.fps,
          .quality = quality_of(options),
          .preset = options.preset,
          .crf = options.crf,
          .threads = options.common.threads,
          .transparent = options.transparent,
          .chapters = chapters_of(job),
          .first_frame = counts_anew ? 1 : job.range.first};
}

/// A line of progress that also looks for interrupts.
class Watched {
 public:
  explicit Watched(const RenderJob& job) : line_("frames", job.options.common.quiet) {}
  Progress progress() {
    return [this](std::int64_t done, std::int64_t total) {
      stop_if_interrupted();
      line_.update(done, total);
    };
  }

 private:
  ProgressLine line_;
};

void refuse_film_settings(const RenderOptions& options, const std::string& what) {
  quality_of(options);  // nothing asks for it here, but its name has to be one
  if (options.preset || options.crf) throw UsageError("--preset and --crf are for films, which " + what + " is not.");
}

/// Scene time, as the clock in pictures shows it.
std::string time_text(double seconds) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2f s", seconds);
  return text.data();
}

}  // namespace

void render_pictures(RenderJob& job) {
  if (job.options.stills) job.request.frames = stills_of(job);
  add_title_card(job);
  open_shutter(job);
  const std::unique_ptr<Sink> sink = make_sink(job.options.out, settings_of(job));
  Watched watched(job);
  render_film(job.scenario, job.request, *sink, watched.progress());
}

void render_contact_sheet(RenderJob& job) {
  const RenderOptions& options = job.options;
  if (!is_single_picture(options.out)) throw UsageError("--contact-sheet is one picture: name it -o NAME.png.");
  if (!options.title_card.empty()) throw UsageError("--contact-sheet has a title; --title-card opens films.");
  if (options.transparent) throw UsageError("--contact-sheet has a background, which --transparent leaves out.");
  refuse_film_settings(options, "a contact sheet");
  open_shutter(job);
  std::optional<SheetGrid> grid = parse_sheet_grid(options.contact_sheet);
  const std::vector<SheetPicture> pictures = sheet_pictures(job.range, job.sections, grid);
  SheetText text{job.scenario.title, {}, {}};
  job.request.frames.clear();
  for (const SheetPicture& picture : pictures) {
    const auto tick = static_cast<double>(job.request.timeline[static_cast<std::size_t>(picture.frame)]);
    job.request.frames.push_back(picture.frame);
    text.names.push_back(picture.name);
    text.times.push_back(time_text(tick / job.scenario.scene.rate));
  }
  const Picture& look = job.scenario.picture;
  const auto sheet = make_contact_sheet(options.out, *grid, look.size, look.theme, std::move(text));
  Watched watched(job);
  render_film(job.scenario, job.request, *sheet, watched.progress());
}

void render_svg(RenderJob& job) {
  const RenderOptions& options = job.options;
  refuse_film_settings(options, "an SVG");
  if (options.stills) throw UsageError("--stills makes several pictures, and an SVG is one: use --frames.");
  if (!options.title_card.empty()) throw UsageError("--title-card opens films, and an SVG is one picture.");
  if (options.shutter) throw UsageError("--shutter mixes pixels, of which an SVG has none.");
  write_file(options.out, svg_of(job.scenario, job.request));
}

void render_subtitles(RenderJob& job) {
  if (job.options.stills) throw UsageError("--stills makes pictures, -o NAME.srt subtitles of a film.");
  refuse_film_settings(job.options, job.options.out);
  add_title_card(job);
  open_shutter(job);
  const OutputFile removed_at_once(job.options.out);  // an unwritable folder is to be found before anything is stepped
  Watched watched(job);
  const std::vector<Cue> cues = subtitles_of(job.scenario, job.request, job.sections, watched.progress());
  if (cues.empty() && !job.options.common.quiet)
    say(job.scenario.path + " has no captions and no sections: the subtitles are empty.");
  write_file(job.options.out, srt_text(cues, job.scenario.picture.fps));
}

}  // namespace proofreel
