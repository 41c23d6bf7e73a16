#include "golden/pictures.h"

#include <algorithm>
#include <cmath>

#include "golden/likeness.h"
#include "golden/words.h"
#include "render/draw.h"
#include "render/mapped_file.h"
#include "render/pixel_hash.h"
#include "render/png.h"
#include "scenarios/formatted.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

std::string text_of(Size size) { return std::to_string(size.width_px) + "x" + std::to_string(size.height_px); }

std::string figures(const Comparison& c) {
  std::string text = count_text(c.different);
  text.append(" of ").append(count_text(c.total)).append(" pixels differ, by up to ");
  text.append(std::to_string(c.max_channel)).append(" of 255 (at ").append(std::to_string(c.worst_x_px));
  return text.append(",").append(std::to_string(c.worst_y_px)).append(")");
}

std::string short_number(double value) { return formatted("%.2g", value); }

std::string headroom(const Comparison& c, const Tolerance& tolerance) {
  return std::string("; tolerated are ")
      .append(std::to_string(tolerance.max_channel))
      .append(" per channel and ")
      .append(count_text(tolerance.pixels))
      .append(" pixels beyond, of which ")
      .append(count_text(c.beyond))
      .append(" are used");
}

double largest_bias(const DifferenceCounts& counts) {
  double largest = 0;
  for (const double bias : counts.quiet_bias) largest = std::max(largest, std::abs(bias));
  return largest;
}

std::string headroom(const DifferenceCounts& counts, const DifferenceLimits& limits) {
  std::string text = words({"; of what is tolerated, ", count_text(counts.different), " of "});
  text.append(count_text(limits.different)).append(" visibly different pixels are used");
  if (limits.window) {
    text.append(", ").append(count_text(counts.densest.different)).append(" of ");
    text.append(count_text(*limits.window)).append(" in one window");
  }
  text.append(", ").append(short_number(largest_bias(counts))).append(" of ").append(short_number(limits.bias));
  return text.append(" of bias");
}

/// Two pictures of a size that differ, held against what is tolerated.
struct Tolerating {
  bool passes = false;
  std::string said;  ///< to be appended to the figures
};

Tolerating hold_against(const Tolerance& tolerance, const Comparison& c, const Image& then, const Image& now) {
  DifferenceSettings settings;
  if (tolerance.seen) settings.threshold = tolerance.seen->threshold;
  const DifferenceCounts counts = difference_between(then, now, settings).counts;
  if (tolerance.seen) {
    const std::string broken = broken_limit(counts, tolerance.seen->limits);
    if (!broken.empty()) return {false, words({"; beyond what is tolerated: ", broken})};
    return {true, headroom(counts, tolerance.seen->limits)};
  }
  std::string visibly = words({", ", counts.different == 0 ? "none" : count_text(counts.different), " visibly"});
  return {c.beyond <= tolerance.pixels, tolerance.is_none() ? visibly : visibly.append(headroom(c, tolerance))};
}

/// Frames that have changed places.
std::string whose_picture(const Golden& golden, const ObservedFrame& now) {
  for (const GoldenFrame& frame : golden.frames) {
    if (frame.pixel_hash == now.pixel_hash)
      return words({". It is the picture of golden frame ", std::to_string(frame.frame)});
  }
  return "";
}

Finding judge_pixels(const Golden& golden, const ObservedFrame& now, const Image& then, const std::string& drawn_by) {
  const Comparison c = compare(then, now.image, golden.tolerance.max_channel);
  if (!c.same_size)
    return {now.frame, Verdict::missing, "the reference picture is not of the size golden.json says.", c};
  if (c.different == 0)
    return {now.frame, Verdict::tolerated, "the pixels are equal, though their recorded hash is not.", c};
  const Tolerating tolerating = hold_against(golden.tolerance, c, then, now.image);
  std::string message = figures(c) + tolerating.said;
  if (tolerating.passes) return {now.frame, Verdict::tolerated, message.append("."), c};
  if (golden.version != drawn_by) {
    message.append("; the reference was drawn by \"").append(golden.version).append("\", this by \"");
    message.append(drawn_by).append("\"");
  }
  message.append(whose_picture(golden, now));
  return {now.frame, Verdict::drawing, message.append("."), c};
}

