#pragma once

/// Where finished pictures go: files of several kinds, told apart by the ending of their name, or standard output.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/image.h"
#include "render/usage_error.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// Takes the pictures of one film in order, all of one size. One destroyed before `finish` leaves nothing under the
/// final name. All functions may throw EnvironmentError.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual void frame(const Image& image) = 0;
  /// To be called once, after the last picture; only now the output appears under its name.
  virtual void finish() = 0;
};

/// How well a film is encoded. draft: H.264 veryfast, crf 26, VP9 realtime, crf 36; final: H.264 medium, crf 18, tuned
/// for drawn pictures, VP9 crf 22, ProRes 4444; lossless: every pixel as drawn in .mkv (FFV1) and .mov (QuickTime
/// Animation), exact after the colours were halved in resolution in .mp4 and .webm. .apng is always lossless, .gif
/// never.
enum class Quality : std::uint8_t { draft, final, lossless };
std::optional<Quality> quality_named(std::string_view name);

/// A part of a film that players can jump to; the last frame is included.
struct Chapter {
  std::string name;
  std::int64_t first = 0;
  std::int64_t last = 0;
};

struct FilmSettings {
  Size size;
  int fps = 60;
  Quality quality = Quality::final;
  std::optional<std::string> preset;   ///< x264's, instead of the quality's
  std::optional<int> crf;              ///< constant rate factor, 0..51 (VP9: 63), instead of the quality's
  int threads = 0;                     ///< of the encoder; 0: as many as it likes
  bool transparent = false;            ///< the pictures' alpha is kept
  std::vector<Chapter> chapters = {};  ///< kept in .mp4, .mkv, .webm and .mov
  std::int64_t first_frame = 0;        ///< number of the first picture, in the names of a sequence
};

/// ".mp4" of "films/a.mp4"; empty when there is none.
std::string ending_of(const std::string& path);

/// True when `out` holds one picture rather than a film: NAME.png without a number in it.
bool is_single_picture(const std::string& out);
/// Throws UsageError where a name that is not of PNG pictures has a place for frame numbers (%d).
void refuse_numbers(const std::string& out);

/// The sink `out` asks for: NAME.png keeps the last picture it is given, NAME%04d.png writes one file per picture
/// (numbered by film frame), .mp4, .webm, .gif, .apng, .mov and .mkv are films, .hash is one line of frame number and
/// pixel hash per picture, and
/// - is raw RGBA on standard output. Throws UsageError for other endings, sizes a film cannot have and settings that do
/// not fit, before anything is drawn or written.
std::unique_ptr<Sink> make_sink(const std::string& out, const FilmSettings& settings);

}  // namespace proofreel
