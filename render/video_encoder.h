#pragma once

/// Pictures in, encoded packets out. For render/video*.cpp only.

#include <cstdint>
#include <functional>

#include "render/sink.h"
#include "render/video_av.h"

namespace proofreel::av {

using PacketTaker = std::function<void(AVPacket&)>;

/// H.264 by x264 in BT.709 limited range 4:2:0, or FFV1 in RGB. Time is counted in frames.
class Encoder {
 public:
  /// `global_header`: the container wants the codec's parameters in one place rather than in every key frame.
  Encoder(const FilmSettings& settings, bool ffv1, bool global_header);
  /// Encodes one more picture and passes on the packets that are ready.
  void encode(const Image& image, const PacketTaker& take);
  /// Passes on what is still inside.
  void flush(const PacketTaker& take);
  const AVCodecContext& context() const { return *context_; }

 private:
  void drain(const PacketTaker& take);

  Codec context_;
  Frame frame_;
  Packet packet_;
  std::int64_t frames_ = 0;
};

}  // namespace proofreel::av
