#include "scenarios/film.h"

#include <algorithm>
#include <cmath>

#include "scenarios/timeline.h"

namespace proofreel {
namespace {

/// How far a change has come, 0 to 1: starts and ends at rest.
double eased(double part) {
  const double s = std::clamp(part, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

double progress(const CameraMove& move, double time) {
  if (move.over <= 0) return 1;
  const double part = (time - move.at) / move.over;
  return move.ease == Ease::smooth ? eased(part) : std::clamp(part, 0.0, 1.0);
}

/// Each move leads from what the moves before it show now, which may itself be moving, to its own target.
View camera_view(const Scenario& scenario, const Recorder& recorder, const Snapshot& snapshot) {
  const std::vector<CameraMove>& moves = scenario.picture.camera;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (tick_at(moves[i].at, scenario.scene.rate) <= snapshot.tick) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return moves[a].at < moves[b].at; });
  View view = scenario.picture.view;
  for (const std::size_t i : order) {
    const double part = progress(moves[i], snapshot.time);
    const Vec2d center =
        moves[i].follow ? recorder.followed(i).value_or(view.center) : moves[i].center.value_or(view.center);
    view.center = lerp(view.center, center, part);
    view.height += part * (moves[i].height.value_or(view.height) - view.height);
  }
  return view;
}

/// N s that all touching contacts have pushed `body` with.
Vec2d contact_impulse(const Snapshot& snapshot, BodyId body) {
  Vec2d sum;
  for (const ContactView& contact : snapshot.contacts) {
    if (contact.a != body && contact.b != body) continue;
    const double side = contact.b == body ? 1 : -1;
    for (int i = 0; i < contact.point_count; ++i) sum += side * contact.points[i].normal_impulse * contact.normal;
  }
  return sum;
}

Vec2d quantity(const Snapshot& snapshot, const BodyView& body, const VectorMark& mark) {
  switch (mark.of) {
    case VectorOf::velocity:
      return body.state.velocity;
    case VectorOf::force:
      return body.force;
    case VectorOf::momentum:
      return body.state.mass * body.state.velocity;
    case VectorOf::acceleration:
      return body.state.mass > 0 ? (1 / body.state.mass) * body.force : Vec2d{};
    case VectorOf::contact_impulse:
      return contact_impulse(snapshot, body.id);
    case VectorOf::given:
      return mark.value;
  }
  return {};
}

std::vector<ArrowView> arrows(const Picture& picture, const Snapshot& snapshot) {
  std::vector<ArrowView> views;
  for (const VectorMark& mark : picture.vectors) {
    const BodyView* body = find_body(snapshot, mark.body);
    if (body == nullptr || snapshot.time < mark.from || snapshot.time >= mark.to) continue;
    const Vec2d from = mark.point ? to_world(body->pose, *mark.point) : body->state.center;
    views.push_back({mark.of, from, from + mark.scale * quantity(snapshot, *body, mark), body->id});
  }
  return views;
}

/// From the centre of mass to the farthest point of the body, m.
double reach(const Snapshot& snapshot, const BodyView& body) {
  double farthest = 0;
  for (std::uint32_t s = 0; s < body.shape_count; ++s) {
    const ShapeView& shape = snapshot.shapes[body.first_shape + s];
    for (std::uint32_t p = 0; p < shape.point_count; ++p) {
      const Vec2d point = to_world(body.pose, snapshot.points[shape.first_point + p]);
      farthest = std::max(farthest, distance(point, body.state.center) + shape.radius);
    }
  }
  return farthest;
}

std::vector<LabelView> labels(const Picture& picture, const Snapshot& snapshot) {
  std::vector<LabelView> views;
  for (const Label& label : picture.labels) {
    const BodyView* body = find_body(snapshot, label.body);
    if (body != nullptr) views.push_back({body->state.center, reach(snapshot, *body), label.text, body->id});
  }
  return views;
}

/// Comes and goes within 0.3 s, or within half the time it has.
double strength(const Highlight& highlight, double time) {
  const double ease = std::min(0.3, 0.5 * (highlight.to - highlight.from));
  return std::min(eased((time - highlight.from) / ease), eased((highlight.to - time) / ease));
}

/// Where a highlight is, unless it is of a whole body; nothing when what it shows is gone.
std::optional<HighlightView> view_of(const Highlight& highlight, const Snapshot& snapshot) {
  HighlightView view{highlight.body.value_or(BodyId::world), highlight.at, highlight.radius, 0, highlight.text};
  if (highlight.body) {
    const BodyView* body = find_body(snapshot, *highlight.body);
    if (body == nullptr) return std::nullopt;
    if (highlight.point) view.at = to_world(body->pose, *highlight.point);
  } else if (highlight.joint) {
    const auto joint = std::find_if(snapshot.joints.begin(), snapshot.joints.end(),
                                    [&](const JointView& j) { return j.id == *highlight.joint && !j.broken; });
    if (joint == snapshot.joints.end()) return std::nullopt;
    view.at = 0.5 * (joint->anchor_a + joint->anchor_b);
  }
  return view;
}

std::vector<HighlightView> highlights(const Picture& picture, const Snapshot& snapshot) {
  std::vector<HighlightView> views;
  for (const Highlight& highlight : picture.highlights) {
    if (snapshot.time < highlight.from || snapshot.time > highlight.to) continue;
    auto view = view_of(highlight, snapshot);
    if (!view) continue;
    view->strength = strength(highlight, snapshot.time);
    if (view->at && view->radius == 0) view->radius = 0.035 * picture.view.height;
    views.push_back(*view);
  }
  return views;
}

/// Those that are not there yet.
void add_new(const std::vector<CaptionView>& more, std::vector<CaptionView>& captions) {
  for (const CaptionView& caption : more) {
    const bool said = std::any_of(captions.begin(), captions.end(), [&](const CaptionView& other) {
      return other.text == caption.text && other.at == caption.at;
    });
    if (!said) captions.push_back(caption);
  }
}

}  // namespace

std::vector<CaptionView> captions_at(const Scenario& scenario, std::int64_t tick) {
  const int rate = scenario.scene.rate;
  std::vector<CaptionView> views;
  for (const Caption& caption : scenario.picture.captions) {
    const bool shows = tick_at(caption.from, rate) <= tick && tick < tick_at(caption.to, rate);
    if (shows) views.push_back({caption.text, caption.at, caption.place});
  }
  for (const auto& pane : scenario.other_panes)
    add_new(captions_at(*pane, tick * pane->scene.rate / rate), views);  // frames lie on ticks of all panes
  return views;
}

void add_pane(Frame pane, Frame& frame) {
  add_new(pane.captions, frame.captions);
  frame.bands = {frame.bands.above || pane.bands.above, frame.bands.below || pane.bands.below};
  frame.other_panes.push_back(std::move(pane));
}

double usual_force_scale(const Scenario& scenario) {
  constexpr double earth = 9.81;
  double mass = 0;
  int count = 0;
  for (const BodyDef& body : scenario.scene.bodies) {
    if (body.type != BodyType::dynamic) continue;
    mass += initial_state(body).mass;
    ++count;
  }
  const double gravity = length(scenario.scene.gravity);
  const double weight = (count > 0 && mass > 0 ? mass / count : 1) * (gravity > 0 ? gravity : earth);
  const double share = std::clamp(0.3 / std::sqrt(std::max(1, count)), 0.02, 0.15);
  return share * scenario.picture.view.height / weight;
}

Frame make_frame(const Scenario& scenario, const Recorder& recorder, Snapshot snapshot, std::int64_t index) {
  Frame frame;
  frame.index = index;
  frame.view = camera_view(scenario, recorder, snapshot);
  frame.layers = layers_at(scenario.picture, snapshot.tick, scenario.scene.rate);
  frame.force_scale = scenario.picture.force_scale;
  frame.energy = recorder.energy();
  frame.trails = recorder.trails(snapshot);
  frame.ghosts = recorder.ghosts();
  frame.arrows = arrows(scenario.picture, snapshot);
  frame.labels = labels(scenario.picture, snapshot);
  frame.highlights = highlights(scenario.picture, snapshot);
  frame.captions = captions_at(scenario, snapshot.tick);
  frame.plots = recorder.plots();
  if (!scenario.stories.empty()) frame.demonstration = view_of(scenario.stories, snapshot.time);
  frame.pane_title = scenario.pane_title;
  for (const Caption& caption : scenario.picture.captions)
    (is_at_top(caption.at) ? frame.bands.above : frame.bands.below) = true;
  frame.snapshot = std::move(snapshot);
  return frame;
}

}  // namespace proofreel
