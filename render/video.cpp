#include "render/video.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "render/context.h"
#include "render/output_file.h"
#include "render/video_encoder.h"
#include "render/video_file.h"

namespace proofreel {
namespace {

constexpr std::array<const char*, 10> x264_presets{"ultrafast", "superfast", "veryfast", "faster",   "fast",
                                                   "medium",    "slow",      "slower",   "veryslow", "placebo"};

bool is_matroska(const std::string& path) { return std::filesystem::path(path).extension() == ".mkv"; }

bool is_ffv1(const std::string& path, const FilmSettings& settings) {
  return is_matroska(path) && settings.quality == Quality::lossless;
}

void check_size(const std::string& path, Size size) {
  if (size.width_px % 2 == 0 && size.height_px % 2 == 0) return;
  const Size even{size.width_px + size.width_px % 2, size.height_px + size.height_px % 2};
  throw UsageError("A film needs an even width and height, because H.264 stores colour at half the resolution: " +
                   path + " cannot be " + std::to_string(size.width_px) + "x" + std::to_string(size.height_px) +
                   ", but " + std::to_string(even.width_px) + "x" + std::to_string(even.height_px) + " works.");
}

void check_preset(const std::string& preset) {
  if (std::find(x264_presets.begin(), x264_presets.end(), preset) != x264_presets.end()) return;
  std::string known;
  for (const char* name : x264_presets) known.append(known.empty() ? "" : ", ").append(name);
  throw UsageError("There is no preset \"" + preset + "\"; x264 has " + known + ".");
}

void check_settings(const std::string& path, const FilmSettings& settings) {
  if (is_ffv1(path, settings)) {
    if (!settings.preset && !settings.crf) return;
    throw UsageError("--preset and --crf are for H.264; lossless .mkv is FFV1, which has neither.");
  }
  check_size(path, settings.size);
  if (settings.preset) check_preset(*settings.preset);
  if (settings.crf && (*settings.crf < 0 || *settings.crf > 51)) {
    throw UsageError("--crf goes from 0 (best) to 51, not " + std::to_string(*settings.crf) + ".");
  }
}

av::Layout layout_of(const std::string& path) {
  return is_matroska(path) ? av::Layout::matroska : av::Layout::fragmented_mp4;
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

av::Writer writer_for(const OutputFile& file, const av::Encoder& encoder) {
  const AVCodecContext& context = encoder.context();
  const std::unique_ptr<AVCodecParameters, FreeParameters> parameters(parameters_of(context));
  return {file.temporary_path(), file.path(),       layout_of(file.path()),
          *parameters,           context.time_base, context.framerate};
}

class VideoSink final : public Sink {
 public:
  VideoSink(const std::string& path, const FilmSettings& settings)
      : encoder_(settings, is_ffv1(path, settings), true), file_(path), writer_(writer_for(file_, encoder_)) {}

  void frame(const Image& image) override {
    encoder_.encode(image, [this](AVPacket& packet) { writer_.write(packet); });
  }

  void finish() override {
    encoder_.flush([this](AVPacket& packet) { writer_.write(packet); });
    writer_.finish();
    if (is_matroska(file_.path())) return file_.publish();
    OutputFile finished(file_.path());
    av::finish_mp4(file_.temporary_path(), finished.temporary_path(), file_.path());
    finished.publish();
  }

 private:
  av::Encoder encoder_;
  OutputFile file_;
  av::Writer writer_;
};

struct KnownEncoder {
  const char* name;
  const char* purpose;
  const char* package;
};
constexpr std::array<KnownEncoder, 2> known_encoders{{
    {"libx264", "H.264 (.mp4, .mkv)", "install Debian's libavcodec59, or an FFmpeg built with --enable-libx264"},
    {"ffv1", "FFV1, lossless (.mkv)", "install Debian's libavcodec59, or a full FFmpeg"},
}};

bool available(const char* name) { return avcodec_find_encoder_by_name(name) != nullptr; }

}  // namespace

std::unique_ptr<Sink> make_video_sink(const std::string& path, const FilmSettings& settings) {
  av_log_set_level(AV_LOG_QUIET);  // what goes wrong is said once, as an error of ours
  check_settings(path, settings);
  return std::make_unique<VideoSink>(path, settings);
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
