#include "golden/bless.h"

#include <algorithm>
#include <cstdio>

#include "golden/check.h"
#include "golden/words.h"
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

void remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) throw EnvironmentError("Cannot remove " + path.string() + ": " + error.message() + ".");
}

std::string what_changed(const GoldenFrame* then, const ObservedFrame& now) {
  if (then == nullptr) return "new";
  const bool state = then->trajectory_hash != now.trajectory_hash, pixels = then->pixel_hash != now.pixel_hash;
  if (state && pixels) return "other state and other pixels";
  if (state) return "other state, same pixels";
  if (pixels) return "same state, other pixels";
  return "its picture was missing or damaged";
}

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

class Blessing {
 public:
  Blessing(const Scenario& scenario, const GoldenStore& store, Pictures& pictures, BlessPlan& plan)
      : store_(store), pictures_(pictures), plan_(plan), old_(load_or_forget(store, scenario.id, plan.changes)) {
    new_.scenario = scenario.id;
    if (scenario.golden) new_.size = scenario.golden->size;
    if (old_) new_.tolerance = old_->tolerance;
  }

  Observation run(Scenario& scenario) {
    const auto make = [this](const Scenario& s, const Frame& f) { return pictures_.draw(s, f); };
    const auto look = [this](const Scenario& s, const Frame& f, ObservedFrame& now) { keep(s, f, now); };
    return observe(scenario, {make, look, &ticks_});
  }

  void keep_end(const Observation& now) {
    new_.ticks = now.report.ticks;
    new_.final_trajectory_hash = now.final_trajectory_hash;
    // Who drew is only of interest when something new was drawn: another processor alone changes no reference.
    const bool drawn_by_old = old_ && !drew_;
    new_.renderer = drawn_by_old ? old_->renderer : pictures_.info().renderer;
    new_.version = drawn_by_old ? old_->version : pictures_.info().version;
    tell_what_is_added();
    keep_ticks();
    keep_json();
  }

  void tidy(bool prune) {
    for (const fs::path& orphan : store_.orphan_files(new_)) {
      if (prune) plan_.removed.push_back(orphan);
      plan_.changes.push_back(orphan.string() +
                              (prune ? " is removed." : " belongs to no golden frame; --prune removes it."));
    }
  }

 private:
  void keep(const Scenario& scenario, const Frame& frame, ObservedFrame& now) {
    const GoldenFrame* then = old_ ? find_frame(*old_, now.frame) : nullptr;
    const bool comparable = then != nullptr && then->file == file_name(now.frame);
    const Verdict picture = comparable ? pictures_.judge(store_, *old_, *then, now).verdict : Verdict::missing;
    if (passes(picture) && then->trajectory_hash == now.trajectory_hash) {
      keep_passing(*then, scenario, frame, now);
    } else {
      keep_failing(then, picture == Verdict::exact, scenario, frame, now);
    }
    now.image.rgba = {};
  }

  void keep_passing(const GoldenFrame& then, const Scenario& scenario, const Frame& frame, const ObservedFrame& now) {
    new_.frames.push_back(then);
    const bool has_owners = load_owners(store_, *old_, then).has_value();
    if (then.touching && has_owners) return;
    added_.push_back(now.frame);
    new_.frames.back().touching = now.touching;
    if (!has_owners) keep_owners(new_.frames.back(), pictures_.draw_owners(scenario, frame));
  }

  void keep_failing(const GoldenFrame* then, bool same_picture, const Scenario& scenario, const Frame& frame,
                    const ObservedFrame& now) {
    plan_.changes.push_back(words({"frame ", std::to_string(now.frame), ": ", what_changed(then, now), "."}));
    GoldenFrame& kept = new_.frames.emplace_back(
        GoldenFrame{now.frame, now.trajectory_hash, now.pixel_hash, file_name(now.frame), "", now.bodies});
    kept.touching = now.touching;
    kept.file_hash = same_picture ? then->file_hash : keep_picture(kept.file, now.image);
    keep_owners(kept, pictures_.draw_owners(scenario, frame));
  }