Style style_of(const Scenario& scenario) { return {scenario.picture.theme}; }

}  // namespace

Canvas& Pictures::canvas_of(Size size) {
  if (!context_) {
    context_ = make_context(backend_);
    info_ = info_of(*context_);
  }
  return canvases_.try_emplace({size.width_px, size.height_px}, *context_, size.width_px, size.height_px).first->second;
}

DrawnPicture Pictures::draw(const Scenario& scenario, const Frame& frame) {
  DrawnPicture picture;
  draw_frame(canvas_of(scenario.golden->size), frame, style_of(scenario), picture.image);
  picture.hash = pixel_hash(picture.image);
  return picture;
}

OwnerPicture Pictures::draw_owners(const Scenario& scenario, const Frame& frame) {
  return proofreel::draw_owners(canvas_of(scenario.golden->size), frame, style_of(scenario));
}

PictureWhy Pictures::explain(const GoldenStore& store, const Golden& golden, const GoldenFrame& then,
                             const Scenario& scenario, const Frame& frame, const ObservedFrame& now) {
  const Image expected = read_png((store.folder(golden.scenario) / then.file).string());
  const std::optional<OwnerPicture> owners_then = load_owners(store, golden, then);
  const OwnerPicture owners_now = draw_owners(scenario, frame);
  const StateChange change = change_between(then, now);
  const bool same_state = then.trajectory_hash == now.trajectory_hash;
  BodyNames names;
  names.add(now.bodies);
  names.add(then.bodies);
  const TwoPictures pictures{expected,   now.image, owners_then ? &*owners_then : nullptr,
                             owners_now, change,    same_state};
  return {causes_of(pictures, names), same_state ? likeness(expected, now.image) : std::string()};
}

PictureTools Pictures::tools(const GoldenStore& store) {
  return {[this](const Scenario& scenario, const Frame& frame) { return draw(scenario, frame); },
          [this, store](const Golden& golden, const GoldenFrame& then, const ObservedFrame& now) {
            return judge(store, golden, then, now);
          },
          [this, store](const Golden& golden, const GoldenFrame& then, const Scenario& scenario, const Frame& frame,
                        const ObservedFrame& now) { return explain(store, golden, then, scenario, frame, now); }};
}

Finding Pictures::judge(const GoldenStore& store, const Golden& golden, const GoldenFrame& then,
                        const ObservedFrame& now) const {
  const Size size{now.image.width_px, now.image.height_px};
  if (size != golden.size) {
    return {
        now.frame, Verdict::size, "the picture is " + text_of(size) + ", golden is " + text_of(golden.size) + ".", {}};
  }
  if (const std::optional<std::string> problem = problem_with_file(store, golden, then)) {
    return {now.frame, Verdict::missing, *problem, {}};
  }
  if (now.pixel_hash == then.pixel_hash) return {now.frame, Verdict::exact, "", {}};
  return judge_pixels(golden, now, read_png((store.folder(golden.scenario) / then.file).string()), info_.version);
}

std::optional<std::string> problem_with_file(const GoldenStore& store, const Golden& golden, const GoldenFrame& frame) {
  const fs::path path = store.folder(golden.scenario) / frame.file;
  const MappedFile file(path.string());
  if (!file.problem().empty()) return "the reference picture " + path.string() + " is missing.";
  if (bytes_hash(file.bytes()) == frame.file_hash) return std::nullopt;
  return "the reference picture " + path.string() + " is damaged: it is not the file that was blessed.";
}

std::optional<OwnerPicture> load_owners(const GoldenStore& store, const Golden& golden, const GoldenFrame& frame) {
  if (frame.owners.empty()) return std::nullopt;
  try {
    const Image image = read_png((store.folder(golden.scenario) / owners_file_of(frame)).string());
    if (Size{image.width_px, image.height_px} != golden.size) return std::nullopt;
    return owner_picture_from(image, frame.owners);
  } catch (const ImageError&) {
    return std::nullopt;  // only the explanation suffers
  }
}

}  // namespace proofreel
