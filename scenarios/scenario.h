#pragma once

/// A scenario as loaded from its file: the scene to simulate, the picture to make of it, and the script that acts in
/// it.

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene.h"
#include "engine/simulation.h"
#include "scenarios/demonstration.h"

namespace proofreel {

enum class Theme : std::uint8_t { light, dark, print };
enum class Layer : std::uint8_t {
  bodies,
  parts,
  bvh,
  contacts,
  joints,
  aabbs,
  trails,
  vectors,
  labels,
  grid,
  clock,
  forces,   ///< of contacts, at their points, and the reactions of joints
  islands,  ///< bodies tinted by the island they belong to
  ids,
  mass,   ///< centres of mass, kilograms
  energy  ///< kinetic, potential and total as bars
};
inline constexpr int layer_count = 16;
const char* name_of(Layer layer);
std::optional<Layer> layer_named(std::string_view name);
std::optional<Theme> theme_named(std::string_view name);

/// Where a caption or a plot sits.
enum class Corner : std::uint8_t { top_left, top, top_right, bottom_left, bottom, bottom_right };
constexpr bool is_at_top(Corner at) { return at <= Corner::top_right; }

struct Size {
  int width_px = 0;
  int height_px = 0;
  friend bool operator==(Size, Size) = default;
};

/// The part of the world in the picture. Metres; the width follows from the picture's proportions.
struct View {
  Vec2d center;
  double height = 10;
  Size made_for = {};  ///< what a picture of these proportions shows, one of any others shows too; zero: any will do
};

/// How a camera move goes on: from rest to rest, or at one speed.
enum class Ease : std::uint8_t { smooth, linear };

/// From `at` on the camera moves to the given view within `over` seconds, or follows a body.
struct CameraMove {
  double at = 0;
  double over = 0;
  std::optional<Vec2d> center;
  std::optional<double> height;
  std::optional<BodyId> follow;
  Ease ease = Ease::smooth;
};

struct Caption {
  std::string text;
  double from = 0;
  double to = 0;
  Corner at = Corner::bottom;
  std::string place = {};  ///< where the script makes it, as sentences begin: "ball.lua: line 12: "
};

struct Label {
  BodyId body{};
  std::string text;
};

enum class VectorOf : std::uint8_t { velocity, force, momentum, acceleration, contact_impulse, given };

/// An arrow at a body, `scale` metres long per unit of the quantity, from scene time `from` until `to`.
struct VectorMark {
  BodyId body{};
  VectorOf of = VectorOf::velocity;
  double scale = 1;
  Vec2d value{};               ///< world; of a given one
  std::optional<Vec2d> point;  ///< body coordinates, where it begins; the centre of mass where not given
  double from = 0;
  double to = std::numeric_limits<double>::infinity();
};

struct TrailMark {
  BodyId body{};
  double seconds = 1;
  std::optional<Vec2d> point;  ///< body coordinates; the centre of mass where not given
};

/// A chart of quantities against time, or of a phase portrait against another quantity; the functions live in the
/// script, curve i of plot p is sampled by Script::plot_value.
struct PlotMark {
  std::string title;
  std::vector<std::string> curves;  ///< names, in sorted order
  double seconds = 10;
  Corner at = Corner::top_right;
  std::string unit = {};    ///< of all curves
  std::string x_name = {};  ///< of a phase portrait: the quantity in the place of time, the curve behind the last one
  std::string x_unit = {};
};

/// From scene time `from` to `to` a body, one of its points, a joint or a point of the world is emphasised. What is of
/// a body or joint goes with it.
struct Highlight {
  std::optional<BodyId> body;
  std::optional<JointId> joint;
  std::optional<Vec2d> at;     ///< world
  std::optional<Vec2d> point;  ///< body coordinates
  double radius = 0;           ///< m, of the circle round a point; 0: a usual one
  double from = 0;
  double to = 0;
  std::string text;
};

/// Between scene times `from` and `to` the film runs at `factor` times real speed.
struct SlowMotion {
  double from = 0;
  double to = 0;
  double factor = 1;
  friend bool operator==(const SlowMotion&, const SlowMotion&) = default;
};

/// A pale copy of the body stays behind every so many seconds.
struct GhostMark {
  BodyId body{};
  double every = 0.1;  ///< s
};

/// At scene time `at` the film stands still.
struct Freeze {
  double at = 0;
  double seconds = 1;  ///< of film
  friend bool operator==(const Freeze&, const Freeze&) = default;
};

/// A part of the film, from scene time `at` to where the next one begins.
struct Section {
  double at = 0;
  std::string name;
  friend bool operator==(const Section&, const Section&) = default;
};

/// From scene time `at` on the picture shows these layers.
struct LayerChange {
  double at = 0;
  std::vector<Layer> layers;
};

/// What the picture shows beyond the bodies. Grows while the script runs; entries are never removed.
struct Picture {
  View view;
  Size size{1280, 720};
  int fps = 60;
  Theme theme = Theme::light;
  std::vector<Layer> layers{Layer::bodies, Layer::joints, Layer::trails, Layer::vectors, Layer::labels};
  std::vector<LayerChange> layer_changes;  ///< in order of time
  double force_scale = 0;                  ///< m per N in the layer forces
  std::vector<CameraMove> camera;
  std::vector<Caption> captions;
  std::vector<Label> labels;
  std::vector<VectorMark> vectors;
  std::vector<TrailMark> trails;
  std::vector<PlotMark> plots;
  std::vector<GhostMark> ghosts;
  std::vector<Highlight> highlights;
  std::vector<SlowMotion> slow;
  std::vector<Freeze> freezes;
  std::vector<Section> sections;  ///< in order of time
};

/// The layers of the moment.
const std::vector<Layer>& layers_at(const Picture& picture, std::int64_t tick, int rate);
/// Whether the layer shows at any time.
bool ever_shows(const Picture& picture, Layer layer);

/// Which film frames are kept as references, and how large.
struct GoldenFrames {
  std::vector<std::int64_t> frames;
  Size size{480, 270};
};

/// A sentence that must hold, and when.
struct Expectation {
  enum class When : std::uint8_t { always, at, finally };
  std::string text;
  When when = When::finally;
  double at = 0;  ///< scene time, for When::at
};

struct Measure {
  std::string name;
  bool has_reference = false;
  std::vector<double> reference_times = {};  ///< s; the only ones the reference speaks of, empty where it knows all
};

/// Which of a script's functions: measures count with their references, force fields are one.
enum class ScriptFunction : std::uint8_t { measure, expectation, field };

/// What happens at which time. A script acts on the simulation it is bound to through commands, and may add to the
/// scenario's picture while it runs. All functions may throw ScenarioError.
class Script {
 public:
  virtual ~Script() = default;
  /// From now on handles speak to this simulation, which must have been made from this scenario's scene and outlive
  /// the binding; without one they speak of the scene.
  virtual void bind(Simulation* simulation) = 0;
  /// Runs what is due at the simulation's tick: `at` and `every` before the tick is stepped. Call once per tick.
  virtual void before_step() = 0;
  /// Runs what the last step set off: contact events.
  virtual void after_step() = 0;
  virtual double measure(int index) = 0;
  /// What measure `index` should be at tick `tick`; nothing where its reference says nothing at that time.
  virtual std::optional<double> reference(int index, std::int64_t tick) = 0;
  virtual bool expectation(int index) = 0;
  virtual double plot_value(int plot, int curve) = 0;