  std::string keep_picture(const std::string& file, const Image& image) {
    drew_ = true;
    std::vector<std::uint8_t> bytes = encode_png(image);
    std::string hash = bytes_hash(bytes);
    plan_.files.emplace_back(store_.folder(new_.scenario) / file, std::move(bytes));
    return hash;
  }

  void keep_owners(GoldenFrame& frame, const OwnerPicture& picture) {
    frame.owners = picture.owners;
    plan_.files.emplace_back(store_.folder(new_.scenario) / owners_file_of(frame), encode_png(image_of(picture)));
  }

  void tell_what_is_added() {
    if (added_.empty()) return;
    std::string text(added_.size() == 1 ? "frame " : "frames ");
    for (std::size_t i = 0; i < added_.size(); ++i) text.append(i > 0 ? ", " : "").append(std::to_string(added_[i]));
    plan_.changes.push_back(text + ": whose its pixels are and who touches whom is added; pictures and hashes stay.");
  }

  void keep_ticks() {
    const TickTrace trace = ticks_.trace();
    if (store_.load_ticks(new_) == trace) return;
    if (plan_.changes.empty() && old_) plan_.changes.push_back("the fingerprints of its ticks are added.");
    plan_.files.emplace_back(store_.ticks_path(new_.scenario), bytes_of(trace));
  }

  void keep_json() {
    const std::string text = to_json_text(new_);
    if (old_ && to_json_text(*old_) == text) return;
    const bool other_end = old_ && old_->final_trajectory_hash != new_.final_trajectory_hash;
    if (plan_.changes.empty() || (other_end && new_.frames.empty())) {
      plan_.changes.push_back(old_ ? "the final state or the list of frames changed." : "new, without pictures.");
    }
    plan_.files.emplace_back(store_.json_path(new_.scenario), bytes_of(text));
  }

  const GoldenStore& store_;
  Pictures& pictures_;
  BlessPlan& plan_;
  std::optional<Golden> old_;
  Golden new_;
  TickRecorder ticks_;
  std::vector<std::int64_t> added_;  ///< frames that pass, but lacked what explains failures
  bool drew_ = false;
};

bool belongs_to_golden(const fs::path& file) {
  return file.extension() == ".png" || file.filename() == "golden.json" || file.filename() == "ticks.bin";
}

}  // namespace

void BlessPlan::carry_out() const {
  for (const auto& [path, bytes] : files) {
    make_folder(path.parent_path());
    write_file(path.string(), bytes);
  }
  for (const fs::path& path : removed) remove_file(path);
}

BlessPlan plan_blessing(const std::string& path, const std::vector<Override>& overrides, const GoldenStore& store,
                        Pictures& pictures, bool prune) {
  const std::unique_ptr<Scenario> scenario = load_scenario(path, overrides);
  BlessPlan plan;
  plan.scenario = scenario->id;
  Blessing blessing(*scenario, store, pictures, plan);
  const Observation now = blessing.run(*scenario);
  plan.warnings = scenario->warnings;
  plan.expectations = now.report.expectations;
  blessing.keep_end(now);
  blessing.tidy(prune);
  return plan;
}

BlessPlan plan_removal(const GoldenStore& store, const std::string& id) {
  BlessPlan plan;
  plan.scenario = id;
  plan.changes.push_back("no scenario asks for it any more; it is removed.");
  for (const fs::directory_entry& entry : fs::directory_iterator(store.folder(id))) {
    if (belongs_to_golden(entry.path())) plan.removed.push_back(entry.path());
  }
  std::sort(plan.removed.begin(), plan.removed.end());
  const bool all =
      static_cast<std::size_t>(std::distance(fs::directory_iterator(store.folder(id)), {})) == plan.removed.size();
  if (all) plan.removed.push_back(store.folder(id));  // empty by then
  return plan;
}

}  // namespace proofreel
