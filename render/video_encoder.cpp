#include "render/video_encoder.h"

#include <array>
#include <cassert>
#include <new>

#include "render/context.h"
#include "render/pixel_convert.h"
#include "render/video.h"

namespace proofreel::av {
namespace {

struct X264Defaults {
  const char* preset;
  int crf;
  const char* tune;  ///< null: none
};

X264Defaults defaults_of(Quality quality) {
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

void set(AVCodecContext& context, const char* option, const std::string& value) {
  check(av_opt_set(context.priv_data, option, value.c_str(), 0), std::string("set the encoder's ").append(option));
}

void configure_x264(AVCodecContext& context, const FilmSettings& settings) {
  const X264Defaults defaults = defaults_of(settings.quality);
  context.pix_fmt = AV_PIX_FMT_YUV420P;
  context.color_range = AVCOL_RANGE_MPEG;
  context.colorspace = AVCOL_SPC_BT709;
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_BT709;
  context.chroma_sample_location = AVCHROMA_LOC_CENTER;  // where convert_to_yuv420 puts it
  context.gop_size = settings.fps;  // a key frame per second: lecturers jump about, and fragments end there
  set(context, "preset", settings.preset.value_or(defaults.preset));
  set(context, "crf", std::to_string(settings.crf.value_or(defaults.crf)));
  // Looking further ahead than 10 frames buys nothing on drawn pictures (the films came out 3 % larger) and takes 5 MB
  // of memory per 1080p frame; a lookahead thread of its own would keep as many again.
  set(context, "x264-params", "rc-lookahead=10:sync-lookahead=0");
  if (defaults.tune != nullptr) set(context, "tune", defaults.tune);
}

void configure_ffv1(AVCodecContext& context) {
  context.pix_fmt = AV_PIX_FMT_BGR0;
  context.color_range = AVCOL_RANGE_JPEG;
  context.colorspace = AVCOL_SPC_RGB;
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_IEC61966_2_1;
  context.gop_size = 1;  // every frame on its own: any cut is exact
  context.level = 3;
  context.slices = 4;
}

Codec open(const FilmSettings& settings, bool ffv1, bool global_header) {
  const char* name = ffv1 ? "ffv1" : "libx264";
  require_encoder(name);
  const AVCodec* codec = avcodec_find_encoder_by_name(name);
  Codec context(avcodec_alloc_context3(codec));
  check_allocated(context.get());
  context->width = settings.size.width_px;
  context->height = settings.size.height_px;
  context->time_base = {1, settings.fps};
  context->framerate = {settings.fps, 1};
  context->thread_count = settings.threads;
  if (global_header) context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  if (ffv1) {
    configure_ffv1(*context);
  } else {
    configure_x264(*context, settings);
  }
  check(avcodec_open2(context.get(), codec, nullptr), std::string("open the encoder ").append(name));
  return context;
}

Frame picture_for(const AVCodecContext& context) {
  Frame frame(av_frame_alloc());
  check_allocated(frame.get());
  frame->format = context.pix_fmt;
  frame->width = context.width;
  frame->height = context.height;
  check(av_frame_get_buffer(frame.get(), 0), "allocate a frame");
  return frame;
}

void copy_as_bgr(const Image& image, AVFrame& out) {
  const std::size_t row_bytes = static_cast<std::size_t>(image.width_px) * 4;
  for (int row = 0; row < image.height_px; ++row) {
    const std::uint8_t* from = image.rgba.data() + static_cast<std::size_t>(row) * row_bytes;
    std::uint8_t* to = out.data[0] + static_cast<std::ptrdiff_t>(row) * out.linesize[0];
    for (std::size_t i = 0; i < row_bytes; i += 4) {
      to[i] = from[i + 2];
      to[i + 1] = from[i + 1];
      to[i + 2] = from[i];
      to[i + 3] = 0;
    }
  }
}

void convert(const Image& image, AVFrame& out) {
  if (out.format == AV_PIX_FMT_YUV420P) {
    convert_to_yuv420(image, {out.data[0], out.data[1], out.data[2], out.linesize[0], out.linesize[1]});
  } else {
    copy_as_bgr(image, out);
  }
}

}  // namespace

void check(int code, const std::string& what) {
  if (code >= 0) return;
  std::array<char, AV_ERROR_MAX_STRING_SIZE> reason{};
  av_strerror(code, reason.data(), reason.size());
  throw EnvironmentError("Cannot " + what + ": " + reason.data() + ".");
}

void check_allocated(const void* pointer) {
  if (pointer == nullptr) throw std::bad_alloc();
}

Encoder::Encoder(const FilmSettings& settings, bool ffv1, bool global_header)
    : context_(open(settings, ffv1, global_header)), frame_(picture_for(*context_)), packet_(av_packet_alloc()) {
  check_allocated(packet_.get());
}

void Encoder::encode(const Image& image, const PacketTaker& take) {
  assert(image.width_px == context_->width && image.height_px == context_->height);
  check(av_frame_make_writable(frame_.get()), "allocate a frame");
  convert(image, *frame_);
  frame_->pts = frames_++;
  check(avcodec_send_frame(context_.get(), frame_.get()), "encode a frame");
  drain(take);
}

void Encoder::flush(const PacketTaker& take) {
  check(avcodec_send_frame(context_.get(), nullptr), "finish encoding");
  drain(take);
}

void Encoder::drain(const PacketTaker& take) {
  while (true) {
    const int code = avcodec_receive_packet(context_.get(), packet_.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    check(code, "encode a frame");
    packet_->duration = 1;  // encoders leave 0, and players then drop the last frame
    take(*packet_);
    av_packet_unref(packet_.get());
  }
}

}  // namespace proofreel::av
