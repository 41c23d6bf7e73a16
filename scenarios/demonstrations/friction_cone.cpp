// The friction cone (thesis chapter 3.4, friction): a force on a block tilts. The block is stepped by the engine, and
// the ground's answer in the picture is what its contacts did.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/elementary.h"
#include "engine/simulation.h"
#include "scenarios/demonstrations/algorithms.h"
#include "scenarios/demonstrations/bars.h"
#include "scenarios/demonstrations/turning.h"
#include "scenarios/demonstrations/weighed.h"

namespace proofreel {
namespace {

constexpr int rate = 240;
constexpr int ticks_per_step = 8;
constexpr BodyId block_id{2};
constexpr double degree = std::numbers::pi / 180;

/// The block on level ground, without gravity: the force is all that acts.
Scene scene_of(const DemonstrationShape& block) {
  const Aabbd box = bounds_of(block.parts[0]);
  const double far = 40 * extent_of(block.parts[0]), floor = box.lower.y;
  Scene scene;
  scene.rate = rate;
  scene.gravity = {};
  BodyDef ground;
  ground.type = BodyType::fixed;
  BodyDef body;
  ShapeDef slab;
  slab.points = {{-far, floor - far}, {far, floor - far}, {far, floor}, {-far, floor}};
  ShapeDef shape;
  shape.points = block.parts[0];
  shape.density = block.density;
  for (ShapeDef* def : {&slab, &shape}) def->friction = block.friction;
  ground.shapes = {slab};
  body.shapes = {shape};
  scene.bodies = {ground, body};
  return scene;
}

/// What the ground did to the block in the last tick, N.
struct Answer {
  double normal = 0;
  double friction = 0;  ///< against the pull, to the left
};

class Cone {
 public:
  explicit Cone(const Demonstration& asked)
      : block_(asked.shapes[0]),
        mass_(weighed(block_)),
        simulation_(make_simulation(scene_of(block_))),
        force_(mass_.mass * 9.81),
        size_(extent_of(block_.parts[0])),
        static_angle_(elementary::atan2(block_.friction.at_rest, 1.0)),
        kinetic_angle_(elementary::atan2(block_.friction.sliding, 1.0)),
        board_(asked.pace) {
    board_.pane("");
    bars_ = board_.pane("", 0.5, true);
    board_.heading("Friction cone");
  }

  Story tell() {
    tell_inside();
    tell_outside();
    tell_kinetic();
    return board_.finish();
  }

 private:
  void tell_inside() {
    run(0.2, 0, 0, nullptr);
    show(0);
    board_.step(
        filled("A force $F$ of $%$ N, weight and push together, presses a block on the ground. The ground answers by "
               "$R$.",
               {figure(force_, 1)}),
        4);
    const double nearly = 0.96 * static_angle_;
    run(4, 0, nearly,
        "$F$ tilts. Inside the cone friction is always just as large as the part $F_t$ along the ground: nothing "
        "moves.");
    show(nearly);
    board_.step(
        filled(
            "Still at rest: $F_t = %$ N, and friction $\u03bc_s F_n$ could be up to $%$\u2009N. So the cone reaches to "
            "$\u03b1 = %\u00b0$, where $tan\u2009\u03b1 = \u03bc_s$.",
            {figure(force_ * elementary::sin(nearly), 1),
             figure(block_.friction.at_rest * force_ * elementary::cos(nearly), 1), figure(static_angle_ / degree, 1)}),
        6);
  }

  void tell_outside() {
    const double beyond = static_angle_ + 2 * degree;
    run(0.25, 0.96 * static_angle_, static_angle_ - 0.1 * degree, "Up to the edge of the cone the block stays.");
    run(0.75, static_angle_ + 0.1 * degree, beyond,
        "Outside of the cone static friction does not hold it. The block slides, and is braked by $\u03bc_k F_n$ "
        "only.");
    show(beyond);
    const double rest = force_ * (elementary::sin(beyond) - block_.friction.sliding * elementary::cos(beyond));
    board_.step(filled("It slides at $%$ m/s. $F_t \u2212 \u03bc_k F_n = %$ N make it faster: $a = %$ m/s\u00b2",
                       {figure(speed()), figure(rest, 1), figure(rest / mass_.mass)}),
                6);
  }

  void tell_kinetic() {
    const double inside = std::max(0.0, kinetic_angle_ - 10 * degree);
    run(0.5, static_angle_ + 2 * degree, inside,
        "$F$ tilts back. What slides needs the narrow, kinetic cone to get slower.");
    run_until_rest(inside,
                   "Inside the kinetic cone friction $\u03bc_k F_n$ is larger than $F_t$: the block gets slower.");
    run(0.2, inside, inside, nullptr);
    show(inside);
    board_.step("At rest again. Friction is no larger now than it has to be: as large as $F_t$.", 6);
  }

