#pragma once

/// What the files of this folder share: how a story is put together, step by step.

#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/observer.h"
#include "scenarios/demonstration.h"

namespace proofreel {

/// Marks by what they are.
StoryMark shape_mark(Role role, const DemonstrationShape& shape, std::size_t part = 0);
StoryMark region_mark(Role role, std::vector<Vec2d> points);
StoryMark bar_mark(Role role, std::vector<Vec2d> points);
StoryMark path_mark(Role role, std::vector<Vec2d> points);
StoryMark closed_path(Role role, std::vector<Vec2d> points);
StoryMark arrow_mark(Role role, Vec2d from, Vec2d to);
StoryMark dot_mark(Role role, Vec2d at);
StoryMark origin_mark(Vec2d at);
StoryMark text_mark(Role role, Vec2d at, Vec2d side, std::string text);
/// The four corners of a box, closed.
StoryMark box_mark(Role role, const Aabbd& box);

/// The same mark with something more.
StoryMark labelled(StoryMark mark, Vec2d side, std::string text);
StoryMark keyed(StoryMark mark, std::string key);
StoryMark in_pane(StoryMark mark, int pane);

/// Collects marks into steps. What is kept shows in all steps from now on, the rest in the next one only.
class Storyboard {
 public:
  explicit Storyboard(double pace) : pace_(pace) {}

  int pane(std::string title, double share = 1, bool diagram = false);
  /// From now on all panes in metres show the same part of the world.
  void share_bounds() { shares_bounds_ = true; }
  void heading(std::string text) { heading_ = std::move(text); }
  void counters(std::vector<Counter> counters) { counters_ = std::move(counters); }
  void keep(StoryMark mark) { kept_.push_back(std::move(mark)); }
  void show(StoryMark mark) { shown_.push_back(std::move(mark)); }
  /// Ends the step, which is shown `paces` times as long as a usual one.
  void step(std::string caption, double paces = 1);
  /// A motion: many short steps that run into each other. show(part) shows how it has come `part` of the way, up to 1;
  /// what moves needs a key.
  template <typename Show>
  void glide(const std::string& caption, double paces, int steps, Show show) {
    for (int i = 1; i <= steps; ++i) {
      show(static_cast<double>(i) / steps);
      step(caption, paces / steps);
    }
  }
  /// The story so far, every pane as large as what it ever shows.
  Story finish();

 private:
  double pace_;
  std::string heading_;
  std::vector<Counter> counters_;
  std::vector<StoryMark> kept_;
  std::vector<StoryMark> shown_;
  bool shares_bounds_ = false;
  Story story_;
};

/// Hands on to teller.tell(event) every event of an algorithm that it has words for.
template <typename Teller>
Observer telling(Teller& teller) {
  return Observer([&teller](const Event& event) {
    std::visit(
        [&teller](const auto& e) {
          if constexpr (requires { teller.tell(e); }) teller.tell(e);
        },
        event);
  });
}

/// All parts of a shape, outlined as one when there are several; `group` tells them from other shapes.
std::vector<StoryMark> shape_marks(Role role, const DemonstrationShape& shape, int group);

/// A number for captions, with a typographic minus.
std::string figure(double value, int decimals = 2);
std::string figure(std::size_t count);
/// "(1.2, −0.5)"
std::string figure(Vec2d v, int decimals = 2);
/// The pattern with its % replaced by the values in turn.
std::string filled(std::string_view pattern, std::initializer_list<std::string> values);
/// A, B, ... Z.
std::string letter(std::size_t index);

/// The shape turned about a point by `angle` radians.
DemonstrationShape turned(DemonstrationShape shape, Vec2d about, double angle);
Vec2d middle_of(const std::vector<Vec2d>& points);
/// The unit vector from `from` to `to`, or up where they are the same.
Vec2d towards(Vec2d from, Vec2d to);
Aabbd bounds_of(const std::vector<Vec2d>& points);
/// The size of what the points cover: its larger side.
double extent_of(const std::vector<Vec2d>& points);

}  // namespace proofreel
