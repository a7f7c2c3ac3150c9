#include "drivers/simulation/simulated_camera.hpp"

#include <algorithm>

#include "drivers/simulation/camera_lens.hpp"

namespace pizarra::simulation {

namespace {

constexpr Duration image_time = 2s;
constexpr Duration ask_again_after = 1ms;
constexpr std::size_t plain_model = 6;  // numbers, before those of a lens
constexpr std::size_t bent_model = plain_model + LensDistortion().size();

bool is_model(const Datum& head) {
  const bool whole = head.size() == plain_model || head.size() == bent_model;
  return whole && std::ranges::all_of(head.items(), &Datum::is_number);
}

camera::StereoModel model_in(const Datum& head) {
  return {static_cast<int>(head[0].number()),
          static_cast<int>(head[1].number()),
          head[2].number(),
          head[3].number(),
          head[4].number(),
          head[5].number()};
}

camera::StereoCalibration calibration_in(const Datum& head) {
  CameraConfig camera;
  camera.model = model_in(head);
  for (std::size_t i = 0; i < camera.lens.size(); ++i) camera.lens[i] = head[plain_model + i].number();
  return calibration_of(camera);
}

// One image without its distortion.
std::shared_ptr<const Image> straightened(const Image& image, const camera::StereoGeometry& geometry,
                                          camera::StereoGeometry::Side side) {
  // Only read.
  const cv::Mat bent(image.height, image.width, CV_MAKETYPE(CV_8U, image.channels),
                     const_cast<std::uint8_t*>(image.pixels.data()));
  const cv::Mat straight = geometry.rectified(bent, side);
  return std::make_shared<const Image>(
      Image{straight.cols, straight.rows, straight.channels(), {straight.datastart, straight.dataend}});
}

bool fits(const std::shared_ptr<const Image>& image, bool colour) {
  if (!image || image->channels != (colour ? 3 : 1)) return false;
  const auto size = static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height);
  return image->pixels.size() == size * static_cast<std::size_t>(image->channels);
}

}  // namespace

Task<Result<camera::StereoModel>> SimulatedCamera::open() {
  const Datum request = list("camera"_sym, "open"_sym);
  const Result<Message> answer = co_await link_.call(request, image_time);
  if (!answer) co_return fail(answer);
  const Datum& head = answer->head;
  if (!is_model(head)) co_return fail("disconnected", "the camera answered nonsense", head);
  geometry_.reset();
  last_grey_ = 0;
  last_coloured_ = 0;
  if (head.size() > plain_model) geometry_.emplace(calibration_in(head));
  if (geometry_) co_return geometry_->model();
  co_return model_in(head);
}

Task<Result<camera::StereoFrame>> SimulatedCamera::next(Time after, bool colour) {
  const Time deadline = executor_.now() + image_time;
  std::uint64_t& last = colour ? last_coloured_ : last_grey_;
  while (executor_.now() < deadline) {
    const Result<camera::StereoFrame> frame = co_await ask(after, colour);
    if (!frame) co_return frame;
    if (frame->number != last) {
      last = frame->number;
      co_return frame;
    }
    co_await sleep(executor_, ask_again_after);
  }
  co_return fail("disconnected", "the camera gives the same frame again and again");
}

Task<Result<camera::StereoFrame>> SimulatedCamera::ask(Time after, bool colour) {
  const Datum kind = colour ? "colour"_sym : "grey"_sym;
  const Datum request = list("camera"_sym, "next"_sym, after.time_since_epoch().count(), kind);
  const Time asked = executor_.now();
  const Result<Message> answer = co_await link_.call(request, image_time);
  if (!answer) co_return fail(answer);
  const bool whole = answer->head.size() == 2 && answer->images.size() == 2 && fits(answer->images[0], colour) &&
                     fits(answer->images[1], colour);
  if (!whole) co_return fail("corrupt-frame", "the frame's images have other sizes than the camera's", answer->head);
  camera::StereoFrame frame;
  frame.number = static_cast<std::uint64_t>(answer->head[0].integer());
  // No frame is from before it was asked for, whatever the world's clock says.
  frame.captured = std::clamp(Time(Duration(answer->head[1].integer())), asked, executor_.now());
  frame.left = answer->images[0];
  frame.right = answer->images[1];
  if (geometry_) {
    using enum camera::StereoGeometry::Side;
    frame.left = straightened(*frame.left, *geometry_, left);
    frame.right = straightened(*frame.right, *geometry_, right);
  }
  co_return frame;
}

}  // namespace pizarra::simulation
