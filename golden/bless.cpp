#include "golden/bless.h"

#include <cstdio>

#include "render/output_file.h"
#include "render/pixel_hash.h"
#include "render/png.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

std::string file_name(std::int64_t frame) {
  char name[40];
  std::snprintf(name, sizeof name, "frame_%05lld.png", static_cast<long long>(frame));
  return name;
}

std::optional<Golden> load_or_forget(const GoldenStore& store, const std::string& id,
                                     std::vector<std::string>& changes) {
  try {
    return store.load(id);
  } catch (const GoldenError& error) {
    changes.push_back(std::string(error.what()) + " It is written anew.");
    return std::nullopt;
  }
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw EnvironmentError("Cannot make the folder " + path.string() + ": " + error.message() + ".");
}

void remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) throw EnvironmentError("Cannot remove " + path.string() + ": " + error.message() + ".");
}

const GoldenFrame* find(const std::optional<Golden>& golden, std::int64_t frame) {
  if (!golden) return nullptr;
  for (const GoldenFrame& candidate : golden->frames) {
    if (candidate.frame == frame) return &candidate;
  }
  return nullptr;
}

std::string what_changed(const GoldenFrame* then, const GoldenFrame& now) {
  if (then == nullptr) return "new";
  const bool state = then->trajectory_hash != now.trajectory_hash, pixels = then->pixel_hash != now.pixel_hash;
  if (state && pixels) return "other state and other pixels";
  if (state) return "other state, same pixels";
  if (pixels) return "same state, other pixels";
  return "its picture was missing or damaged";
}

class Blessing {
 public:
  Blessing(const Scenario& scenario, const GoldenStore& store, BlessResult& result)
      : store_(store), result_(result), old_(load_or_forget(store, scenario.id, result.changes)) {
    new_.scenario = scenario.id;
    if (scenario.golden) new_.size = scenario.golden->size;
    if (old_) new_.tolerance = old_->tolerance;
  }

  void keep(const Observation& now, const GlInfo& info) {
    new_.ticks = now.report.ticks;
    new_.final_trajectory_hash = now.final_trajectory_hash;
    make_folder(store_.folder(new_.scenario));
    for (const ObservedFrame& frame : now.frames) keep_frame(frame);
    // Who drew is only of interest when something new was drawn: another processor alone changes no reference.
    const bool drawn_by_old = old_ && !drew_;
    new_.renderer = drawn_by_old ? old_->renderer : info.renderer;
    new_.version = drawn_by_old ? old_->version : info.version;
    keep_json();
  }

  void tidy(bool prune) {
    for (const fs::path& orphan : store_.orphan_files(new_)) {
      if (prune) remove_file(orphan);
      result_.changes.push_back(orphan.string() +
                                (prune ? " is removed." : " belongs to no golden frame; --prune removes it."));
    }
  }

 private:
  void keep_frame(const ObservedFrame& now) {
    const GoldenFrame* then = find(old_, now.frame);
    GoldenFrame frame{now.frame, now.trajectory_hash, pixel_hash(now.image), file_name(now.frame), "", now.bodies};
    const bool same_picture = then != nullptr && then->pixel_hash == frame.pixel_hash && then->file == frame.file &&
                              new_.size == old_->size && !problem_with_file(store_, *old_, *then);
    frame.file_hash = same_picture ? then->file_hash : write_picture(frame.file, now.image);
    if (!same_picture || then->trajectory_hash != frame.trajectory_hash) {
      result_.changes.push_back("frame " + std::to_string(now.frame) + ": " + what_changed(then, frame) + ".");
    }
    new_.frames.push_back(std::move(frame));
  }

  std::string write_picture(const std::string& file, const Image& image) {
    drew_ = true;
    const std::vector<std::uint8_t> bytes = encode_png(image);
    write_file((store_.folder(new_.scenario) / file).string(), bytes);
    return bytes_hash(bytes);
  }

  void keep_json() {
    const std::string text = to_json_text(new_);
    if (old_ && to_json_text(*old_) == text) return;
    if (result_.changes.empty()) {
      result_.changes.push_back(old_ ? "the final state or the list of frames changed." : "new, without pictures.");
    }
    write_file(store_.json_path(new_.scenario).string(), text);
  }

  const GoldenStore& store_;
  BlessResult& result_;
  std::optional<Golden> old_;
  Golden new_;
  bool drew_ = false;
};

}  // namespace

BlessResult bless_scenario(const std::string& path, const std::vector<Override>& overrides, const GoldenStore& store,
                           Pictures& pictures, bool prune) {
  const std::unique_ptr<Scenario> scenario = load_scenario(path, overrides);
  const Observation now =
      observe(*scenario, [&pictures](const Scenario& s, const Frame& f) { return pictures.draw(s, f); });
  BlessResult result{scenario->id, scenario->warnings, {}, now.report.expectations};
  Blessing blessing(*scenario, store, result);
  blessing.keep(now, pictures.info());
  blessing.tidy(prune);
  return result;
}

}  // namespace proofreel
