#include "render/video_codec.h"

#include <array>

namespace proofreel::av {
namespace {

/// What does not depend on the settings.
struct Traits {
  const char* encoder;
  AVPixelFormat opaque;
  AVPixelFormat transparent;  ///< AV_PIX_FMT_NONE: it never is
  bool halves_colour;
};

constexpr std::array<Traits, 7> traits{{
    {"libx264", AV_PIX_FMT_YUV420P, AV_PIX_FMT_NONE, true},
    {"libvpx-vp9", AV_PIX_FMT_YUV420P, AV_PIX_FMT_YUVA420P, true},
    {"prores_ks", AV_PIX_FMT_YUV444P10LE, AV_PIX_FMT_YUVA444P10LE, false},
    {"qtrle", AV_PIX_FMT_RGB24, AV_PIX_FMT_ARGB, false},
    {"ffv1", AV_PIX_FMT_BGR0, AV_PIX_FMT_RGB32, false},
    {"apng", AV_PIX_FMT_RGB24, AV_PIX_FMT_RGBA, false},
    {"gif", AV_PIX_FMT_PAL8, AV_PIX_FMT_PAL8, false},
}};

const Traits& traits_of(FilmCodec codec) { return traits[static_cast<std::size_t>(codec)]; }

void set(AVCodecContext& context, const char* option, const std::string& value) {
  check(av_opt_set(context.priv_data, option, value.c_str(), 0), std::string("set the encoder's ").append(option));
}

void tag_bt709(AVCodecContext& context) {
  context.color_range = AVCOL_RANGE_MPEG;
  context.colorspace = AVCOL_SPC_BT709;
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_BT709;
}

void tag_rgb(AVCodecContext& context) {
  context.color_range = AVCOL_RANGE_JPEG;
  context.colorspace = AVCOL_SPC_RGB;
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_IEC61966_2_1;
}

struct X264Defaults {
  const char* preset;
  int crf;
  const char* tune;  ///< null: none
};

X264Defaults x264_defaults(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return {"veryfast", 26, nullptr};
    case Quality::final:
      return {"medium", 18, "animation"};
    case Quality::lossless:
      return {"medium", 0, nullptr};
  }
  return {};
}

void set_up_x264(AVCodecContext& context, const FilmSettings& settings) {
  const X264Defaults defaults = x264_defaults(settings.quality);
  tag_bt709(context);
  context.chroma_sample_location = AVCHROMA_LOC_CENTER;  // where convert_to_yuv420 puts it
  set(context, "preset", settings.preset.value_or(defaults.preset));
  set(context, "crf", std::to_string(settings.crf.value_or(defaults.crf)));
  // Looking further ahead than 10 frames buys nothing on drawn pictures (the films came out 3 % larger) and takes 5 MB
  // of memory per 1080p frame; a lookahead thread of its own would keep as many again.
  set(context, "x264-params", "rc-lookahead=10:sync-lookahead=0");
  if (defaults.tune != nullptr) set(context, "tune", defaults.tune);
}

/// Constant quality (no bit rate), rows of blocks in parallel. Its rate factors are coarser than x264's.
void set_up_vp9(AVCodecContext& context, const FilmSettings& settings) {
  tag_bt709(context);
  const bool draft = settings.quality == Quality::draft;
  context.bit_rate = 0;
  set(context, "deadline", draft ? "realtime" : "good");
  set(context, "cpu-used", draft ? "7" : "3");
  set(context, "row-mt", "1");
  if (settings.quality == Quality::lossless) return set(context, "lossless", "1");
  set(context, "crf", std::to_string(settings.crf.value_or(draft ? 36 : 22)));
  if (settings.transparent) set(context, "auto-alt-ref", "0");  // hidden frames have no place beside an alpha track
}

void set_up_ffv1(AVCodecContext& context) {
  tag_rgb(context);
  context.gop_size = 1;  // every frame on its own: any cut is exact
  context.level = 3;
  context.slices = 4;
}

void set_up_prores(AVCodecContext& context, const FilmSettings& settings) {
  tag_bt709(context);
  set(context, "profile", "4444");
  // By quality, not by bit rate: drawn pictures need few bits, and flat colours have to stay as they are.
  context.flags |= AV_CODEC_FLAG_QSCALE;
  context.global_quality = (settings.quality == Quality::draft ? 9 : 2) * FF_QP2LAMBDA;
  set(context, "vendor", "apl0");  // some editors open no other
  if (settings.transparent) set(context, "alpha_bits", "16");
}

}  // namespace

FilmCodec codec_of(const std::string& ending, Quality quality) {
  const bool lossless = quality == Quality::lossless;
  if (ending == ".webm") return FilmCodec::vp9;
  if (ending == ".mov") return lossless ? FilmCodec::qtrle : FilmCodec::prores;
  if (ending == ".apng") return FilmCodec::apng;
  if (ending == ".gif") return FilmCodec::gif;
  return ending == ".mkv" && lossless ? FilmCodec::ffv1 : FilmCodec::h264;
}

const char* encoder_name(FilmCodec codec) { return traits_of(codec).encoder; }

std::string container_name(const std::string& ending) {
  return ending == ".mkv" ? "matroska" : ending.substr(1);  // FFmpeg calls the others as their files end
}

bool halves_colour(FilmCodec codec) { return traits_of(codec).halves_colour; }
bool may_be_transparent(FilmCodec codec) { return traits_of(codec).transparent != AV_PIX_FMT_NONE; }
bool takes_preset(FilmCodec codec) { return codec == FilmCodec::h264; }
bool takes_crf(FilmCodec codec, Quality quality) {
  return quality != Quality::lossless && (codec == FilmCodec::h264 || codec == FilmCodec::vp9);
}
int highest_crf(FilmCodec codec) { return codec == FilmCodec::vp9 ? 63 : 51; }

void set_up(AVCodecContext& context, FilmCodec codec, const FilmSettings& settings) {
  context.pix_fmt = settings.transparent ? traits_of(codec).transparent : traits_of(codec).opaque;
  context.gop_size = settings.fps;  // a key frame per second: lecturers jump about, and fragments end there
  switch (codec) {
    case FilmCodec::h264:
      return set_up_x264(context, settings);
    case FilmCodec::vp9:
      return set_up_vp9(context, settings);
    case FilmCodec::prores:
      return set_up_prores(context, settings);
    case FilmCodec::ffv1:
      return set_up_ffv1(context);
    case FilmCodec::qtrle:
    case FilmCodec::apng:
      return tag_rgb(context);
    case FilmCodec::gif:
      return;
  }
}

}  // namespace proofreel::av
