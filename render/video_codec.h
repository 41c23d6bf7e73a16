#pragma once

/// Which codec a film is in, by the ending of its name and its quality, and how each is set up. For render/video*.cpp
/// only.

#include <cstdint>
#include <string>

#include "render/sink.h"
#include "render/video_av.h"

namespace proofreel::av {

enum class FilmCodec : std::uint8_t {
  h264,    ///< .mp4, .mkv: what plays everywhere
  vp9,     ///< .webm: for pages; may be transparent
  prores,  ///< .mov: ProRes 4444, for people who cut; may be transparent
  qtrle,   ///< .mov, lossless: QuickTime Animation; may be transparent
  ffv1,    ///< .mkv, lossless; may be transparent
  apng,    ///< .apng: lossless, loops; may be transparent
  gif      ///< .gif: 255 colours, loops; pixels are transparent or not
};

/// `ending` is that of a film: ".mp4" and so on.
FilmCodec codec_of(const std::string& ending, Quality quality);
/// FFmpeg's name of the encoder.
const char* encoder_name(FilmCodec codec);
/// FFmpeg's name of the container.
std::string container_name(const std::string& ending);
/// Whether colour is stored at half the resolution, so that sides have to be even.
bool halves_colour(FilmCodec codec);
bool may_be_transparent(FilmCodec codec);
/// --preset and --crf speak to x264, --crf to VP9 too.
bool takes_preset(FilmCodec codec);
bool takes_crf(FilmCodec codec, Quality quality);
int highest_crf(FilmCodec codec);

/// Pixel format, colour tags, quality, distance of key frames.
void set_up(AVCodecContext& context, FilmCodec codec, const FilmSettings& settings);

}  // namespace proofreel::av
