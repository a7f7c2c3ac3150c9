#include "drivers/camera/capture_source.hpp"

#include <fmt/format.h>
#include <opencv2/core/utils/logger.hpp>

#include "drivers/camera/opencv_files.hpp"

namespace pizarra::camera {
namespace {

constexpr int open_timeout_ms = 5000;
constexpr int read_timeout_ms = 3000;
// V4L2's names of the settings, and its unit of exposure.
constexpr double manual_exposure = 1;
constexpr double automatic_exposure = 3;
constexpr double exposure_units_a_ms = 10;
constexpr double motion_jpeg = 'M' | 'J' << 8 | 'P' << 16 | 'G' << 24;

Result<cv::Mat> checked_image(cv::Mat image, const std::string& where) {
  if (image.empty()) return fail("corrupt-frame", fmt::format("{} is no image that can be read", where));
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
    return fail("corrupt-frame", fmt::format("{} is neither a grey nor a colour image of 8 bits", where));
  }
  return image;
}

}  // namespace

bool CaptureSource::open_capture() {
  switch (source_.kind) {
    case forms::CameraSource::Kind::device:
      return capture_->open(source_.where, cv::CAP_V4L2);
    case forms::CameraSource::Kind::pipeline:
      return capture_->open(source_.where, cv::CAP_GSTREAMER);
    case forms::CameraSource::Kind::stream:
      return capture_->open(
          source_.where, cv::CAP_FFMPEG,
          {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, open_timeout_ms, cv::CAP_PROP_READ_TIMEOUT_MSEC, read_timeout_ms});
    case forms::CameraSource::Kind::video:
    case forms::CameraSource::Kind::images:
      break;
  }
  return false;
}

Result<void> CaptureSource::open() {
  const Result<OpencvFiles> opencv = opencv_files();
  if (!opencv) return fail(opencv);
  // What goes wrong is told by our failures.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  capture_.reset(opencv->new_capture());
  bool opened = false;
  try {
    opened = open_capture();
  } catch (const cv::Exception&) {
    opened = false;
  }
  if (!opened) return fail("disconnected", fmt::format("{} cannot be opened", source_.where));
  return source_.kind == forms::CameraSource::Kind::device ? apply_settings() : Result<void>();
}

// Size and rate are a wish that the images themselves are held to; an exposure nobody can see in them.
Result<void> CaptureSource::apply_settings() {
  const int halves = setup_.arrangement == forms::CameraSetup::Arrangement::side_by_side ? 2 : 1;
  if (setup_.width > 0 || setup_.rate_hz > 0) {
    // Uncompressed, most cameras have no bandwidth for large or many images.
    capture_->set(cv::CAP_PROP_FOURCC, motion_jpeg);
  }
  if (setup_.width > 0) {
    capture_->set(cv::CAP_PROP_FRAME_WIDTH, halves * setup_.width);
    capture_->set(cv::CAP_PROP_FRAME_HEIGHT, setup_.height);
  }
  if (setup_.rate_hz > 0) capture_->set(cv::CAP_PROP_FPS, setup_.rate_hz);
  if (setup_.exposure_ms == 0) {
    capture_->set(cv::CAP_PROP_AUTO_EXPOSURE, automatic_exposure);
    return {};
  }
  const bool set = capture_->set(cv::CAP_PROP_AUTO_EXPOSURE, manual_exposure) &&
                   capture_->set(cv::CAP_PROP_EXPOSURE, setup_.exposure_ms * exposure_units_a_ms);
  if (set) return {};
  return fail("refused-setting", fmt::format("{} takes no exposure of {} ms", source_.where, setup_.exposure_ms));
}

Result<std::optional<double>> CaptureSource::grab() {
  bool grabbed = false;
  try {
    grabbed = capture_->grab();
  } catch (const cv::Exception&) {
    grabbed = false;
  }
  if (!grabbed) return fail("disconnected", fmt::format("{} gives no images", source_.where));
  // Devices of one machine share a clock; streams and pipelines begin when they like.
  if (source_.kind != forms::CameraSource::Kind::device) return std::nullopt;
  const double moment_ms = capture_->get(cv::CAP_PROP_POS_MSEC);
  return moment_ms > 0 ? std::optional(moment_ms) : std::nullopt;
}

Result<cv::Mat> CaptureSource::retrieve(bool /*grey*/) {
  cv::Mat image;
  try {
    if (!capture_->retrieve(image)) image.release();
  } catch (const cv::Exception&) {
    image.release();
  }
  return checked_image(std::move(image), "what " + source_.where + " gives");
}

}  // namespace pizarra::camera
