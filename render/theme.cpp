#include "render/theme.h"

#include <algorithm>
#include <cmath>

namespace proofreel {
namespace {

constexpr Color rgb(unsigned value, unsigned alpha = 255) {
  return {static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U),
          static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(alpha)};
}

constexpr Tone tone(unsigned fill, unsigned outline) { return {rgb(fill), rgb(outline)}; }

const Palette light_palette{
    .background = rgb(0xFBFAF6),
    .ink = rgb(0x1F2A36),
    .quiet_ink = rgb(0x66717D),
    .plate = rgb(0xFFFFFF, 240),
    .plate_edge = rgb(0xD6D3CA),
    .grid = rgb(0xEAE8E1),
    .grid_axis = rgb(0xCFCCC2),
    .water = rgb(0x9FD3D6, 105),
    .water_line = rgb(0x4C9AA3, 150),
    .dynamic = tone(0x78AEE0, 0x225684),
    .kinematic = tone(0x57B894, 0x0E5A43),
    .fixed = tone(0xE6D6B0, 0x8C7843),
    .contact = rgb(0xC2127C),
    .tree = rgb(0x5B3F9E),
    .box = rgb(0xB8660B),
    .joint = rgb(0x2B3440),
    .vectors = {rgb(0x00715A), rgb(0xC8500A), rgb(0x6A3FA8), rgb(0x9A6A00), rgb(0xC2127C), rgb(0x1F2A36)},
    .curves = {rgb(0x0F66A8), rgb(0xCE5A0B), rgb(0x17876A), rgb(0xB2387F), rgb(0x8A6A00), rgb(0x3E4A57)},
    .forces = {rgb(0xC2127C), rgb(0xC8500A), rgb(0x00715A)},
    .islands = {tone(0x78AEE0, 0x225684), tone(0xF2B266, 0x8A4E0C), tone(0xA3AFBB, 0x3E4A57), tone(0xBBA2E2, 0x4E3486),
                tone(0xD98AA6, 0x852349), tone(0xBFD06A, 0x58660E), tone(0x8FD3DC, 0x1B6570)},
    .highlight = rgb(0xE8A200),
};

const Palette dark_palette{
    .background = rgb(0x17222E),
    .ink = rgb(0xEAF0F5),
    .quiet_ink = rgb(0x9AA9B7),
    .plate = rgb(0x223140, 240),
    .plate_edge = rgb(0x3A4C5E),
    .grid = rgb(0x223040),
    .grid_axis = rgb(0x3B4E61),
    .water = rgb(0x2F7F8C, 80),
    .water_line = rgb(0x63B6C2, 150),
    .dynamic = tone(0x5FA3DE, 0x2A5F92),
    .kinematic = tone(0x4CBE97, 0x1C6B53),
    .fixed = tone(0xC9B78A, 0x7B6C45),
    .contact = rgb(0xFF6FC0),
    .tree = rgb(0xB7A0F5),
    .box = rgb(0xF0A24A),
    .joint = rgb(0xE3EAF0),
    .vectors = {rgb(0x6FE3C1), rgb(0xFF9A55), rgb(0xC9A8FF), rgb(0xF2CF5B), rgb(0xFF6FC0), rgb(0xEAF0F5)},
    .curves = {rgb(0x6DB6F2), rgb(0xFF9A55), rgb(0x6FE3C1), rgb(0xF593CC), rgb(0xF2CF5B), rgb(0xD5DDE5)},
    .forces = {rgb(0xFF6FC0), rgb(0xFFA45E), rgb(0x6FE3C1)},
    .islands = {tone(0x5FA3DE, 0x2A5F92), tone(0xE3A052, 0x8A5514), tone(0x93A1AE, 0x414D59), tone(0xAC93E0, 0x5B4496),
                tone(0xD27F9E, 0x873556), tone(0xB3C659, 0x647318), tone(0x7CCBD6, 0x2B727D)},
    .highlight = rgb(0xFFD45C),
};

const Palette print_palette{
    .background = rgb(0xFFFFFF),
    .ink = rgb(0x000000),
    .quiet_ink = rgb(0x4A4A4A),
    .plate = rgb(0xFFFFFF, 242),
    .plate_edge = rgb(0x9A9A9A),
    .grid = rgb(0xE6E6E6),
    .grid_axis = rgb(0xBDBDBD),
    .water = rgb(0xA8A8A8, 35),
    .water_line = rgb(0x6E6E6E),
    .dynamic = tone(0xE2E2E2, 0x1E1E1E),
    .kinematic = tone(0xB8B8B8, 0x1E1E1E),
    .fixed = tone(0x8E8E8E, 0x1E1E1E),
    .contact = rgb(0x000000),
    .tree = rgb(0x3C3C3C),
    .box = rgb(0x6E6E6E),
    .joint = rgb(0x000000),
    .vectors = {rgb(0x000000), rgb(0x3A3A3A), rgb(0x000000), rgb(0x3A3A3A), rgb(0x000000), rgb(0x000000)},
    .curves = {rgb(0x000000), rgb(0x6E6E6E), rgb(0x505050), rgb(0x3C3C3C), rgb(0x8C8C8C), rgb(0x6E6E6E)},
    .forces = {rgb(0x000000), rgb(0x8C8C8C), rgb(0x505050)},
    .islands = {tone(0xF0F0F0, 0x1E1E1E), tone(0xB4B4B4, 0x1E1E1E), tone(0xD6D6D6, 0x1E1E1E), tone(0x969696, 0x1E1E1E),
                tone(0xE4E4E4, 0x1E1E1E), tone(0xA4A4A4, 0x1E1E1E), tone(0xC6C6C6, 0x1E1E1E)},
    .highlight = rgb(0x4A4A4A),
    .gray = true,
};

/// Its brightness as the eye weighs it (ITU-R BT.709).
Color grayed(Color color) {
  const int value = (2126 * color.r + 7152 * color.g + 722 * color.b + 5000) / 10000;
  const auto gray = static_cast<std::uint8_t>(value);
  return {gray, gray, gray, color.a};
}

Tone own_tone(const Palette& palette, const BodyView& body) {
  const Color fill = palette.gray ? grayed(rgb(body.color)) : rgb(body.color);
  return {fill, mixed(fill, {0, 0, 0, 255}, 0.5)};
}

const Tone& type_tone(const Palette& palette, BodyType type) {
  if (type == BodyType::fixed) return palette.fixed;
  return type == BodyType::kinematic ? palette.kinematic : palette.dynamic;
}

}  // namespace

