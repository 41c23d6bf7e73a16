#include "golden/pictures.h"

#include "render/draw.h"
#include "render/mapped_file.h"
#include "render/pixel_hash.h"
#include "render/png.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

std::string text_of(Size size) { return std::to_string(size.width_px) + "x" + std::to_string(size.height_px); }

std::string figures(const Comparison& c) {
  std::string text = std::to_string(c.different);
  text.append(" of ").append(std::to_string(c.total)).append(" pixels differ, by up to ");
  text.append(std::to_string(c.max_channel)).append(" of 255 (at ").append(std::to_string(c.worst_x_px));
  return text.append(",").append(std::to_string(c.worst_y_px)).append(")");
}

std::string headroom(const Comparison& c, const Tolerance& tolerance) {
  return std::string("; tolerated are ")
      .append(std::to_string(tolerance.max_channel))
      .append(" per channel and ")
      .append(std::to_string(tolerance.pixels))
      .append(" pixels beyond, of which ")
      .append(std::to_string(c.beyond))
      .append(" are used");
}

Finding judge_pixels(const Golden& golden, const ObservedFrame& now, const Image& then, const std::string& drawn_by) {
  const Comparison c = compare(then, now.image, golden.tolerance.max_channel);
  if (!c.same_size)
    return {now.frame, Verdict::missing, "the reference picture is not of the size golden.json says.", c};
  if (c.different == 0)
    return {now.frame, Verdict::tolerated, "the pixels are equal, though their recorded hash is not.", c};
  std::string message = figures(c);
  if (golden.tolerance.max_channel > 0 || golden.tolerance.pixels > 0) message += headroom(c, golden.tolerance);
  if (c.beyond <= golden.tolerance.pixels) return {now.frame, Verdict::tolerated, message.append("."), c};
  if (golden.version != drawn_by) {
    message.append("; the reference was drawn by \"").append(golden.version).append("\", this by \"");
    message.append(drawn_by).append("\"");
  }
  return {now.frame, Verdict::drawing, message.append("."), c};
}

}  // namespace

Canvas& Pictures::canvas_of(Size size) {
  if (!context_) {
    context_ = make_context(backend_);
    info_ = info_of(*context_);
  }
  return canvases_.try_emplace({size.width_px, size.height_px}, *context_, size.width_px, size.height_px).first->second;
}

Image Pictures::draw(const Scenario& scenario, const Frame& frame) {
  Image image;
  draw_frame(canvas_of(scenario.golden->size), frame, {scenario.picture.theme, scenario.picture.layers}, image);
  return image;
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
  if (pixel_hash(now.image) == then.pixel_hash) return {now.frame, Verdict::exact, "", {}};
  return judge_pixels(golden, now, read_png((store.folder(golden.scenario) / then.file).string()), info_.version);
}

std::optional<std::string> problem_with_file(const GoldenStore& store, const Golden& golden, const GoldenFrame& frame) {
  const fs::path path = store.folder(golden.scenario) / frame.file;
  const MappedFile file(path.string());
  if (!file.problem().empty()) return "the reference picture " + path.string() + " is missing.";
  if (bytes_hash(file.bytes()) == frame.file_hash) return std::nullopt;
  return "the reference picture " + path.string() + " is damaged: it is not the file that was blessed.";
}

}  // namespace proofreel
