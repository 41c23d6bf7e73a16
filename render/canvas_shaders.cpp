#include "render/canvas_shaders.h"

#include <array>

namespace proofreel {
namespace {

constexpr std::array<std::size_t, shape_kind_count> instance_vectors{6, 10, 16, 8, 14, 6, 4};

const char* const header = "#version 330 core\n";

/// The vec4 `index` of the fragment's instance.
std::string input(std::size_t index) { return std::string("v").append(std::to_string(index)); }

/// Component `index` of the vec4 from `first` on.
std::string scalar(std::size_t first, std::size_t index) {
  return input(first + index / 4) + "." + std::string(1, "xyzw"[index % 4]);
}

/// Pair `index` of the vec4 from `first` on.
std::string pair(std::size_t first, std::size_t index) {
  return input(first + index / 2) + (index % 2 == 0 ? ".xy" : ".zw");
}

/// `d` is the signed distance to the edge in pixels, negative inside.
const char* const paint = R"(
vec4 paint(float d) {
  float cover = clamp(0.5 - d, 0.0, 1.0);
  float edge = clamp(0.5 + d + v1.z, 0.0, 1.0);
  return (v2 + (v3 - v2) * edge) * cover;
}
)";

const char* const box_main = R"(
void main() {
  vec2 p = gl_FragCoord.xy - v4.xy;
  float x = abs(p.x * v4.z + p.y * v4.w) - v5.x;
  float y = abs(p.y * v4.z - p.x * v4.w) - v5.y;
  float u = max(x, 0.0);
  float v = max(y, 0.0);
  color = paint(sqrt(u * u + v * v) + min(max(x, y), 0.0) - v1.w);
}
)";

std::string edges_main(std::size_t count) {
  const std::size_t offsets = 4 + count / 2;
  std::string text = "void main() {\n  vec2 p = gl_FragCoord.xy - v0.xy;\n  float d = -1.0e30;\n";
  for (std::size_t i = 0; i < count; ++i) {
    const std::string normal = pair(4, i);
    text += "  d = max(d, p.x * " + normal + ".x + p.y * " + normal + ".y - " + scalar(offsets, i) + ");\n";
  }
  return text + "  color = paint(d);\n}\n";
}

/// Outside, the distance to the nearest point of the polygon; inside, to the nearest edge's line.
std::string rounded_main(std::size_t count) {
  std::string text = R"(
float nearest = 1.0e30;
float side = -1.0e30;
void edge(vec2 p, vec2 a, vec2 b) {
  vec2 t = b - a;
  vec2 q = p - a;
  float tt = t.x * t.x + t.y * t.y;
  float along = clamp((q.x * t.x + q.y * t.y) / tt, 0.0, 1.0);
  float x = q.x - along * t.x;
  float y = q.y - along * t.y;
  nearest = min(nearest, x * x + y * y);
  side = max(side, (t.y * q.x - t.x * q.y) / sqrt(tt));
}
void main() {
  vec2 p = gl_FragCoord.xy - v0.xy;
)";
  for (std::size_t i = 0; i < count; ++i) {
    text += "  edge(p, " + pair(4, i) + ", " + pair(4, (i + 1) % count) + ");\n";
  }
  return text + "  color = paint((side > 0.0 ? sqrt(nearest) : side) - v1.w);\n}\n";
}

/// Neighbours compute the sign of the same expression at their common joint, so each pixel belongs to one of them and
/// a translucent stroke has no beads. Colours go from v2 at the start to v3 at the end.
const char* const stroke_main = R"(
void main() {
  vec2 a = gl_FragCoord.xy - v4.xy;
  vec2 b = gl_FragCoord.xy - v4.zw;
  float after_start = a.x * v5.x + a.y * v5.y;
  float after_end = b.x * v5.z + b.y * v5.w;
  vec2 t = v4.zw - v4.xy;
  float along = clamp((a.x * t.x + a.y * t.y) / (t.x * t.x + t.y * t.y), 0.0, 1.0);
  float x = a.x - along * t.x;
  float y = a.y - along * t.y;
  float cover = clamp(0.5 + v1.w - sqrt(x * x + y * y), 0.0, 1.0);
  bool mine = after_start >= 0.0 && after_end < v1.z;
  color = mine ? (v2 + (v3 - v2) * along) * cover : vec4(0.0);
}
)";

const char* const glyph_main = R"(
uniform sampler2D atlas;
void main() {
  color = v2 * texelFetch(atlas, ivec2(gl_FragCoord.xy + v3.xy), 0).r;
}
)";

/// What a shape covers at all is its owner's.
const char* const owners_main = R"(
#undef main
void main() {
  shade();
  if (color.a <= 0.0) discard;
  number = vec4(v2.xyz, 1.0);
}
)";

std::string main_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::box:
      return std::string(paint) + box_main;
    case ShapeKind::edges8:
      return std::string(paint) + edges_main(8);
    case ShapeKind::edges16:
      return std::string(paint) + edges_main(16);
    case ShapeKind::rounded8:
      return std::string(paint) + rounded_main(8);
    case ShapeKind::rounded20:
      return std::string(paint) + rounded_main(20);
    case ShapeKind::stroke:
      return stroke_main;
    case ShapeKind::glyph:
      break;
  }
  return glyph_main;
}

}  // namespace

std::size_t vectors_per_instance(ShapeKind kind) { return instance_vectors[static_cast<std::size_t>(kind)]; }

std::string vertex_source(ShapeKind kind) {
  std::string text = header;
  std::string copies;
  for (std::size_t i = 0; i < vectors_per_instance(kind); ++i) {
    const std::string n = std::to_string(i);
    text += "layout(location = " + n + ") in vec4 a" + n + ";\nflat out vec4 v" + n + ";\n";
    copies += "  v" + n + " = a" + n + ";\n";
  }
  return text + R"(uniform vec2 to_clip;
void main() {
  int corner = gl_VertexID < 3 ? gl_VertexID : 6 - gl_VertexID;
  float x = (corner & 1) == 0 ? -a1.x : a1.x;
  float y = (corner & 2) == 0 ? -a1.y : a1.y;
  vec2 p = a0.xy + vec2(x * a0.z - y * a0.w, x * a0.w + y * a0.z);
  gl_Position = vec4(p * to_clip - 1.0, 0.0, 1.0);
)" + copies +
         "}\n";
}

std::string fragment_source(ShapeKind kind, DrawMode mode) {
  std::string text = header;
  for (std::size_t i = 0; i < vectors_per_instance(kind); ++i) text += "flat in vec4 v" + std::to_string(i) + ";\n";
  if (mode == DrawMode::colors) return text + "out vec4 color;\n" + main_of(kind);
  return text + "out vec4 number;\nvec4 color;\n#define main shade\n" + main_of(kind) + owners_main;
}

}  // namespace proofreel
