#include "render/video_reader.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "render/png.h"
#include "render/video_av.h"

namespace proofreel {
namespace {

// By name and not by content: a text file must not be able to make FFmpeg open others.
constexpr const char* known_formats = "mov,mp4,m4a,3gp,3g2,mj2,matroska,webm,gif,apng,avi";

struct CloseInput {
  void operator()(AVFormatContext* p) const { avformat_close_input(&p); }
};

[[noreturn]] void fail(const std::string& path, int code) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> reason{};
  av_strerror(code, reason.data(), reason.size());
  throw ImageError("Cannot read " + path + ": " + reason.data() + ".");
}

void check_code(const std::string& path, int code) {
  if (code < 0) fail(path, code);
}

AVFormatContext* open_film(const std::string& path) {
  AVDictionary* options = nullptr;
  av_dict_set(&options, "format_whitelist", known_formats, 0);
  av_dict_set(&options, "protocol_whitelist", "file", 0);
  av_dict_set(&options, "ignore_loop", "1", 0);  // a GIF is read once, however often it is played
  AVFormatContext* format = nullptr;
  const int code = avformat_open_input(&format, ("file:" + path).c_str(), nullptr, &options);
  av_dict_free(&options);
  check_code(path, code);
  return format;
}

}  // namespace

bool is_film_name(const std::string& path) {
  constexpr std::array<const char*, 7> endings{".mp4", ".mkv", ".webm", ".mov", ".gif", ".apng", ".avi"};
  const std::string ending = std::filesystem::path(path).extension().string();
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

struct VideoReader::Impl {
  std::string path;
  std::unique_ptr<AVFormatContext, CloseInput> format;
  int track = 0;
  av::Codec decoder;
  av::Frame frame{av_frame_alloc()};
  av::Packet packet{av_packet_alloc()};
  std::unique_ptr<SwsContext, av::FreeScaler> scaler;
  bool ended = false;

  explicit Impl(std::string name) : path(std::move(name)), format(open_film(path)) {
    av::check_allocated(frame.get());
    av::check_allocated(packet.get());
    check_code(path, avformat_find_stream_info(format.get(), nullptr));
    const AVCodec* codec = nullptr;
    track = av_find_best_stream(format.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
    if (track < 0 || codec == nullptr)
      throw ImageError("Cannot read " + path + ": it holds no film that is known here.");
    open_decoder(*codec);
  }

  void open_decoder(const AVCodec& codec) {
    decoder.reset(avcodec_alloc_context3(&codec));
    av::check_allocated(decoder.get());
    check_code(path, avcodec_parameters_to_context(decoder.get(), stream().codecpar));
    decoder->max_pixels = max_image_pixels;
    decoder->err_recognition = AV_EF_EXPLODE;
    check_code(path, avcodec_open2(decoder.get(), &codec, nullptr));
  }

  const AVStream& stream() const { return *format->streams[track]; }

  /// Gives the decoder one more packet, or the sign that there are none.
  void feed() {
    int code = 0;
    do {
      av_packet_unref(packet.get());
      code = av_read_frame(format.get(), packet.get());
    } while (code >= 0 && packet->stream_index != track);
    ended = code == AVERROR_EOF;
    if (!ended) check_code(path, code);
    check_code(path, avcodec_send_packet(decoder.get(), ended ? nullptr : packet.get()));
  }

  /// False at the end.
  bool receive() {
    while (true) {
      const int code = avcodec_receive_frame(decoder.get(), frame.get());
      if (code == AVERROR_EOF) return false;
      if (code != AVERROR(EAGAIN)) {
        check_code(path, code);
        return true;
      }
      feed();
    }
  }

  void convert(Image& image) {
    const int width = frame->width, height = frame->height;
    if (std::int64_t{width} * height > max_image_pixels) throw ImageError("Cannot read " + path + ": it is too large.");
    if (image.width_px != width || image.height_px != height) image = Image::uncleared(width, height);
    scaler.reset(sws_getCachedContext(
        scaler.release(), width, height, static_cast<AVPixelFormat>(frame->format), width, height, AV_PIX_FMT_RGBA,
        SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_BITEXACT, nullptr, nullptr, nullptr));
    if (!scaler) throw ImageError("Cannot read " + path + ": its pixels are of an unknown kind.");
    const int matrix = frame->colorspace == AVCOL_SPC_BT709 ? SWS_CS_ITU709 : SWS_CS_ITU601;
    const int full = frame->color_range == AVCOL_RANGE_JPEG ? 1 : 0;
    const int* coefficients = sws_getCoefficients(matrix);
    sws_setColorspaceDetails(scaler.get(), coefficients, full, coefficients, 1, 0, 1 << 16, 1 << 16);
    const std::array<std::uint8_t*, 1> to{image.rgba.data()};
    const std::array<int, 1> stride{width * 4};
    check_code(path, sws_scale(scaler.get(), frame->data, frame->linesize, 0, height, to.data(), stride.data()));
  }
};

VideoReader::VideoReader(const std::string& path) {
  av_log_set_level(AV_LOG_QUIET);  // what goes wrong is said once, as an error of ours
  impl_ = std::make_unique<Impl>(path);
}
VideoReader::~VideoReader() = default;
VideoReader::VideoReader(VideoReader&&) noexcept = default;
VideoReader& VideoReader::operator=(VideoReader&&) noexcept = default;

bool VideoReader::next(Image& image) {
  if (!impl_->receive()) return false;
  impl_->convert(image);
  return true;
}

double VideoReader::fps() const {
  const AVRational rate = impl_->stream().avg_frame_rate;
  return rate.num > 0 && rate.den > 0 ? av_q2d(rate) : 0;
}

std::int64_t VideoReader::stated_frames() const {
  const AVStream& stream = impl_->stream();
  if (stream.nb_frames > 0) return stream.nb_frames;
  const std::int64_t duration = impl_->format->duration;
  return duration > 0 ? static_cast<std::int64_t>(static_cast<double>(duration) / AV_TIME_BASE * fps() + 0.5) : 0;
}

}  // namespace proofreel