const Palette& palette_of(Theme theme) {
  if (theme == Theme::dark) return dark_palette;
  return theme == Theme::print ? print_palette : light_palette;
}

Tone asleep(Tone tone, const Palette& palette) {
  return {mixed(tone.fill, palette.background, 0.55), mixed(tone.outline, palette.background, 0.35)};
}

Tone tone_of(const Palette& palette, const BodyView& body) {
  Tone tone = body.has_color ? own_tone(palette, body) : type_tone(palette, body.type);
  if (body.asleep) tone = asleep(tone, palette);
  if (body.sensor) tone.fill.a = 48;
  return tone;
}

Sizes sizes_of(int width_px, int height_px) {
  static constexpr int readable = 9;
  const double of_area = std::floor(0.75 * std::sqrt(static_cast<double>(width_px) * height_px));
  const int height = std::min({width_px, height_px, static_cast<int>(of_area)});
  const double unit = height / 720.0;
  const auto part = [height](int parts) { return std::max(readable, (height + parts / 2) / parts); };
  return {.unit = unit,
          .outline = std::max(1.25, 2 * unit),
          .thin = std::max(1.0, 1.25 * unit),
          .margin = 0.04 * height,
          .title = part(18),
          .text = part(28),
          .small = part(40)};
}

}  // namespace proofreel
