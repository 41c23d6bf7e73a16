#include "render/exposure.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "engine/elementary.h"
#include "render/usage_error.h"
#include "scenarios/suggest.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

constexpr std::int64_t fewest_ticks = 4;
constexpr std::int64_t most_ticks_open = 65536;  // sums of 16-bit numbers stay within 32 bits
constexpr double full_circle = 360;

/// Whole ticks from 0 on that lie within the open shutter when the next frame is `way` ticks away.
std::int64_t ticks_open(double degrees, std::int64_t way) {
  return static_cast<std::int64_t>(std::ceil(degrees * static_cast<double>(way) / full_circle));
}

/// `way` in ticks of `scene`, which is the scenario or one of its panes.
[[noreturn]] void refuse_few(const Scenario& scene, double degrees, std::int64_t way, bool all_have_this_rate) {
  std::int64_t times = 2;
  while (ticks_open(degrees, times * way) < fewest_ticks) ++times;
  const std::int64_t ticks = ticks_open(degrees, way);
  const std::string rate = "rate=" + std::to_string(times * scene.scene.rate);
  throw UsageError("--shutter mixes the pictures of at least " + std::to_string(fewest_ticks) + " ticks, and at " +
                   std::to_string(scene.scene.rate) + " ticks per second only " + std::to_string(ticks) +
                   (ticks == 1 ? " lies" : " lie") + " within the shutter of a frame: " +
                   (all_have_this_rate ? "--set " + rate : rate + " in pane " + quote(scene.pane_title)) + " works.");
}

/// The scene whose ticks are the longest: there it is seen first that pictures stand beside each other.
const Scenario& slowest_scene(const Scenario& scenario) {
  const Scenario* slowest = &scenario;
  for (const auto& pane : scenario.other_panes) {
    if (pane->scene.rate < slowest->scene.rate) slowest = pane.get();
  }
  return *slowest;
}

bool have_one_rate(const Scenario& scenario) {
  return std::all_of(scenario.other_panes.begin(), scenario.other_panes.end(),
                     [&](const auto& pane) { return pane->scene.rate == scenario.scene.rate; });
}

/// Light of an sRGB value (IEC 61966-2-1), 0..65535; `value` 0..255, also between whole numbers.
double light_of(double value) {
  const double v = value / 255;
  const double light = v <= 0.04045 ? v / 12.92 : elementary::pow((v + 0.055) / 1.055, 2.4);
  return 65535 * light;
}

struct Tables {
  std::array<std::uint16_t, 256> light{};
  std::array<std::uint8_t, 65536> value{};  ///< the nearest by value, not by light

  Tables() {
    for (unsigned i = 0; i < 256; ++i) light[i] = static_cast<std::uint16_t>(std::lround(light_of(i)));
    std::size_t from = 0;
    for (unsigned i = 0; i < 256; ++i) {
      const std::size_t end = i == 255 ? value.size() : static_cast<std::size_t>(std::ceil(light_of(i + 0.5)));
      for (; from < end; ++from) value[from] = static_cast<std::uint8_t>(i);
    }
  }
};

const Tables& tables() {
  static const Tables made;
  return made;
}

}  // namespace

std::vector<std::int64_t> exposures(const Scenario& scenario, const std::vector<std::int64_t>& timeline,
                                    double degrees) {
  const Scenario& slowest = slowest_scene(scenario);
  std::vector<std::int64_t> open;
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const std::int64_t next = i + 1 < timeline.size() ? timeline[i + 1] : film_end(scenario);
    const std::int64_t way = next - timeline[i];
    const std::int64_t ticks = ticks_open(degrees, way);
    const std::int64_t slowest_way = std::max<std::int64_t>(1, way * slowest.scene.rate / scenario.scene.rate);
    if (way > 0 && ticks_open(degrees, slowest_way) < fewest_ticks)
      refuse_few(slowest, degrees, slowest_way, have_one_rate(scenario));
    if (ticks > most_ticks_open)
      throw UsageError("--shutter would mix " + std::to_string(ticks) + " pictures for a frame, of at most " +
                       std::to_string(most_ticks_open) + ": choose a lower rate or a narrower shutter.");
    open.push_back(way > 0 ? ticks : 1);
  }
  return open;
}

void Exposure::add(const Image& image) {
  const std::size_t pixels = image.rgba.size() / 4;
  if (pictures_ == 0) sums_.assign(3 * pixels, 0);
  assert(sums_.size() == 3 * pixels && pictures_ < most_ticks_open);
  const std::array<std::uint16_t, 256>& light = tables().light;
  const std::uint8_t* from = image.rgba.data();
  std::uint32_t* sum = sums_.data();
  for (std::size_t i = 0; i < pixels; ++i, from += 4, sum += 3) {
    sum[0] += light[from[0]];
    sum[1] += light[from[1]];
    sum[2] += light[from[2]];
  }
  ++pictures_;
}

void Exposure::develop(Image& image) {
  assert(image.rgba.size() / 4 * 3 == sums_.size() && pictures_ > 0);
  const std::array<std::uint8_t, 65536>& value = tables().value;
  const std::uint32_t half = pictures_ / 2;
  std::uint8_t* to = image.rgba.data();
  for (std::size_t i = 0; i < sums_.size(); i += 3, to += 4) {
    for (std::size_t c = 0; c < 3; ++c) to[c] = value[(sums_[i + c] + half) / pictures_];
    to[3] = 255;
  }
  pictures_ = 0;
}

}  // namespace proofreel
