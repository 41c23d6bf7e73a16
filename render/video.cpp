#include "render/video.h"

#include <algorithm>
#include <array>

#include "render/output_file.h"
#include "render/palette.h"
#include "render/png.h"
#include "render/video_encoder.h"
#include "render/video_file.h"
#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

constexpr std::array<const char*, 10> x264_presets{"ultrafast", "superfast", "veryfast", "faster",   "fast",
                                                   "medium",    "slow",      "slower",   "veryslow", "placebo"};

void check_size(const std::string& path, Size size) {
  if (size.width_px % 2 == 0 && size.height_px % 2 == 0) return;
  const Size even{size.width_px + size.width_px % 2, size.height_px + size.height_px % 2};
  throw UsageError("A film needs an even width and height, because " + ending_of(path) +
                   " stores colour at half the resolution: " + path + " cannot be " + std::to_string(size.width_px) +
                   "x" + std::to_string(size.height_px) + ", but " + std::to_string(even.width_px) + "x" +
                   std::to_string(even.height_px) + " works.");
}

void check_preset(const std::string& preset) {
  if (std::find(x264_presets.begin(), x264_presets.end(), preset) != x264_presets.end()) return;
  std::string known;
  for (const char* name : x264_presets) known.append(known.empty() ? "" : ", ").append(name);
  throw UsageError("There is no preset \"" + preset + "\"; x264 has " + known + ".");
}

void check_crf(const std::string& path, av::FilmCodec codec, const FilmSettings& settings) {
  if (!settings.crf) return;
  if (!av::takes_crf(codec, settings.quality))
    throw UsageError("--crf is for .mp4, .webm and .mkv at other than lossless quality, which " + path + " is not.");
  const int most = av::highest_crf(codec);
  if (*settings.crf >= 0 && *settings.crf <= most) return;
  throw UsageError("--crf goes from 0 (best) to " + std::to_string(most) + ", not " + std::to_string(*settings.crf) +
                   ".");
}

void check_settings(const std::string& path, av::FilmCodec codec, const FilmSettings& settings) {
  if (settings.transparent && !av::may_be_transparent(codec)) {
    throw UsageError("H.264 knows no transparency: make " + path +
                     " a .webm, .mov, .apng, .gif or, with --quality lossless, .mkv.");
  }
  if (av::halves_colour(codec)) check_size(path, settings.size);
  if (settings.preset && !av::takes_preset(codec))
    throw UsageError("--preset is for films in H.264 (.mp4, .mkv), which " + path + " is not.");
  if (settings.preset) check_preset(*settings.preset);
  check_crf(path, codec, settings);
  if (codec == av::FilmCodec::gif && settings.fps > most_gif_fps) {
    throw UsageError("A GIF cannot show more than " + std::to_string(most_gif_fps) + " frames per second, so not " +
                     std::to_string(settings.fps) + ".");
  }
}

AVCodecParameters* parameters_of(const AVCodecContext& context) {
  AVCodecParameters* parameters = avcodec_parameters_alloc();
  av::check_allocated(parameters);
  avcodec_parameters_from_context(parameters, &context);
  return parameters;
}

struct FreeParameters {
  void operator()(AVCodecParameters* p) const { avcodec_parameters_free(&p); }
};

av::Writer writer_for(const OutputFile& file, const av::Encoder& encoder, const FilmSettings& settings) {
  const AVCodecContext& context = encoder.context();
  const std::unique_ptr<AVCodecParameters, FreeParameters> parameters(parameters_of(context));
  const auto layout = ending_of(file.path()) == ".mp4" ? av::Layout::fragmented_mp4 : av::Layout::plain;
  const bool is_fragmented = layout == av::Layout::fragmented_mp4;  // a track of chapters would end every fragment
  return {file.temporary_path(),
          file.path(),
          layout,
          {*parameters, context.time_base, context.framerate},
          is_fragmented ? std::vector<Chapter>{} : settings.chapters};
}

class VideoSink final : public Sink {
 public:
  VideoSink(const std::string& path, av::FilmCodec codec, const FilmSettings& settings)
      : encoder_(settings, codec),
        file_(path),
        writer_(writer_for(file_, encoder_, settings)),
        chapters_(settings.chapters) {}

