#pragma once

/// What a film has written in it, as text with times: SubRip (.srt), which players and video pages show or read out.

#include <cstdint>
#include <string>
#include <vector>

#include "render/film.h"
#include "scenarios/timeline.h"

namespace proofreel {

/// Lines that are shown together, from one picture of the film to another, which is included.
struct Cue {
  std::int64_t first = 0;
  std::int64_t last = 0;
  std::vector<std::string> lines;
};

/// Runs the scenario without drawing it. Captions are read from the top of the picture down, in a lecture film after
/// the caption of the step; formulas become plain text. Where a section begins, a cue begins with its name as first
/// line; one without captions shows the name for three seconds. Pictures count from the title card's first.
std::vector<Cue> subtitles_of(Scenario& scenario, const FilmRequest& request, const std::vector<FilmSection>& sections,
                              const Progress& progress);

/// Cues of a film of that many pictures per second as a SubRip file.
std::string srt_text(const std::vector<Cue>& cues, int fps);

}  // namespace proofreel
