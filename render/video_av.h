#pragma once

/// FFmpeg's C structures with owners, and its error codes as sentences. For render/video*.cpp only.

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <memory>
#include <string>

namespace proofreel::av {

struct Free {
  void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
  void operator()(AVFrame* p) const { av_frame_free(&p); }
  void operator()(AVPacket* p) const { av_packet_free(&p); }
};
struct FreeScaler {
  void operator()(SwsContext* p) const { sws_freeContext(p); }
};
using Codec = std::unique_ptr<AVCodecContext, Free>;
using Frame = std::unique_ptr<AVFrame, Free>;
using Packet = std::unique_ptr<AVPacket, Free>;

/// Throws EnvironmentError "Cannot `what`: reason." when `code` is one of FFmpeg's negative error codes.
void check(int code, const std::string& what);

/// Throws std::bad_alloc for a null pointer, which is all FFmpeg's allocators say.
void check_allocated(const void* pointer);

}  // namespace proofreel::av
