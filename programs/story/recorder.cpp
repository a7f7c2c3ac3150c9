#include "programs/story/recorder.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "drivers/camera/opencv_files.hpp"
#include "programs/story/output_file.hpp"

namespace pizarra::story {

namespace {

constexpr double frames_per_second = 10;
constexpr int picture_scale = 2;
constexpr int caption_height_px = 40;
constexpr std::size_t caption_letters = 86;
const cv::Size picture_size(320 * picture_scale, 240 * picture_scale + caption_height_px);

cv::Mat with_caption(const Image& image, const std::string& caption) {
  const cv::Mat view(image.height, image.width, image.channels == 3 ? CV_8UC3 : CV_8UC1,
                     const_cast<std::uint8_t*>(image.pixels.data()));
  cv::Mat colour;
  if (image.channels == 3) {
    colour = view;
  } else {
    cv::cvtColor(view, colour, cv::COLOR_GRAY2BGR);
  }
  cv::Mat picture(picture_size, CV_8UC3, cv::Scalar(32, 28, 24));
  const cv::Rect place(0, 0, picture_size.width, picture_size.height - caption_height_px);
  cv::resize(colour, picture(place), place.size(), 0, 0, cv::INTER_CUBIC);
  const cv::Point text(10, picture_size.height - 14);
  cv::putText(picture, caption.substr(0, caption_letters), text, cv::FONT_HERSHEY_SIMPLEX, 0.42,
              cv::Scalar(230, 230, 230), 1, cv::LINE_AA);
  return picture;
}

// A codec's number.
int four_letters(const char* code) { return code[0] | code[1] << 8 | code[2] << 16 | code[3] << 24; }

Result<int> codec_for(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".avi") return four_letters("MJPG");
  if (extension == ".mp4") return four_letters("mp4v");
  return fail("cannot-write", fmt::format("{}: a film is named .avi or .mp4", path));
}

}  // namespace

Result<void> Recorder::film(const std::string& path) {
  const Result<int> codec = codec_for(path);
  if (!codec) return fail(codec);
  const Result<void> folder = make_folder_of(path);
  if (!folder) return folder;
  const Result<camera::OpencvFiles> opencv = camera::opencv_files();
  if (!opencv) return fail(opencv);
  std::unique_ptr<cv::VideoWriter> film(opencv->new_writer());
  try {
    film->open(path, *codec, frames_per_second, picture_size);
  } catch (const cv::Exception& error) {
    return fail("cannot-write", fmt::format("cannot write the film {}: {}", path, error.what()));
  }
  if (!film->isOpened()) return fail("cannot-write", fmt::format("cannot write the film {}", path));
  film_ = std::move(film);
  film_path_ = path;
  watch();
  return {};
}

void Recorder::watch() {
  if (subscription_) return;
  subscription_ = streams_.subscribe("vision-annotated", [this](const StreamFrame& frame) { take(frame); });
}

void Recorder::take(const StreamFrame& frame) {
  newest_ = with_caption(*frame.image, narrator_.newest());
  if (film_) film_->write(newest_);
}

Result<void> Recorder::save_picture(const std::string& path) const {
  if (newest_.empty()) return fail("cannot-write", "no picture came from the camera");
  const Result<camera::ImageBytes> png = camera::encoded_image(".png", newest_);
  if (!png) return fail(png);
  return write_file(path, *png);
}

Result<void> Recorder::finish() {
  if (film_path_.empty()) return {};
  film_->release();
  if (!is_whole_film(film_path_)) return fail(unwritten(film_path_));
  return {};
}

}  // namespace pizarra::story
