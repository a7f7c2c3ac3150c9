// The file `pizarra-ffmpeg.so`, which film_reader.cpp loads. It alone links FFmpeg.

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <cmath>

#include "drivers/camera/film_reader.hpp"
#include "drivers/camera/image_faults.hpp"

namespace pizarra::camera {
namespace {

constexpr double usual_hz = 25;
constexpr double least_hz = 1;
constexpr double most_hz = 1000;

struct Freed {
  void operator()(AVFormatContext* file) const { avformat_close_input(&file); }
  void operator()(AVCodecContext* decoder) const { avcodec_free_context(&decoder); }
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
template <class T>
using Owned = std::unique_ptr<T, Freed>;

// How a camera that was held otherwise must be turned to be upright, in quarters of a turn clockwise.
int quarters_of(const AVStream& stream) {
  const std::uint8_t* matrix = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, nullptr);
  const double left_deg =
      matrix == nullptr ? 0 : av_display_rotation_get(reinterpret_cast<const std::int32_t*>(matrix));
  return std::isfinite(left_deg) ? static_cast<int>(std::lround(-left_deg / 90)) & 3 : 0;
}

cv::Mat plane_of(const AVFrame& frame, int type) {
  return {frame.height, frame.width, type, frame.data[0], static_cast<std::size_t>(frame.linesize[0])};
}

// A byte each, one behind the other, from the top.
bool has_luminance_plane(const AVFrame& frame) {
  const AVPixFmtDescriptor& format = *av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
  const AVComponentDescriptor& first = format.comp[0];
  constexpr std::uint64_t none_of = AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL | AV_PIX_FMT_FLAG_HWACCEL;
  return frame.linesize[0] >= frame.width && (format.flags & none_of) == 0 && first.plane == 0 && first.step == 1 &&
         first.offset == 0 && first.depth == 8;
}

// Most films go from 16 to 235.
cv::Mat luminance(const AVFrame& frame) {
  const cv::Mat plane = plane_of(frame, CV_8UC1);
  const bool is_full = frame.color_range == AVCOL_RANGE_JPEG || frame.format == AV_PIX_FMT_YUVJ420P ||
                       frame.format == AV_PIX_FMT_YUVJ422P || frame.format == AV_PIX_FMT_YUVJ444P ||
                       frame.format == AV_PIX_FMT_GRAY8;
  if (is_full) return plane.clone();
  constexpr double black = 16;
  constexpr double stretch = 255.0 / (235 - black);
  cv::Mat out;
  plane.convertTo(out, CV_8U, stretch, -black * stretch);
  return out;
}

cv::Mat turned(const cv::Mat& picture, int quarters) {
  if (quarters == 0) return picture;
  constexpr cv::RotateFlags ways[] = {cv::ROTATE_90_CLOCKWISE, cv::ROTATE_180, cv::ROTATE_90_COUNTERCLOCKWISE};
  cv::Mat out;
  cv::rotate(picture, out, ways[quarters - 1]);
  return out;
}

class FfmpegFilm : public FilmReader {
 public:
  bool open(const std::string& path) override {
    AVFormatContext* opened = nullptr;
    // A name with a colon is no protocol.
    if (avformat_open_input(&opened, ("file:" + path).c_str(), nullptr, nullptr) < 0) return false;
    file_.reset(opened);
    if (avformat_find_stream_info(opened, nullptr) < 0) return false;
    const AVCodec* codec = nullptr;
    const int found = av_find_best_stream(opened, AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
    if (found < 0 || codec == nullptr) return false;
    stream_ = opened->streams[found];
    quarters_ = quarters_of(*stream_);
    const double hz = av_q2d(av_guess_frame_rate(opened, stream_, nullptr));
    hz_ = hz >= least_hz && hz <= most_hz ? hz : usual_hz;
    return open_decoder(codec);
  }
  double pictures_per_second() const override { return hz_; }

  std::optional<double> grab() override {
    while (avcodec_receive_frame(decoder_.get(), frame_.get()) < 0) {
      if (!feed_decoder()) return std::nullopt;
    }
    const double by_count_s = static_cast<double>(grabbed_++) / hz_;
    if (frame_->best_effort_timestamp == AV_NOPTS_VALUE) return 1000 * by_count_s;
    const std::int64_t begins = stream_->start_time == AV_NOPTS_VALUE ? 0 : stream_->start_time;
    return 1000 * av_q2d(stream_->time_base) * static_cast<double>(frame_->best_effort_timestamp - begins);
  }

  cv::Mat picture(bool grey) override {
    const bool damaged = (frame_->flags & AV_FRAME_FLAG_CORRUPT) != 0 || frame_->decode_error_flags != 0;
    if (damaged) return {};
    return grey && has_luminance_plane(*frame_) ? turned(luminance(*frame_), quarters_) : converted(grey);
  }

 private:
  bool open_decoder(const AVCodec* codec) {
    decoder_.reset(avcodec_alloc_context3(codec));
    if (avcodec_parameters_to_context(decoder_.get(), stream_->codecpar) < 0) return false;
    decoder_->max_pixels = std::int64_t{largest_pair.width} * largest_pair.height;
    decoder_->thread_count = 0;  // as many as there are processors
    return avcodec_open2(decoder_.get(), codec, nullptr) >= 0;
  }

  cv::Mat converted(bool grey) {
    const int width = frame_->width;
    const int height = frame_->height;
    const AVPixelFormat wanted = grey ? AV_PIX_FMT_GRAY8 : AV_PIX_FMT_BGR24;
    scaler_.reset(sws_getCachedContext(scaler_.release(), width, height, static_cast<AVPixelFormat>(frame_->format),
                                       width, height, wanted, SWS_BICUBIC, nullptr, nullptr, nullptr));
    if (width != converted_->width || height != converted_->height || wanted != converted_->format) {
      converted_.reset(av_frame_alloc());
    }
    if (!scaler_ || sws_scale_frame(scaler_.get(), converted_.get(), frame_.get()) < 0) return {};
    return turned(plane_of(*converted_, grey ? CV_8UC1 : CV_8UC3).clone(), quarters_);
  }

  // The film's next piece; or that it is over, once: the decoder still holds pictures then. A damaged piece is left
  // out.
  bool feed_decoder() {
    while (!is_over_) {
      is_over_ = av_read_frame(file_.get(), packet_.get()) < 0;
      const bool is_ours = !is_over_ && packet_->stream_index == stream_->index;
      if (is_ours || is_over_) avcodec_send_packet(decoder_.get(), is_over_ ? nullptr : packet_.get());
      av_packet_unref(packet_.get());
      if (is_ours || is_over_) return true;
    }
    return false;
  }

  Owned<AVFormatContext> file_;
  AVStream* stream_ = nullptr;  // the file's
  Owned<AVCodecContext> decoder_;
  Owned<AVPacket> packet_{av_packet_alloc()};
  Owned<AVFrame> frame_{av_frame_alloc()};
  Owned<SwsContext> scaler_;
  Owned<AVFrame> converted_{av_frame_alloc()};
  double hz_ = usual_hz;
  int quarters_ = 0;
  std::int64_t grabbed_ = 0;
  bool is_over_ = false;
};

FilmReader* new_ffmpeg_film() {
  // What goes wrong is told by our failures.
  av_log_set_level(AV_LOG_QUIET);
  return new FfmpegFilm;
}

}  // namespace
}  // namespace pizarra::camera

extern "C" pizarra::camera::FilmReader* (*const pizarra_new_film_reader)() = pizarra::camera::new_ffmpeg_film;
