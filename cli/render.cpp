#include <algorithm>
#include <memory>
#include <thread>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/render_options.h"
#include "cli/scenario_files.h"
#include "render/output_file.h"
#include "render/video.h"
#include "scenarios/runner.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

struct Options {
  CommonOptions common;
  std::string scenario;
  std::string out;
  std::string size;
  std::string frames;
  std::optional<std::string> layers;
  std::string theme;
  std::string quality = "final";
  std::optional<std::string> preset;
  std::optional<int> crf;
  std::optional<int> fps;
  bool transparent = false;
  bool stills = false;
};

bool is_gif(const std::string& out) { return ending_of(out) == ".gif"; }
bool is_svg(const std::string& out) { return ending_of(out) == ".svg"; }

/// The scenario's own, or the largest that GIFs can show and that divides the rate.
int gif_fps(const Scenario& scenario) {
  int fps = std::min(scenario.picture.fps, most_gif_fps);
  if (fps == scenario.picture.fps) return fps;
  while (scenario.scene.rate % fps != 0) --fps;
  return fps;
}

/// In every pane, where there are several.
void apply_layers(const std::string& layers, Scenario& scenario) {
  apply_layers(layers, scenario.picture);
  for (const auto& pane : scenario.other_panes) apply_layers(layers, *pane);
}

void apply(const Options& options, Scenario& scenario) {
  Picture& picture = scenario.picture;
  if (!options.size.empty()) picture.size = parse_size(options.size);
  if (!options.theme.empty()) picture.theme = parse_theme(options.theme);
  if (options.layers) apply_layers(*options.layers, scenario);
  if (options.fps) picture.fps = *options.fps;
}

FrameRange range_of(const Options& options, std::int64_t film_length) {
  FrameRange range{0, film_length - 1};
  if (!options.frames.empty()) range = parse_frames(options.frames, film_length);
  if (is_single_picture(options.out) || is_svg(options.out)) range.first = range.last;
  return range;
}

Quality quality_of(const Options& options) {
  if (const std::optional<Quality> quality = quality_named(options.quality)) return *quality;
  throw UsageError("There is no quality \"" + options.quality + "\"; there are draft, final and lossless.");
}

/// What of the sections lies within the frames that are filmed, counted from the first of them.
std::vector<Chapter> chapters_of(const std::vector<FilmSection>& sections, FrameRange range) {
  std::vector<Chapter> chapters;
  for (const FilmSection& section : sections) {
    const std::int64_t first = std::max(section.first, range.first), last = std::min(section.last, range.last);
    if (first <= last) chapters.push_back({section.name, first - range.first, last - range.first});
  }
  return chapters;
}

/// The last frame of every section: what it has led to.
std::vector<std::int64_t> stills_of(const Options& options, const std::string& path,
                                    const std::vector<FilmSection>& sections) {
  if (options.out.find('%') == std::string::npos)
    throw UsageError("--stills makes a picture per section: name them -o NAME%02d.png.");
  if (sections.empty()) throw UsageError("--stills: " + path + " has no section{at=, name=}.");
  std::vector<std::int64_t> frames;
  for (const FilmSection& section : sections) frames.push_back(section.last);
  return frames;
}

int write_svg(const Options& options, Scenario& scenario, const FilmRequest& request) {
  if (options.preset || options.crf) throw UsageError("--preset and --crf are for films, which an SVG is not.");
  if (options.stills) throw UsageError("--stills makes several pictures, and an SVG is one: use --frames.");
  write_file(options.out, svg_of(scenario, request));
  return 0;
}

int render(const Options& options) {
  const std::unique_ptr<Scenario> scenario = load_scenario(scenario_file(options.scenario), options.common.overrides());
  if (!options.common.quiet) say_all(scenario->warnings);
  Picture& picture = scenario->picture;
  apply(options, *scenario);
  if (is_gif(options.out) && !options.fps) picture.fps = gif_fps(*scenario);
  FilmRequest request{
      film_timeline(*scenario), {}, gl_backend_named(options.common.gl), options.transparent, options.common.threads};
  const FrameRange range = range_of(options, static_cast<std::int64_t>(request.timeline.size()));
  const std::vector<FilmSection> sections = film_sections(*scenario, request.timeline);
  request.frames = options.stills ? stills_of(options, scenario->path, sections) : range.frames();
  if (is_svg(options.out)) return write_svg(options, *scenario, request);
  note_interrupts();
  const std::unique_ptr<Sink> sink = make_sink(options.out, {.size = picture.size,
                                                             .fps = picture.fps,
                                                             .quality = quality_of(options),
                                                             .preset = options.preset,
                                                             .crf = options.crf,
                                                             .threads = options.common.threads,
                                                             .transparent = options.transparent,
                                                             .chapters = chapters_of(sections, range),
                                                             .first_frame = options.stills ? 1 : range.first});
  ProgressLine line("frames", options.common.quiet);
  const auto progress = [&line](std::int64_t done, std::int64_t total) {
    stop_if_interrupted();
    line.update(done, total);
  };
  render_film(*scenario, request, *sink, progress);
  return 0;
}

void add_picture_options(CLI::App& app, Options& options) {
  app.add_option("--size", options.size, "Pixels, such as 1920x1080")->type_name("WxH");
  app.add_option("--fps", options.fps, "Frames per second; must divide the scenario's rate")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  CLI::Option* frames =
      app.add_option("--frames", options.frames, "Only these film frames, both included: 0:59, or one: 30")
          ->type_name("A:B");
  app.add_flag("--stills", options.stills, "The last frame of every section, to NAME%02d.png")->excludes(frames);
  app.add_option("--layers", options.layers, "bodies,contacts for exactly these; +bvh,-labels for changes")
      ->type_name("LIST");
  app.add_flag("--transparent", options.transparent, "Nothing behind what is drawn: all but .mp4");
  app.add_option("--theme", options.theme, "light, dark or print")->type_name("NAME");
}

void add_film_options(CLI::App& app, Options& options) {
  app.add_option("--quality", options.quality, "draft, final or lossless")->capture_default_str()->type_name("NAME");
  app.add_option("--preset", options.preset, "x264's preset, such as veryfast")->type_name("NAME");
  app.add_option("--crf", options.crf, "Constant rate factor, 0 (best) to 51 (.webm: 63)")->type_name("N");
}

}  // namespace

Subcommand render_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app =
      add_command(program, "render", "Film a scenario, or take a picture of it",
                  "proofreel render pyramid -o pyramid.mp4 --size 1920x1080 --layers +contacts", options->common);
  app->add_option("SCENARIO", options->scenario, "Path of a .lua file, or an id such as pyramid")->required();
  app->add_option("-o,--output", options->out,
                  "NAME.png or NAME.svg (one picture), NAME%04d.png (one per frame), .mp4, .webm, .gif, .apng, .mov, "
                  ".mkv, .hash, or - "
                  "for raw RGBA")
      ->required()
      ->type_name("OUT");
  add_picture_options(*app, *options);
  add_film_options(*app, *options);
  return {app, [options] { return render(*options); }};
}

}  // namespace proofreel