  /// Steps the engine while the force tilts from one angle to another; with a caption, films it.
  void run(double seconds, double from, double to, const char* caption) {
    const int ticks = static_cast<int>(seconds * rate);
    for (int i = 1; i <= ticks; ++i) {
      const double angle = from + (to - from) * i / ticks;
      step(angle);
      if (caption != nullptr && i % ticks_per_step == 0) film(angle, caption);
    }
  }

  void run_until_rest(double angle, const char* caption) {
    constexpr int longest = 20 * rate;
    for (int i = 1; i <= longest && speed() > 1e-3; ++i) {
      step(angle);
      if (i % ticks_per_step == 0) film(angle, caption);
    }
  }

  void step(double angle) {
    simulation_->apply(ApplyForce{block_id, force_at(angle), std::nullopt});
    simulation_->step();
  }

  void film(double angle, const char* caption) {
    show(angle);
    board_.step(caption, slowness() * ticks_per_step / rate);
  }

  /// Sliding is over soon: it is shown at half speed.
  double slowness() const { return speed() > 1e-3 ? 2 : 1; }

  Vec2d force_at(double angle) const { return force_ * Vec2d{elementary::sin(angle), -elementary::cos(angle)}; }
  double speed() const { return simulation_->body(block_id).velocity.x; }

  Answer answer() const {
    Answer sum;
    for (const ContactView& contact : simulation_->contacts()) {
      const double side = contact.b == block_id ? 1 : -1;
      for (int k = 0; k < contact.point_count; ++k) {
        const ContactPoint& point = contact.points[k];
        const Vec2d push =
            rate * side * (point.normal_impulse * contact.normal + point.tangent_impulse * perp(contact.normal));
        sum.normal += push.y;
        sum.friction -= push.x;
      }
    }
    return sum;
  }

  void show(double angle) {
    const Vec2d center = simulation_->body(block_id).center;
    const double floor = bounds_of(block_.parts[0]).lower.y;
    DemonstrationShape block = block_;
    for (Vec2d& corner : block.parts[0]) corner += center - mass_.center;
    board_.show(
        path_mark(Role::second, {{mass_.center.x - 1.4 * size_, floor}, {mass_.center.x + 3.2 * size_, floor}}));
    board_.show(keyed(shape_mark(Role::first, block), "block"));
    show_cone(center, static_angle_, Role::chosen, "static");
    show_cone(center, kinetic_angle_, Role::quiet, "kinetic");
    const double reach = 1.1 * size_;
    const Vec2d way = 1 / force_ * force_at(angle);
    const bool inside = speed() < 1e-3;
    const Role role = inside ? Role::result : Role::alert;
    show_arrow(role, center, center + reach * way, "F");
    const Answer given = answer();
    const Vec2d foot = center + (center.y - floor) / -way.y * way;
    show_arrow(Role::candidate, foot, foot + reach / force_ * Vec2d{-given.friction, given.normal}, "R");
    show_forces(angle, given);
    board_.counters(
        {{"tilt", filled("%\u00b0", {figure(angle / degree, 1)})}, {"speed", filled("% m/s", {figure(speed())})}});
  }

  void show_arrow(Role role, Vec2d from, Vec2d to, const std::string& name) {
    board_.show(keyed(arrow_mark(role, from, to), name));
    board_.show(keyed(text_mark(role, to + 0.1 * size_ * towards(from, to), {}, name), name));
  }

  void show_cone(Vec2d apex, double half_angle, Role role, const std::string& name) {
    StoryMark cone = sector_mark(role, {0, -1}, size_, half_angle);
    for (Vec2d& p : cone.points) p += apex;
    board_.show(keyed(std::move(cone), name));
  }

  void show_forces(double angle, Answer given) {
    const double pull = force_ * elementary::sin(angle), press = force_ * elementary::cos(angle);
    const auto newtons = [](const std::string& name, double value) {
      return filled("%: % N", {name, figure(value, 1)});
    };
    show_bars(board_, bars_,
              {{Role::result, pull, newtons("$F_t$ along the ground", pull), "pull"},
               {Role::candidate, given.friction, newtons("friction", given.friction), "friction"},
               {Role::chosen, block_.friction.at_rest * press,
                newtons("$\u03bc_s F_n$, static", block_.friction.at_rest * press), "static"},
               {Role::rejected, block_.friction.sliding * press,
                newtons("$\u03bc_k F_n$, kinetic", block_.friction.sliding * press), "kinetic"}},
              1.05 * std::max(block_.friction.at_rest, 0.5) * force_);
  }

  DemonstrationShape block_;
  MassProperties mass_;
  std::unique_ptr<Simulation> simulation_;
  double force_;  ///< N
  double size_;   ///< m, of the block
  double static_angle_;
  double kinetic_angle_;
  Storyboard board_;
  int bars_ = 0;
};

}  // namespace

Story tell_friction_cone(const Demonstration& demonstration) { return Cone(demonstration).tell(); }

}  // namespace proofreel
