#include "lab/peers/box2d_shapes.h"

#include <algorithm>

#include "engine/polygon.h"
#include "lab/peers/peer_problems.h"

namespace proofreel {
namespace {

using Corners = std::vector<Vec2d>;

constexpr std::size_t most_corners = b2_maxPolygonVertices;
/// Box2D makes one of corners that are nearer to each other, and stops the program when too few are left.
constexpr double least_distance = 0.5 * static_cast<double>(b2_linearSlop);
constexpr double least_area = 1e-6;  ///< m^2; Box2D stops the program not far below
constexpr double skin = static_cast<double>(b2_polygonRadius);

/// Chords from the first corner.
std::vector<Corners> cut(const Corners& corners) {
  std::vector<Corners> pieces;
  for (std::size_t begin = 1; begin + 1 < corners.size(); begin += most_corners - 2) {
    const std::size_t end = std::min(begin + most_corners - 1, corners.size());
    Corners piece{corners[0]};
    piece.insert(piece.end(), corners.begin() + static_cast<std::ptrdiff_t>(begin),
                 corners.begin() + static_cast<std::ptrdiff_t>(end));
    pieces.push_back(piece);
  }
  return pieces;
}

b2CircleShape disc(Vec2d center, double radius) {
  b2CircleShape shape;
  shape.m_p = to_b2(center);
  shape.m_radius = static_cast<float>(radius);
  return shape;
}

b2PolygonShape polygon(const Corners& corners, double radius) {
  std::vector<b2Vec2> points;
  for (const Vec2d corner : corners) points.push_back(to_b2(corner));
  b2PolygonShape shape;
  shape.Set(points.data(), static_cast<int32>(points.size()));
  shape.m_radius = static_cast<float>(radius);
  return shape;
}

/// What lies between a capsule's two discs, rounded by half its radius, so that it has no skin that stands out.
Corners capsule_middle(const ShapeDef& def) {
  const Vec2d a = def.points[0];
  const Vec2d b = def.points[1];
  const Vec2d out = 0.5 * def.radius * perp(normalized(b - a));
  return {a - out, b - out, b + out, a + out};
}

class FixtureMaker {
 public:
  FixtureMaker(b2Body& body, const BodyDef& def, std::vector<Box2dFixture>& fixtures)
      : body_(body), sensor_(def.sensor), fixtures_(fixtures) {}

  void add(const ShapeDef& def) {
    if (def.points.size() == 1) {
      add(disc(def.points[0], def.radius), 0, def);
    } else if (def.points.size() > 2) {
      add_polygon(def);
    } else if (def.radius > 0) {
      add(polygon(capsule_middle(def), 0.5 * def.radius), 0, def);
      for (const Vec2d end : def.points) add(disc(end, def.radius), 0, def);
    } else {
      b2EdgeShape edge;
      edge.SetTwoSided(to_b2(def.points[0]), to_b2(def.points[1]));
      add(edge, skin, def);
    }
  }

 private:
  void add_polygon(const ShapeDef& def) {
    const double radius = std::max(def.radius, skin);
    for (const Corners& piece : cut(def.points)) add(polygon(piece, radius), radius - def.radius, def);
  }

  void add(const b2Shape& shape, double extra, const ShapeDef& def) {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    // Box2D mixes as we do: sqrt(a b) and max(a, b).
    fixture.friction = static_cast<float>(def.friction.sliding);
    fixture.restitution = static_cast<float>(def.restitution);
    fixture.isSensor = sensor_;
    fixture.userData.pointer = fixtures_.size();
    fixtures_.push_back({extra, def.surface_speed});
    body_.CreateFixture(&fixture);
  }

  b2Body& body_;
  bool sensor_;
  std::vector<Box2dFixture>& fixtures_;
};

bool has_close_corners(const Corners& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (distance(corners[i], corners[j]) < 1.01 * least_distance) return true;
    }
  }
  return false;
}

Problem problem_with_corners(const Corners& corners) {
  if (has_close_corners(corners)) return "it has corners nearer than 2.5 mm to each other, which Box2D makes one";
  for (const Corners& piece : cut(corners)) {
    if (area_of(piece) < least_area) return "it has a part smaller than 1 mm^2, too small for Box2D";
  }
  return {};
}

}  // namespace

void add_fixtures(b2Body& body, const BodyDef& def, std::vector<Box2dFixture>& fixtures) {
  FixtureMaker maker(body, def, fixtures);
  for (const ShapeDef& shape : def.shapes) maker.add(shape);
}

Problem problem_for_box2d(const BodyDef& body) {
  for (const ShapeDef& shape : body.shapes) {
    if (shape.points.size() == 1) continue;
    if (shape.points.size() > 2) {
      if (const Problem problem = problem_with_corners(shape.points)) return problem;
    } else if (shape.radius > 0) {
      if (const Problem problem = problem_with_corners(capsule_middle(shape))) return problem;
    } else if (body.type != BodyType::fixed) {
      return "it is a segment that moves, and segments do not meet each other in Box2D; make it a capsule";
    }
  }
  return {};
}

}  // namespace proofreel
