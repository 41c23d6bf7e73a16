#include "cli/render.h"

#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/render_options.h"
#include "cli/scenario_files.h"
#include "render/video.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

/// Of each picture of a contact sheet, unless told: as golden pictures, in which letters can still be read.
constexpr int sheet_picture_width = 480;

bool is_gif(const std::string& out) { return ending_of(out) == ".gif"; }
bool is_svg(const std::string& out) { return ending_of(out) == ".svg"; }

/// The scenario's own, or the largest that GIFs can show and that divides the rate.
int gif_fps(const Scenario& scenario) {
  int fps = std::min(scenario.picture.fps, most_gif_fps);
  if (fps == scenario.picture.fps) return fps;
  while (scenario.scene.rate % fps != 0) --fps;
  return fps;
}

Size sheet_size(Size whole) {
  const std::int64_t height =
      (std::int64_t{sheet_picture_width} * whole.height_px + whole.width_px / 2) / whole.width_px;
  return {sheet_picture_width, static_cast<int>(std::max<std::int64_t>(1, height))};
}

/// In every pane, where there are several.
void apply_layers(const std::string& layers, Scenario& scenario) {
  apply_layers(layers, scenario.picture);
  for (const auto& pane : scenario.other_panes) apply_layers(layers, *pane);
}

void apply(const RenderOptions& options, Scenario& scenario) {
  Picture& picture = scenario.picture;
  if (!options.size.empty()) {
    picture.size = parse_size(options.size);
  } else if (!options.contact_sheet.empty()) {
    picture.size = sheet_size(picture.size);
  }
  if (!options.theme.empty()) picture.theme = parse_theme(options.theme);
  if (!options.layers.empty()) apply_layers(options.layers, scenario);
  if (options.fps) picture.fps = *options.fps;
}

FrameRange range_of(const RenderOptions& options, std::int64_t film_length) {
  FrameRange range{0, film_length - 1};
  if (!options.frames.empty()) range = parse_frames(options.frames, film_length);
  if ((is_single_picture(options.out) || is_svg(options.out)) && options.contact_sheet.empty())
    range.first = range.last;
  return range;
}

int render(const RenderOptions& options) {
  const std::unique_ptr<Scenario> scenario = load_scenario(scenario_file(options.scenario), options.common.overrides());
  if (!options.common.quiet) say_all(scenario->warnings);
  apply(options, *scenario);
  if (is_gif(options.out) && !options.fps) scenario->picture.fps = gif_fps(*scenario);
  RenderJob job{options, *scenario, {}, {}, {}};
  job.request.timeline = film_timeline(*scenario);
  job.request.gl = gl_backend_named(options.common.gl);
  job.request.transparent = options.transparent;
  job.request.threads = options.common.threads;
  job.range = range_of(options, static_cast<std::int64_t>(job.request.timeline.size()));
  job.request.frames = job.range.frames();
  job.sections = film_sections(*scenario, job.request.timeline);
  refuse_numbers(options.out);
  note_interrupts();
  if (!options.contact_sheet.empty()) {
    render_contact_sheet(job);
  } else if (ending_of(options.out) == ".srt") {
    render_subtitles(job);
  } else if (is_svg(options.out)) {
    render_svg(job);
  } else {
    render_pictures(job);
  }
  return 0;
}

void add_picture_options(CLI::App& app, RenderOptions& options) {
  app.add_option("--size", options.size, "Pixels, such as 1920x1080")->type_name("WxH");
  app.add_option("--fps", options.fps, "Frames per second; must divide the scenario's rate")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  CLI::Option* frames =
      app.add_option("--frames", options.frames, "Only these film frames, both included: 0:59, or one: 30")
          ->type_name("A:B");
  CLI::Option* stills =
      app.add_flag("--stills", options.stills, "The last frame of every section, to NAME%02d.png")->excludes(frames);
  app.add_flag("--contact-sheet{auto}", options.contact_sheet,
               "Pictures of the whole film on one sheet, to NAME.png: its sections, or --contact-sheet=4x3")
      ->excludes(stills);
  app.add_option("--layers", options.layers, "bodies,contacts for exactly these; +bvh,-labels for changes")
      ->type_name("LIST");
  app.add_flag("--transparent", options.transparent, "Nothing behind what is drawn: all but .mp4");
  app.add_option("--theme", options.theme, "light, dark or print")->type_name("NAME");
}

void add_film_options(CLI::App& app, RenderOptions& options) {
  app.add_flag("--title-card{3}", options.title_card,
               "Open with title and description, for 3 s or as many as told: --title-card=2");
  app.add_option("--shutter", options.shutter,
                 "Motion blur: open for so much of the way to the next frame, 180 for half")
      ->type_name("DEGREES");
  app.add_option("--quality", options.quality, "draft, final or lossless")->capture_default_str()->type_name("NAME");
  app.add_option("--preset", options.preset, "x264's preset, such as veryfast")->type_name("NAME");
  app.add_option("--crf", options.crf, "Constant rate factor, 0 (best) to 51 (.webm: 63)")->type_name("N");
}

}  // namespace

Subcommand render_command(CLI::App& program) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* app =
      add_command(program, "render", "Film a scenario, or take a picture of it",
                  "proofreel render pyramid -o pyramid.mp4 --size 1920x1080 --layers +contacts", options->common);
  app->add_option("SCENARIO", options->scenario, "Path of a .lua file, or an id such as pyramid")->required();
  app->add_option(
         "-o,--output", options->out,
         "NAME.png or NAME.svg (one picture), NAME%04d.png (one per frame), .mp4, .webm, .gif, .apng, .mov, .mkv, .srt "
         "(subtitles), .hash, or - for raw RGBA")
      ->required()
      ->type_name("OUT");
  add_picture_options(*app, *options);
  add_film_options(*app, *options);
  return {app, [options] { return render(*options); }};
}

}  // namespace proofreel
