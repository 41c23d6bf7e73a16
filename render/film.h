#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "render/context.h"
#include "render/sink.h"
#include "render/title_card.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// Film frames `first` to `last`, both included.
struct FrameRange {
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::vector<std::int64_t> frames() const;
};

/// Called on the caller's thread after every frame handed on; may throw to stop the film.
using Progress = std::function<void(std::int64_t done, std::int64_t total)>;

/// What of a scenario is filmed, and with what means.
struct FilmRequest {
  std::vector<std::int64_t> timeline;  ///< the scenario's (film_timeline)
  std::vector<std::int64_t> frames;    ///< of the timeline, ascending
  std::optional<GlBackend> gl;
  bool transparent = false;
  int threads = 0;  ///< cores to share between drawing and encoding; 0: as many as the machine has
  std::vector<std::int64_t> exposures = {};  ///< ticks each frame of the timeline is exposed (exposures); empty: one
  std::optional<TitleCard> title_card = {};  ///< shown before the first frame
  std::int64_t card_pictures = 0;            ///< so many pictures long; at least one when there is a card
};

/// Runs the scenario up to the one frame of the request and draws it as SVG, without OpenGL.
std::string svg_of(Scenario& scenario, const FilmRequest& request);

/// Runs the scenario up to the last of the frames and films them in the scenario's size, theme and layers
/// into `sink`, which is finished at the end. What lies between is stepped through but not drawn. Stepping (on
/// the calling thread, where the script lives), drawing and encoding go on at the same time, a few frames apart. The
/// first error of any of them stops all and is thrown here; the sink is then left unfinished.
void render_film(Scenario& scenario, const FilmRequest& request, Sink& sink, const Progress& progress);

}  // namespace proofreel
