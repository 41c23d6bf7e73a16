#include "render/video_file.h"

#include "render/video_codec.h"

namespace proofreel::av {
namespace {

struct CloseInput {
  void operator()(AVFormatContext* p) const { avformat_close_input(&p); }
};
using Input = std::unique_ptr<AVFormatContext, CloseInput>;

void set(AVFormatContext& format, const char* option, const char* value) {
  check(av_opt_set(format.priv_data, option, value, 0), std::string("set up ").append(format.oformat->name));
}

const char* movie_flags(Layout layout) {
  return layout == Layout::fragmented_mp4 ? "frag_keyframe+empty_moov+default_base_moof" : "faststart";
}

void set_up(AVFormatContext& format, const std::string& ending, Layout layout) {
  if (ending == ".mp4" || ending == ".mov") set(format, "movflags", movie_flags(layout));
  if (ending == ".apng") set(format, "plays", "0");  // for ever, as GIFs do unless told
}

/// The container frees them. Containers that have none leave them out.
void add_chapters(AVFormatContext& format, const std::vector<Chapter>& chapters, AVRational frame_rate) {
  if (chapters.empty()) return;
  format.chapters = static_cast<AVChapter**>(av_calloc(chapters.size(), sizeof(AVChapter*)));
  check_allocated(format.chapters);
  for (const Chapter& chapter : chapters) {
    auto* made = static_cast<AVChapter*>(av_mallocz(sizeof(AVChapter)));
    check_allocated(made);
    format.chapters[format.nb_chapters] = made;
    made->id = ++format.nb_chapters;
    made->time_base = av_inv_q(frame_rate);
    made->start = chapter.first;
    made->end = chapter.last + 1;
    check(av_dict_set(&made->metadata, "title", chapter.name.c_str(), 0), "name a chapter");
  }
}

Input open_input(const std::string& path, const std::string& name) {
  AVFormatContext* format = nullptr;
  check(avformat_open_input(&format, path.c_str(), nullptr, nullptr), "read back " + name);
  return Input(format);
}

}  // namespace

void Writer::Close::operator()(AVFormatContext* p) const {
  avio_closep(&p->pb);
  avformat_free_context(p);
}

Writer::Writer(const std::string& path, std::string name, Layout layout, const Track& track,
               const std::vector<Chapter>& chapters)
    : name_(std::move(name)), time_base_(track.time_base) {
  AVFormatContext* format = nullptr;
  const std::string ending = ending_of(name_);
  check(avformat_alloc_output_context2(&format, nullptr, container_name(ending).c_str(), path.c_str()),
        "write " + name_);
  format_.reset(format);
  AVStream* stream = avformat_new_stream(format, nullptr);
  check_allocated(stream);
  check(avcodec_parameters_copy(stream->codecpar, &track.parameters), "write " + name_);
  stream->codecpar->codec_tag = 0;  // containers number codecs differently
  stream->time_base = track.time_base;
  stream->avg_frame_rate = track.frame_rate;
  check(avio_open(&format->pb, path.c_str(), AVIO_FLAG_WRITE), "write " + name_);
  set_up(*format, ending, layout);
  add_chapters(*format, chapters, track.frame_rate);
  format->flags |= AVFMT_FLAG_FLUSH_PACKETS;  // nothing whole stays behind in memory when the program is killed
  check(avformat_write_header(format, nullptr), "write " + name_);
}

void Writer::write(AVPacket& packet) {
  AVStream* stream = format_->streams[0];
  av_packet_rescale_ts(&packet, time_base_, stream->time_base);
  packet.stream_index = 0;
  packet.pos = -1;
  check(av_interleaved_write_frame(format_.get(), &packet), "write " + name_);
}

void Writer::finish() {
  check(av_write_trailer(format_.get()), "write " + name_);
  avio_flush(format_->pb);
  check(format_->pb->error, "write " + name_);
  check(avio_closep(&format_->pb), "write " + name_);
}

void finish_mp4(const std::string& fragmented, const std::string& finished, const std::string& name,
                const std::vector<Chapter>& chapters) {
  const Input input = open_input(fragmented, name);
  if (input->nb_streams != 1) check(AVERROR_INVALIDDATA, "read back " + name);
  const AVStream& from = *input->streams[0];
  Writer writer(finished, name, Layout::finished_mp4, {*from.codecpar, from.time_base, from.avg_frame_rate}, chapters);
  const Packet packet(av_packet_alloc());
  check_allocated(packet.get());
  std::int64_t start = AV_NOPTS_VALUE;
  int code = 0;
  while ((code = av_read_frame(input.get(), packet.get())) >= 0) {
    // Fragments cannot start before 0, so reordered frames made the film start late: the first picture is moved back.
    if (start == AV_NOPTS_VALUE) start = packet->pts;
    packet->pts -= start;
    packet->dts -= start;
    writer.write(*packet);
    av_packet_unref(packet.get());
  }
  if (code != AVERROR_EOF) check(code, "read back " + name);
  writer.finish();
}

}  // namespace proofreel::av