  void frame(const Image& image) override {
    encoder_.encode(image, [this](AVPacket& packet) { writer_.write(packet); });
  }

  void finish() override {
    encoder_.flush([this](AVPacket& packet) { writer_.write(packet); });
    writer_.finish();
    if (ending_of(file_.path()) != ".mp4") return file_.publish();
    OutputFile finished(file_.path());
    av::finish_mp4(file_.temporary_path(), finished.temporary_path(), file_.path(), chapters_);
    finished.publish();
  }

 private:
  av::Encoder encoder_;
  OutputFile file_;
  av::Writer writer_;
  std::vector<Chapter> chapters_;
};

/// A GIF has one palette for the whole film, which is known when all of it has been seen: until then the pictures wait,
/// packed as PNG (drawn pictures shrink to a fiftieth).
class GifSink final : public Sink {
 public:
  GifSink(const std::string& path, const FilmSettings& settings)
      : encoder_(settings, av::FilmCodec::gif), file_(path), writer_(writer_for(file_, encoder_, settings)) {}

  void frame(const Image& image) override {
    counts_.add(image);
    pictures_.push_back(encode_png(image));
  }

  void finish() override {
    const auto write = [this](AVPacket& packet) { writer_.write(packet); };
    Palette palette(counts_);
    for (const std::vector<std::uint8_t>& png : pictures_)
      encoder_.encode_indexed(palette.dithered(decode_png(png, file_.path())), palette.colors(), write);
    encoder_.flush(write);
    writer_.finish();
    file_.publish();
  }

 private:
  av::Encoder encoder_;
  OutputFile file_;
  av::Writer writer_;
  ColorCounts counts_;
  std::vector<std::vector<std::uint8_t>> pictures_;
};

constexpr const char* full_ffmpeg = "install Debian's libavcodec59, or a full FFmpeg";

struct KnownEncoder {
  const char* name;
  const char* purpose;
  const char* package;
};
constexpr std::array<KnownEncoder, 7> known_encoders{{
    {"libx264", "H.264 (.mp4, .mkv)", "install Debian's libavcodec59, or an FFmpeg built with --enable-libx264"},
    {"libvpx-vp9", "VP9 (.webm)", "install Debian's libavcodec59, or an FFmpeg built with --enable-libvpx"},
    {"prores_ks", "ProRes 4444 (.mov)", full_ffmpeg},
    {"qtrle", "QuickTime Animation, lossless (.mov)", full_ffmpeg},
    {"ffv1", "FFV1, lossless (.mkv)", full_ffmpeg},
    {"apng", "animated PNG, lossless (.apng)", full_ffmpeg},
    {"gif", "GIF (.gif)", full_ffmpeg},
}};

bool available(const char* name) { return avcodec_find_encoder_by_name(name) != nullptr; }

}  // namespace

bool is_film_ending(const std::string& ending) {
  constexpr std::array<const char*, 6> endings{".mp4", ".mkv", ".webm", ".mov", ".gif", ".apng"};
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::unique_ptr<Sink> make_video_sink(const std::string& path, const FilmSettings& settings) {
  av_log_set_level(AV_LOG_QUIET);  // what goes wrong is said once, as an error of ours
  const av::FilmCodec codec = av::codec_of(ending_of(path), settings.quality);
  check_settings(path, codec, settings);
  if (codec == av::FilmCodec::gif) return std::make_unique<GifSink>(path, settings);
  return std::make_unique<VideoSink>(path, codec, settings);
}

std::vector<VideoEncoder> video_encoders() {
  std::vector<VideoEncoder> encoders;
  for (const KnownEncoder& known : known_encoders)
    encoders.push_back({known.name, known.purpose, available(known.name)});
  return encoders;
}

void require_encoder(const std::string& name) {
  if (available(name.c_str())) return;
  std::string advice = "install an FFmpeg that has it";
  for (const KnownEncoder& known : known_encoders) {
    if (name == known.name) advice = known.package;
  }
  throw EnvironmentError("This machine's FFmpeg has no encoder " + name + ": " + advice + ".");
}

}  // namespace proofreel