  /// From now on adds to `log` every command the script gives; null ends it.
  virtual void log_commands(std::vector<Command>* log) = 0;
  /// Somebody else has given this command: now the script knows what it made.
  virtual void adopt(const Command& command) = 0;
  /// Whether anything is due at some time, or waits for an event.
  virtual bool has_callbacks() const = 0;
  /// Notes what all variables hold that measures, expectations and force fields can see.
  virtual void remember_variables() = 0;
  /// The name of a variable that this function can see and that holds something else than it did then.
  virtual std::optional<std::string> changed_variable(ScriptFunction what, int index) = 0;
};

/// One loaded scenario. Loading and running it needs no display.
struct Scenario {
  std::string id;  ///< path below scenarios/ without .lua, or the file's stem
  std::string path;
  std::string title;
  std::string description;
  double duration = 5;  ///< s
  std::uint64_t seed = 1;
  Scene scene;
  Picture picture;
  std::optional<GoldenFrames> golden;
  std::vector<Measure> measures;
  std::vector<Expectation> expectations;
  std::vector<std::string> warnings;
  std::uint64_t source_hash = 0;                ///< XXH3 of its text and of all it includes
  std::map<std::string, std::string> settings;  ///< what `--set` replaced: full key, value
  std::vector<Story> stories;                   ///< lecture films to show one after the other, in place of bodies
  std::vector<std::string> body_names;          ///< of body i + 1; grows with the bodies a running script makes
  std::unique_ptr<Script> script;
  /// A split screen: this is its first pane, titled so, and these are the others: scenarios made of the same file, each
  /// with what is different in its pane. They last as long, have as many frames a second and measure the same.
  std::string pane_title;
  std::vector<std::unique_ptr<Scenario>> other_panes;

  /// Ticks of the whole run: round(duration * rate).
  std::int64_t ticks() const;
};

/// One `--set KEY=VALUE` from the command line.
struct Override {
  std::string key;
  std::string value;
};

/// A sentence for the user: file, line, what is wrong, what to do. Exit status 2.
class ScenarioError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads and runs the scenario file; the overrides replace what `scenario{}` says. Throws ScenarioError.
/// The scenario stays where it is made: its script refers to it.
std::unique_ptr<Scenario> load_scenario(const std::string& path, const std::vector<Override>& overrides);

}  // namespace proofreel
