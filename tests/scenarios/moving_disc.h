#pragma once

#include "scene_text.h"

namespace proofreel {

/// A disc `b` of 2 kg that flies right at 1 m/s in a view ten metres high, for ten seconds of 100 ticks and 50 frames,
/// and what `text` adds.
inline FakeRun run(const std::string& text) {
  return FakeRun(
      "scenario{duration=10, rate=100, fps=50, view={center={0, 5}, height=10}}\n"
      "local b = body{velocity={1, 0}, mass=2, shape=circle{radius=0.5}}\n" +
      text);
}

/// The picture at a tick, as film frame 7.
inline Frame frame_at(FakeRun& r, std::int64_t tick) {
  r.until(tick);
  return r.runner->frame(7);
}

}  // namespace proofreel
