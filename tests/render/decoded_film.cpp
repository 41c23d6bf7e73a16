#include "tests/render/decoded_film.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <memory>
#include <stdexcept>

#include "tests/render/scratch_folder.h"

namespace proofreel {
namespace {

struct Free {
  void operator()(AVFormatContext* p) const { avformat_close_input(&p); }
  void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
  void operator()(AVFrame* p) const { av_frame_free(&p); }
  void operator()(AVPacket* p) const { av_packet_free(&p); }
  void operator()(SwsContext* p) const { sws_freeContext(p); }
};

void check(int code, const char* what) {
  if (code < 0) throw std::runtime_error(what);
}

std::string text(const char* name) { return name == nullptr ? "" : name; }

Image to_rgb(const AVFrame& frame) {
  Image image(frame.width, frame.height);
  const std::unique_ptr<SwsContext, Free> context(sws_getContext(
      frame.width, frame.height, static_cast<AVPixelFormat>(frame.format), frame.width, frame.height, AV_PIX_FMT_RGBA,
      SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_BITEXACT, nullptr, nullptr, nullptr));
  const int matrix = frame.colorspace == AVCOL_SPC_BT709 ? SWS_CS_ITU709 : SWS_CS_ITU601;  // what players assume
  const int full = frame.color_range == AVCOL_RANGE_JPEG ? 1 : 0;
  sws_setColorspaceDetails(context.get(), sws_getCoefficients(matrix), full, sws_getCoefficients(matrix), 1, 0, 1 << 16,
                           1 << 16);
  std::uint8_t* const to[] = {image.rgba.data()};
  const int stride[] = {frame.width * 4};
  sws_scale(context.get(), frame.data, frame.linesize, 0, frame.height, to, stride);
  return image;
}

void take_frames(AVCodecContext& decoder, AVRational time_base, DecodedFilm& film) {
  const std::unique_ptr<AVFrame, Free> frame(av_frame_alloc());
  while (true) {
    const int code = avcodec_receive_frame(&decoder, frame.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    check(code, "a frame does not decode");
    if (frame->decode_error_flags != 0) throw std::runtime_error("a frame decodes with errors");
    if (frame->key_frame != 0) film.key_frames.push_back(static_cast<int>(film.frames.size()));
    film.times_s.push_back(static_cast<double>(frame->best_effort_timestamp) * av_q2d(time_base));
    film.frames.push_back(to_rgb(*frame));
  }
}

void describe(const AVFormatContext& format, const AVStream& stream, DecodedFilm& film) {
  const AVCodecParameters& track = *stream.codecpar;
  film.container = format.iformat->name;
  film.codec = avcodec_get_name(track.codec_id);
  film.pixel_format = text(av_get_pix_fmt_name(static_cast<AVPixelFormat>(track.format)));
  film.range = text(av_color_range_name(track.color_range));
  film.matrix = text(av_color_space_name(track.color_space));
  film.primaries = text(av_color_primaries_name(track.color_primaries));
  film.transfer = text(av_color_transfer_name(track.color_trc));
  film.fps = av_q2d(stream.avg_frame_rate);
  film.duration_s = static_cast<double>(format.duration) / AV_TIME_BASE;
  film.start_s = static_cast<double>(format.start_time) / AV_TIME_BASE;
}

}  // namespace

std::vector<FilmChapter> chapters_in(const std::string& path) {
  AVFormatContext* opened = nullptr;
  check(avformat_open_input(&opened, path.c_str(), nullptr, nullptr), "the film cannot be opened");
  const std::unique_ptr<AVFormatContext, Free> format(opened);
  std::vector<FilmChapter> chapters;
  for (unsigned i = 0; i < format->nb_chapters; ++i) {
    const AVChapter& chapter = *format->chapters[i];
    const AVDictionaryEntry* title = av_dict_get(chapter.metadata, "title", nullptr, 0);
    const double unit = av_q2d(chapter.time_base);
    chapters.push_back({title == nullptr ? "" : title->value, static_cast<double>(chapter.start) * unit,
                        static_cast<double>(chapter.end) * unit});
  }
  return chapters;
}

DecodedFilm decode_film(const std::string& path) {
  AVFormatContext* opened = nullptr;
  check(avformat_open_input(&opened, path.c_str(), nullptr, nullptr), "the film cannot be opened");
  const std::unique_ptr<AVFormatContext, Free> format(opened);
  check(avformat_find_stream_info(format.get(), nullptr), "the film has no stream information");
  if (format->nb_streams != 1) throw std::runtime_error("the film has not exactly one track");
  const AVStream& stream = *format->streams[0];
  DecodedFilm film;
  describe(*format, stream, film);
  // FFmpeg's own decoder of VP9 leaves the alpha track out.
  const AVCodec* codec = stream.codecpar->codec_id == AV_CODEC_ID_VP9 ? avcodec_find_decoder_by_name("libvpx-vp9")
                                                                      : avcodec_find_decoder(stream.codecpar->codec_id);
  const std::unique_ptr<AVCodecContext, Free> decoder(avcodec_alloc_context3(codec));
  check(avcodec_parameters_to_context(decoder.get(), stream.codecpar), "the film's codec is unknown");
  decoder->err_recognition = AV_EF_EXPLODE;
  check(avcodec_open2(decoder.get(), codec, nullptr), "the film's decoder does not open");
  const std::unique_ptr<AVPacket, Free> packet(av_packet_alloc());
  while (av_read_frame(format.get(), packet.get()) >= 0) {
    check(avcodec_send_packet(decoder.get(), packet.get()), "a packet does not decode");
    av_packet_unref(packet.get());
    take_frames(*decoder, stream.time_base, film);
  }
  check(avcodec_send_packet(decoder.get(), nullptr), "the film does not end");
  take_frames(*decoder, stream.time_base, film);
  const std::string bytes = read_text(path);
  film.index_first = bytes.find("moov") < bytes.find("mdat");
  return film;
}

}  // namespace proofreel
