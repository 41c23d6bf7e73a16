#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include "cli/commands.h"
#include "cli/diff_output.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "golden/frame_source.h"
#include "render/output_file.h"
#include "render/png.h"
#include "render/sink.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

struct Options {
  CommonOptions common;
  std::string expected;
  std::string actual;
  std::string out;
  std::string style = "side";
  DifferenceSettings settings;
  DifferenceLimits limits;
  std::vector<std::string> ignored;
  std::string mask;
  bool json = false;
};

/// "10,20,300,40" -> a rectangle.
PixelRect parse_rect(const std::string& text) {
  PixelRect rect;
  int used = 0;
  const int count =
      std::sscanf(text.c_str(), "%9d,%9d,%9d,%9d%n", &rect.x_px, &rect.y_px, &rect.width_px, &rect.height_px, &used);
  if (count == 4 && static_cast<std::size_t>(used) == text.size() && rect.width_px > 0 && rect.height_px > 0)
    return rect;
  throw UsageError("--ignore takes X,Y,WIDTH,HEIGHT in pixels from the top left corner, such as 10,20,300,40, not \"" +
                   text + "\".");
}

DifferenceSettings settings_of(const Options& options) {
  DifferenceSettings settings = options.settings;
  if (std::isnan(settings.threshold) || std::isnan(options.limits.bias)) {
    throw UsageError("--threshold and --max-bias take numbers.");
  }
  for (const std::string& text : options.ignored) settings.region.ignore(parse_rect(text));
  if (!options.mask.empty()) settings.region.keep_only(read_png(options.mask));
  const auto cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  settings.threads = options.common.threads > 0 ? options.common.threads : cores;
  return settings;
}

/// What is to be done, checked and ready.
struct Task {
  const Options& options;
  DifferenceSettings settings;
  DiffStyle style;
};

std::string name_of(const std::string& path) { return fs::path(path).filename().string(); }

void write_picture(const Task& task, const std::string& out, ImagePair images, const Difference& difference) {
  const DiffTitles titles{"expected  " + name_of(task.options.expected), "actual  " + name_of(task.options.actual),
                          std::to_string(difference.counts.different) + " pixels differ"};
  const Image picture =
      diff_picture(task.style, {images.expected, images.actual, difference}, task.settings.region, titles);
  images = {};  // writing takes memory of its own
  write_png(out, picture);
}

PictureVerdict diff_pictures(const Task& task, const std::string& expected, const std::string& actual,
                             const std::string& out) {
  ImagePair images = read_pair(expected, actual);
  const Difference difference = difference_between(images.expected, images.actual, task.settings);
  const PictureVerdict verdict{difference.counts,
                               broken_limit(difference.counts, task.options.limits),
                               {images.expected.width_px, images.expected.height_px},
                               {images.actual.width_px, images.actual.height_px}};
  if (!out.empty()) write_picture(task, out, std::move(images), difference);
  return verdict;
}

ClipDifference diff_clips(const Task& task, const std::string& expected, const std::string& actual,
                          const std::string& out) {
  ProgressLine line("frames", task.options.common.quiet);
  const auto progress = [&line](std::int64_t done, std::int64_t total) {
    stop_if_interrupted();
    line.update(done, total);
  };
  const ClipDifference found = compare_clips(expected, actual, task.settings, task.options.limits, progress);
  if (!out.empty()) write_diff_clip(expected, actual, task.settings, found, task.style, out, progress);
  return found;
}

/// Where the picture or film of a file that both folders have goes; empty when none is wanted.
std::string out_for(const Options& options, const std::string& name) {
  if (options.out.empty()) return {};
  fs::path path = fs::path(options.out) / name;
  if (is_film_name(name)) path.replace_extension(".mp4");
  make_folder(path.parent_path().string());
  return path.string();
}

FolderEntry entry_of(const std::string& name, const PictureVerdict& found) {
  return {name, found.broken.empty(), text_of(found), json_of(found), found.counts};
}

FolderEntry entry_of(const std::string& name, const ClipDifference& found) {
  return {name, !found.first_different(), text_of(found), json_of(found), sum_of(found.frames)};
}

/// Compares first and draws only what has changed.
FolderEntry diff_entry(const Task& task, const std::string& name) {
  const std::string expected = (fs::path(task.options.expected) / name).string();
  const std::string actual = (fs::path(task.options.actual) / name).string();
  const auto compared = [&](const auto& compare) {
    FolderEntry entry = entry_of(name, compare(task, expected, actual, ""));
    if (!entry.passed && !task.options.out.empty()) compare(task, expected, actual, out_for(task.options, name));
    return entry;
  };
  return is_film_name(name) ? compared(diff_clips) : compared(diff_pictures);
}

FolderVerdict diff_folders(const Task& task) {
  FolderVerdict found;
  found.match = match_folders(task.options.expected, task.options.actual);
  ProgressLine line("files", task.options.common.quiet);
  for (const std::string& name : found.match.both) {
    stop_if_interrupted();
    try {
      found.entries.push_back(diff_entry(task, name));
    } catch (const ImageError& error) {
      found.errors.push_back(error.what());
    }
    line.update(static_cast<std::int64_t>(found.entries.size() + found.errors.size()),
                static_cast<std::int64_t>(found.match.both.size()));
  }
  return found;
}

