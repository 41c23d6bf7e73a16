#pragma once

/// What `render` is asked for, and what it makes of it.

#include <optional>
#include <string>

#include "cli/options.h"
#include "render/film.h"
#include "render/sink.h"
#include "scenarios/timeline.h"

namespace proofreel {

struct RenderOptions {
  CommonOptions common;
  std::string scenario;
  std::string out;
  std::string size;
  std::string frames;
  std::string layers;
  std::string theme;
  std::string quality = "final";
  std::optional<std::string> preset;
  std::optional<int> crf;
  std::optional<int> fps;
  std::optional<double> shutter;  ///< degrees
  std::string title_card;         ///< seconds; empty: none
  std::string contact_sheet;      ///< COLUMNSxROWS or "auto"; empty: none
  bool transparent = false;
  bool stills = false;
};

/// A scenario with the picture the options ask for, and which frames of it are wanted.
struct RenderJob {
  const RenderOptions& options;
  Scenario& scenario;
  FilmRequest request;
  FrameRange range;
  std::vector<FilmSection> sections;
};

/// Throw UsageError, before anything is drawn, for options that do not go together.
void render_pictures(RenderJob& job);
void render_contact_sheet(RenderJob& job);
void render_subtitles(RenderJob& job);
void render_svg(RenderJob& job);

}  // namespace proofreel
