#include "drivers/camera/camera_reading.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "drivers/camera/image_pace.hpp"
#include "drivers/camera/stereo_geometry.hpp"

namespace pizarra::camera {
namespace {

using Side = StereoGeometry::Side;

constexpr int most_corrupt_in_a_row = 20;

std::shared_ptr<const Image> shared_image(const cv::Mat& image) {
  auto out = std::make_shared<Image>(Image{image.cols, image.rows, image.channels(), {}});
  const std::size_t row_bytes = image.cols * image.elemSize();
  out->pixels.reserve(row_bytes * static_cast<std::size_t>(image.rows));
  for (int y = 0; y < image.rows; ++y) out->pixels.insert(out->pixels.end(), image.ptr(y), image.ptr(y) + row_bytes);
  return out;
}

cv::Mat with_channels(const cv::Mat& image, int channels) {
  if (image.channels() == channels) return image;
  cv::Mat out;
  cv::cvtColor(image, out, channels == 1 ? cv::COLOR_BGR2GRAY : cv::COLOR_GRAY2BGR);
  return out;
}

class Reading {
 public:
  Reading(const CameraReading& reading, FrameDesk& desk)
      : setup_(reading.setup),
        calibration_(reading.calibration),
        now_(reading.now),
        desk_(desk),
        reader_(setup_, reading.sources(), now_) {}

  Failure run() {
    Result<void> going = reader_.open();
    ImagePace pace(reader_.recorded_hz() > 0 ? reader_.recorded_hz() : setup_.rate_hz, now_());
    while (going && !desk_.closing(now_())) {
      if (reader_.recorded_hz() > 0) desk_.wait(pace.until_due(now_()));
      going = reader_.grab();
      desk_.count_skewed(reader_.skewed());
      if (going && !pace.is_due(now_())) continue;
      pace.taken(now_());
      if (going) going = take_frame();
      if (!going && going.error().symbol == "corrupt-frame") going = leave_out(describe(going.error()));
    }
    reader_.close();
    return going ? Failure{"disconnected", "the camera was closed: nobody asked for its images", {}, {}}
                 : going.error();
  }

 private:
  Result<void> take_frame() {
    Result<StereoImages> images = reader_.retrieve(true);
    if (!images) return fail(images);
    const Result<void> known = know(images->left.size());
    if (!known) return known;
    DeskFrame frame;
    frame.grey = {0, images->captured, seen(images->left, Side::left, 1), seen(images->right, Side::right, 1)};
    if (desk_.colour_wanted()) {
      const bool has_colour = setup_.grey || images->left.channels() == 3;
      if (!has_colour) images = reader_.retrieve(false);
      if (!images) return fail(images);
      frame.colour_left = seen(images->left, Side::left, 3);
      frame.colour_right = seen(images->right, Side::right, 3);
    }
    desk_.put(std::move(frame), geometry_->model());
    corrupt_in_a_row_ = 0;
    return {};
  }

  Result<void> leave_out(const std::string& why) {
    desk_.leave_out(now_(), why);
    if (++corrupt_in_a_row_ < most_corrupt_in_a_row) return {};
    return fail("disconnected", why);
  }

  // The first image says how large all are.
  Result<void> know(cv::Size size) {
    if (geometry_) {
      const StereoModel& model = geometry_->model();
      if (size == cv::Size(model.width, model.height)) return {};
      return fail("corrupt-frame", fmt::format("the camera's image is {}x{}, and those before were {}x{}", size.width,
                                               size.height, model.width, model.height));
    }
    Result<StereoGeometry> geometry = StereoGeometry::make(setup_, calibration_, size);
    if (!geometry) return fail(geometry);
    geometry_ = std::move(*geometry);
    return {};
  }

  std::shared_ptr<const Image> seen(const cv::Mat& image, Side side, int channels) {
    if (image.empty()) return nothing_seen(channels);
    return shared_image(geometry_->rectified(with_channels(image, channels), side));
  }

  // What the right camera shows where there is none.
  std::shared_ptr<const Image> nothing_seen(int channels) {
    std::shared_ptr<const Image>& image = channels == 1 ? nothing_grey_ : nothing_coloured_;
    const StereoModel& model = geometry_->model();
    const auto bytes = static_cast<std::size_t>(model.width) * static_cast<std::size_t>(model.height * channels);
    if (!image) {
      image = std::make_shared<Image>(Image{model.width, model.height, channels, std::vector<std::uint8_t>(bytes)});
    }
    return image;
  }

  const forms::CameraSetup& setup_;
  const std::optional<StereoCalibration>& calibration_;
  const std::function<Time()>& now_;
  FrameDesk& desk_;
  StereoReader reader_;
  int corrupt_in_a_row_ = 0;
  std::optional<StereoGeometry> geometry_;
  std::shared_ptr<const Image> nothing_grey_;
  std::shared_ptr<const Image> nothing_coloured_;
};

}  // namespace

void read_camera(const CameraReading& reading, FrameDesk& desk) {
  Failure why = Reading(reading, desk).run();
  desk.end(std::move(why));
}

}  // namespace pizarra::camera
