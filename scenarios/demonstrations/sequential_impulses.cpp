// Sequential impulses (Catto, GDC 2006; the thesis resolves collisions by impulses in chapter 5.3): contact after
// contact and sweep after sweep on a stack, starting from nothing beside starting from the impulses of the step before.

#include <algorithm>

#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/bars.h"
#include "scenarios/demonstrations/shape_pair.h"
#include "scenarios/demonstrations/stack.h"

namespace proofreel {
namespace {

constexpr double h = 1.0 / 60;
constexpr int steps = 10;
constexpr int iterations = 4;
/// From this step on there is nothing new to read: the bars go on.
constexpr int first_quick_step = 3;
constexpr const char* quick_words = "Step after step: cold from nothing, warm from the impulses of the step before.";

/// What the contacts have to give in a step: very many sweeps.
std::vector<double> loads_of(const std::vector<DemonstrationShape>& shapes) {
  constexpr int enough = 2000;
  Stack stack(shapes);
  stack.begin_substep(h, false);
  for (int i = 0; i < enough; ++i) stack.sweep();
  return stack.impulses();
}

/// A stack and what the solver has told of its contacts.
struct Side {
  Side(const std::vector<DemonstrationShape>& shapes, bool warm)
      : stack(shapes), starts_warm(warm), top(shapes.size()), impulses(stack.contacts().size()) {}

  void begin() {
    stack.begin_substep(h, starts_warm);
    impulses = stack.impulses();
  }
  /// The events of one sweep.
  std::vector<ContactSwept> sweep() {
    std::vector<ContactSwept> swept;
    stack.sweep(Observer([&](const Event& event) { swept.push_back(std::get<ContactSwept>(event)); }));
    return swept;
  }
  void take(const ContactSwept& event) { impulses[event.contact] = event.normal[0] + event.normal[1]; }

  void end() {
    stack.end_substep();
    sunk = std::max(0.0, -stack.moved(top).y);
  }

  Stack stack;
  bool starts_warm;
  std::size_t top;               ///< the last body
  std::vector<double> impulses;  ///< N s, by contact
  double sunk = 0;               ///< how far the last body has, m
};

/// How far the last body sinks from cold starts, the worse side.
double depth_of(const std::vector<DemonstrationShape>& shapes) {
  Side cold(shapes, false);
  double deepest = 0;
  for (int step = 0; step < steps; ++step) {
    cold.begin();
    for (int i = 0; i < iterations; ++i) cold.sweep();
    cold.end();
    deepest = std::max(deepest, cold.sunk);
  }
  return deepest;
}

class Sweeps {
 public:
  explicit Sweeps(const Demonstration& asked)
      : cold_(asked.shapes, false),
        warm_(asked.shapes, true),
        loads_(loads_of(asked.shapes)),
        depth_(depth_of(asked.shapes)),
        board_(asked.pace) {
    board_.pane("");
    cold_pane_ = board_.pane("cold start", 0.6, true);
    warm_pane_ = board_.pane("warm start", 0.6, true);
    board_.heading("Sequential impulses");
    keep_stack(asked.shapes);
    whole_ = 1.3 * *std::max_element(loads_.begin(), loads_.end());
  }

  Story tell() {
    show_all();
    board_.step(filled("Within a time step of $h = 1/60$ s gravity makes every body faster by $g\u2009h = %$ m/s. The "
                       "contacts must take that back.",
                       {figure(Stack::gravity * h)}),
                4);
    show_all();
    board_.step(
        "Nobody knows their impulses. Solve one contact at a time, and go round again and again. The marks show "
        "where that leads.",
        4);
    for (step_ = 1; step_ <= steps; ++step_) tell_step();
    return finish();
  }

 private:
  bool is_quick() const { return step_ >= first_quick_step; }

  void tell_step() {
    cold_.begin();
    warm_.begin();
    iteration_ = 0;
    if (!is_quick()) board_.heading(filled("Sequential impulses: time step %", {figure(std::size_t(step_))}));
    if (step_ == first_quick_step) board_.heading("Sequential impulses: step after step");
    show_all();
    board_.step(step_ == 1   ? "Both sides begin with nothing: the contacts are new."
                : is_quick() ? quick_words
                             : "A cold start begins with nothing again. A warm start applies the impulses of the step "
                               "before at once: bodies at rest need the same in every step.",
                is_quick() ? 0.3 : 5);
    for (iteration_ = 1; iteration_ <= iterations; ++iteration_) tell_sweep();
    cold_.end();
    warm_.end();
  }