template <typename Found>
int report(const Options& options, const Found& found, int status) {
  if (options.json) {
    std::cout << json_text(json_of(found), 2) << "\n";
  } else if (status != 0 || !options.common.quiet) {
    std::cout << text_of(found);
  }
  return status;
}

/// What the two names are; only like is compared with like, but for films and folders of frames.
enum class Kind : std::uint8_t { pictures, clips, folders };

Kind kind_of(const Options& options) {
  std::error_code ignored;  // reading it will say what is wrong
  const bool folders[] = {fs::is_directory(options.expected, ignored), fs::is_directory(options.actual, ignored)};
  const bool films[] = {is_film_name(options.expected), is_film_name(options.actual)};
  if (folders[0] && folders[1]) return Kind::folders;
  if ((folders[0] || films[0]) && (folders[1] || films[1])) return Kind::clips;
  if (!folders[0] && !folders[1] && !films[0] && !films[1]) return Kind::pictures;
  throw UsageError("diff takes two PNG pictures, two folders, or two clips (one of which may be a folder of frames): " +
                   options.expected + " and " + options.actual + " are not of one kind.");
}

void check_out(const Options& options, Kind kind) {
  if (options.out.empty() || kind != Kind::pictures || is_single_picture(options.out)) return;
  throw UsageError("The picture of a difference is a .png file, not " + options.out + ".");
}

int diff(const Options& options) {
  note_interrupts();
  const std::optional<DiffStyle> style = diff_style_named(options.style);
  if (!style) throw UsageError("There is no style \"" + options.style + "\"; there are side, overlay, heat and mask.");
  const Kind kind = kind_of(options);
  check_out(options, kind);
  const Task task{options, settings_of(options), *style};
  if (kind == Kind::folders) {
    const FolderVerdict found = diff_folders(task);
    say_all(found.errors);
    return report(options, found, found.status());
  }
  if (kind == Kind::clips) {
    const ClipDifference found = diff_clips(task, options.expected, options.actual, options.out);
    return report(options, found, found.first_different() ? 1 : 0);
  }
  const PictureVerdict found = diff_pictures(task, options.expected, options.actual, options.out);
  return report(options, found, found.broken.empty() ? 0 : 1);
}

std::string problem_with_count(const std::string& text) {
  const bool counts = text.find_first_not_of("0123456789") == std::string::npos;
  return counts ? std::string() : "it is a whole number from 0 on, so not " + text;
}

void add_metric_options(CLI::App& app, Options& options) {
  app.add_option("--threshold", options.settings.threshold, "How far apart colours may be, 0 (equal) to 1 (anything)")
      ->capture_default_str()
      ->type_name("T")
      ->check(CLI::Range(0.0, 1.0));
  app.add_flag("--include-aa", options.settings.count_antialiased, "Count anti-aliased pixels as different, too");
  app.add_option("--shift", options.settings.shift_px, "Forgive colours found within this many pixels, both ways")
      ->type_name("N")
      ->check(CLI::Range(0, 8));
  app.add_option("--ignore", options.ignored, "Leave a rectangle out; repeatable")
      ->type_name("X,Y,W,H")
      ->allow_extra_args(false);
  app.add_option("--mask", options.mask, "Compare only where this picture is neither black nor transparent")
      ->type_name("PNG");
}

void add_limit_options(CLI::App& app, Options& options) {
  app.add_option("--max-different", options.limits.different, "So many pixels may differ")
      ->capture_default_str()
      ->type_name("N")
      ->check(problem_with_count, "0 or more");
  app.add_option("--max-window", options.limits.window, "So many of them may lie in one window")
      ->type_name("N")
      ->check(problem_with_count, "0 or more");
  app.add_option("--window", options.settings.window_px, "The side of that window, pixels")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  app.add_option("--max-bias", options.limits.bias, "So much, of 255, may a channel be off on average")
      ->capture_default_str()
      ->type_name("X")
      ->check(CLI::Range(0.0, 255.0));
}

}  // namespace

Subcommand diff_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "diff", "Compare two pictures, two clips or two folders",
                              "proofreel diff expected.png actual.png -o difference.png", options->common);
  app->add_option("A", options->expected, "What is expected: a PNG, a film, or a folder")->required();
  app->add_option("B", options->actual, "What there is: the same kind")->required();
  app->add_option("-o,--output", options->out, "Draw the difference: a .png, a film for clips, a folder for folders")
      ->type_name("OUT");
  app->add_option("--style", options->style, "side (expected, actual, heat), overlay, heat or mask")
      ->capture_default_str()
      ->type_name("NAME");
  add_metric_options(*app, *options);
  add_limit_options(*app, *options);
  app->add_flag("--json", options->json, "Print one JSON object instead of text");
  return {app, [options] { return diff(*options); }};
}

}  // namespace proofreel
