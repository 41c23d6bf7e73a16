#pragma once

#include <string>
#include <vector>

#include "render/image.h"

namespace proofreel {

/// A film file as a player sees it.
struct DecodedFilm {
  std::string container;  ///< FFmpeg's name of it
  std::string codec;
  std::string pixel_format;
  std::string range, matrix, primaries, transfer;  ///< the colour tags, as FFmpeg calls them
  double fps = 0;
  double duration_s = 0;
  double start_s = 0;
  std::vector<double> times_s;  ///< when each frame is shown
  std::vector<int> key_frames;  ///< which frames can be jumped to
  std::vector<Image> frames;    ///< back in RGB, by the film's own tags
  bool index_first = false;     ///< MP4: what a player needs to know stands before the pictures
};

/// A part of a film that players can jump to.
struct FilmChapter {
  std::string name;
  double start_s = 0;
  double end_s = 0;
};
std::vector<FilmChapter> chapters_in(const std::string& path);

/// Decodes all of it. Throws std::runtime_error at the first thing that does not decode.
DecodedFilm decode_film(const std::string& path);

}  // namespace proofreel