  void tell_sweep() {
    const std::vector<ContactSwept> cold = cold_.sweep(), warm = warm_.sweep();
    for (std::size_t i = 0; i < cold.size(); ++i) {
      cold_.take(cold[i]);
      warm_.take(warm[i]);
      if (step_ == 1 && iteration_ == 1) tell_contact(cold[i].contact);
    }
    if (step_ == 1 && iteration_ == 1) return;
    show_all();
    board_.step(is_quick()
                    ? quick_words
                    : "Once more round all contacts. Impulses add up; a contact may take back some of its own, but "
                      "its sum never pulls.",
                is_quick() ? 0.25 : 2);
  }

  void tell_contact(std::uint32_t contact) {
    show_all(contact);
    const Stack& stack = cold_.stack;
    board_.step(
        filled("Contact %: as much impulse as stops the approach at its points, $%$ N\u2009s. That disturbs the "
               "contacts beside it.",
               {stack.name(stack.contacts()[contact]), figure(cold_.impulses[contact], 3)}),
        2.5);
  }

  Story finish() {
    step_ = steps;
    iteration_ = iterations;
    show_all();
    board_.step(
        filled(
            "After % steps of % iterations body % has sunk by $%$\u2009mm from cold starts, by $%$\u2009mm from warm "
            "ones, at the "
            "same price.",
            {figure(std::size_t{steps}), figure(std::size_t{iterations}), figure(cold_.top),
             figure(1000 * cold_.sunk, 1), figure(1000 * warm_.sunk, 1)}),
        8);
    return board_.finish();
  }

  void keep_stack(const std::vector<DemonstrationShape>& shapes) {
    std::vector<Vec2d> corners;
    for (const DemonstrationShape& shape : shapes)
      corners.insert(corners.end(), shape.parts[0].begin(), shape.parts[0].end());
    const Aabbd box = bounds_of(corners);
    unit_ = (box.upper.y - box.lower.y) / static_cast<double>(shapes.size());
    const double aside = 0.6 * unit_;
    board_.keep(path_mark(Role::second, {{box.lower.x - aside, box.lower.y}, {box.upper.x + aside, box.lower.y}}));
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      board_.keep(shape_mark(Role::first, shapes[i]));
      board_.keep(text_mark(Role::first, middle_of(shapes[i].parts[0]), {}, figure(i + 1)));
    }
  }

  static constexpr std::uint32_t nobody = UINT32_MAX;

  void show_all(std::uint32_t current = nobody) {
    board_.counters({});
    if (step_ > 0) {
      board_.counters({{"step", figure(static_cast<std::size_t>(step_))},
                       {"iteration", figure(static_cast<std::size_t>(iteration_))}});
    }
    show_side(cold_, cold_pane_, Role::alert, current);
    show_side(warm_, warm_pane_, Role::result, current);
    const Stack& stack = warm_.stack;
    for (std::uint32_t i = 0; i < stack.contacts().size(); ++i) {
      for (int k = 0; k < stack.contacts()[i].manifold.count; ++k)
        board_.show(dot_mark(i == current ? Role::candidate : Role::rejected, stack.at(stack.contacts()[i], k)));
    }
  }

  /// A bar for every contact, the uppermost above, and a mark at what it has to bear.
  void show_side(const Side& side, int pane, Role role, std::uint32_t current) {
    const std::size_t n = loads_.size();
    std::vector<Bar> bars;
    for (std::size_t row = 0; row < n; ++row) {
      const std::size_t i = n - 1 - row;
      const std::string name = side.stack.name(side.stack.contacts()[i]);
      bars.push_back({i == current ? Role::candidate : role, side.impulses[i],
                      filled("%: % N\u2009s", {name, figure(side.impulses[i], 3)}), name});
      const double x = loads_[i] / whole_;
      const double top = -static_cast<double>(row);
      board_.show(in_pane(path_mark(Role::first, {{x, top - 0.84}, {x, top - 0.47}}), pane));
    }
    // On a scale of its own.
    bars.push_back({Role::candidate, depth_ > 0 ? whole_ * side.sunk / depth_ : 0,
                    filled("% has sunk % mm", {figure(side.top), figure(1000 * side.sunk, 1)}), "sunk"});
    show_bars(board_, pane, bars, whole_);
  }

  Side cold_;
  Side warm_;
  std::vector<double> loads_;  ///< N s, by contact
  double depth_;               ///< m
  Storyboard board_;
  int cold_pane_ = 0;
  int warm_pane_ = 0;
  double whole_ = 1;
  double unit_ = 1;
  int step_ = 0;
  int iteration_ = 0;
};

}  // namespace

Story tell_sequential_impulses(const Demonstration& demonstration) { return Sweeps(demonstration).tell(); }

}  // namespace proofreel
