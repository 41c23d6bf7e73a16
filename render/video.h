#pragma once

/// Films through FFmpeg's libraries. Nothing but render/video* includes libav*.

#include <memory>
#include <string>
#include <vector>

#include "render/sink.h"

namespace proofreel {

/// True for the endings of films that can be made: .mp4 .mkv .webm .mov .gif .apng.
bool is_film_ending(const std::string& ending);

/// Delays in a GIF are whole hundredths of a second, and players take one of them for ten.
inline constexpr int most_gif_fps = 50;

/// A film file that appears when it is finished. An MP4 is written in fragments of about a second first, so that what a
/// killed run leaves behind still plays up to there, and then rearranged so that it starts playing while it loads.
/// Throws UsageError for odd sizes and unfitting settings, EnvironmentError when the encoder is missing.
std::unique_ptr<Sink> make_video_sink(const std::string& path, const FilmSettings& settings);

/// One encoder a film may need, for people who ask what works here.
struct VideoEncoder {
  std::string name;     ///< FFmpeg's: "libx264"
  std::string purpose;  ///< "H.264 (.mp4, .mkv)"
  bool available = false;
};
std::vector<VideoEncoder> video_encoders();

/// Throws EnvironmentError that names the package to install when FFmpeg here has no encoder of this name.
void require_encoder(const std::string& name);

}  // namespace proofreel
