#pragma once

/// Encoded packets in, container file out. For render/video*.cpp only.

#include <memory>
#include <string>
#include <vector>

#include "render/sink.h"
#include "render/video_av.h"

namespace proofreel::av {

enum class Layout {
  plain,           ///< as the container is written
  fragmented_mp4,  ///< readable up to the last whole fragment at any time
  finished_mp4     ///< index first, for players that start before all has loaded
};

/// A video track as containers describe it.
struct Track {
  const AVCodecParameters& parameters;
  AVRational time_base;  ///< the unit packets count time in, s
  AVRational frame_rate;
};

/// A container file with one video track.
class Writer {
 public:
  /// `path` is what is opened, `name` what errors call it and whose ending says which container it is.
  Writer(const std::string& path, std::string name, Layout layout, const Track& track,
         const std::vector<Chapter>& chapters);
  void write(AVPacket& packet);
  /// Completes the file. Throws EnvironmentError when any byte did not reach the disk.
  void finish();

 private:
  struct Close {
    void operator()(AVFormatContext* p) const;
  };
  std::string name_;
  std::unique_ptr<AVFormatContext, Close> format_;
  AVRational time_base_{};
};

/// Copies the packets of a fragmented MP4 into a finished one that starts at time 0 and has chapters.
void finish_mp4(const std::string& fragmented, const std::string& finished, const std::string& name,
                const std::vector<Chapter>& chapters);

}  // namespace proofreel::av
