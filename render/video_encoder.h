#pragma once

/// Pictures in, encoded packets out. For render/video*.cpp only.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "render/sink.h"
#include "render/video_av.h"
#include "render/video_codec.h"

namespace proofreel::av {

using PacketTaker = std::function<void(AVPacket&)>;

/// Pictures as one of the codecs has them: YUV in BT.709 and limited range, or RGB. Time is counted in frames.
class Encoder {
 public:
  Encoder(const FilmSettings& settings, FilmCodec codec);
  /// Encodes one more picture and passes on the packets that are ready.
  void encode(const Image& image, const PacketTaker& take);
  /// The same of a picture in colours of a palette (0xAARRGGBB), for GIF: an index per pixel.
  void encode_indexed(std::span<const std::uint8_t> indices, std::span<const std::uint32_t> palette,
                      const PacketTaker& take);
  /// Passes on what is still inside.
  void flush(const PacketTaker& take);
  const AVCodecContext& context() const { return *context_; }

 private:
  void convert(const Image& image);
  void send(const PacketTaker& take);
  void drain(const PacketTaker& take);

  Codec context_;
  std::unique_ptr<SwsContext, FreeScaler> scaler_;
  Frame frame_;
  Edition converted_;  // what is in the frame
  Packet packet_;
  std::int64_t frames_ = 0;
};

}  // namespace proofreel::av
