#include "render/video_encoder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <new>
#include <utility>

#include "render/context.h"
#include "render/pixel_convert.h"
#include "render/video.h"

namespace proofreel::av {
namespace {

Codec open(const FilmSettings& settings, FilmCodec film_codec) {
  const char* name = encoder_name(film_codec);
  require_encoder(name);
  const AVCodec* codec = avcodec_find_encoder_by_name(name);
  Codec context(avcodec_alloc_context3(codec));
  check_allocated(context.get());
  context->width = settings.size.width_px;
  context->height = settings.size.height_px;
  context->time_base = {1, settings.fps};
  context->framerate = {settings.fps, 1};
  context->thread_count = settings.threads;
  context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;  // all these containers want the codec's parameters in one place
  set_up(*context, film_codec, settings);
  check(avcodec_open2(context.get(), codec, nullptr), std::string("open the encoder ").append(name));
  return context;
}

Frame picture_for(const AVCodecContext& context) {
  Frame frame(av_frame_alloc());
  check_allocated(frame.get());
  frame->format = context.pix_fmt;
  frame->width = context.width;
  frame->height = context.height;
  frame->color_range = context.color_range;  // some encoders look here, and not at the context
  frame->colorspace = context.colorspace;
  frame->color_primaries = context.color_primaries;
  frame->color_trc = context.color_trc;
  check(av_frame_get_buffer(frame.get(), 0), "allocate a frame");
  return frame;
}

void copy_alpha(const Image& image, std::uint8_t* to, int stride) {
  for (int y = 0; y < image.height_px; ++y, to += stride) {
    const std::uint8_t* from = image.row(y) + 3;
    for (int x = 0; x < image.width_px; ++x) to[x] = from[4 * x];
  }
}

/// By swscale: into other orders of RGB, and exactly into what keeps colours at full resolution.
void convert_by_swscale(const Image& image, AVFrame& out, std::unique_ptr<SwsContext, FreeScaler>& scaler) {
  const auto format = static_cast<AVPixelFormat>(out.format);
  scaler.reset(sws_getCachedContext(scaler.release(), out.width, out.height, AV_PIX_FMT_RGBA, out.width, out.height,
                                    format, SWS_POINT | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_BITEXACT, nullptr,
                                    nullptr, nullptr));
  check_allocated(scaler.get());
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(scaler.get(), bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
  const std::array<const std::uint8_t*, 1> from{image.rgba.data()};
  const std::array<int, 1> stride{static_cast<int>(image.row_bytes())};
  check(sws_scale(scaler.get(), from.data(), stride.data(), 0, out.height, out.data, out.linesize), "convert a frame");
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

Encoder::Encoder(const FilmSettings& settings, FilmCodec codec)
    : context_(open(settings, codec)), frame_(picture_for(*context_)), packet_(av_packet_alloc()) {
  check_allocated(packet_.get());
}

/// Only what is not as in the frame before, where pictures know that.
void Encoder::convert(const Image& image) {
  AVFrame& out = *frame_;
  const Edition before = std::exchange(converted_, image.rgba.edition());
  if (converted_.same_as(before)) return;
  if (out.format != AV_PIX_FMT_YUV420P && out.format != AV_PIX_FMT_YUVA420P)
    return convert_by_swscale(image, out, scaler_);
  const Yuv420 planes{out.data[0], out.data[1], out.data[2], out.linesize[0], out.linesize[1]};
  if (converted_.follows(before)) {
    for (const PixelRect& change : converted_.changes) convert_to_yuv420(image, change, planes);
  } else {
    convert_to_yuv420(image, planes);
  }
  if (out.format == AV_PIX_FMT_YUVA420P) copy_alpha(image, out.data[3], out.linesize[3]);
}

void Encoder::encode(const Image& image, const PacketTaker& take) {
  assert(image.width_px == context_->width && image.height_px == context_->height);
  check(av_frame_make_writable(frame_.get()), "allocate a frame");
  convert(image);
  send(take);
}

void Encoder::encode_indexed(std::span<const std::uint8_t> indices, std::span<const std::uint32_t> palette,
                             const PacketTaker& take) {
  check(av_frame_make_writable(frame_.get()), "allocate a frame");
  const auto width = static_cast<std::size_t>(frame_->width);
  for (int y = 0; y < frame_->height; ++y) {
    const std::uint8_t* row = indices.data() + static_cast<std::size_t>(y) * width;
    std::copy_n(row, width, frame_->data[0] + static_cast<std::ptrdiff_t>(y) * frame_->linesize[0]);
  }
  std::memset(frame_->data[1], 0, AVPALETTE_SIZE);
  std::memcpy(frame_->data[1], palette.data(), palette.size_bytes());
  send(take);
}

void Encoder::send(const PacketTaker& take) {
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
