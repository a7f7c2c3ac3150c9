#pragma once

// A stereo camera that shows a scene which the test may change, ten frames a second, and that can be unplugged.

#include <functional>

#include "blackboard/time/executor.hpp"
#include "tests/agents/vision/scene.hpp"

namespace pizarra::vision {

class FakeCamera : public camera::StereoCamera {
 public:
  FakeCamera(Executor& executor, std::uint64_t seed) : executor_(executor), random_(seed) {}

  Scene scene;
  // Drawn over what the pair shows, so many px further left by the right image.
  struct Picture {
    cv::Mat1b grey;
    cv::Point at;
    int disparity_px = 60;
  };
  std::vector<Picture> pictures = {};
  bool plugged = true;
  int opened = 0;
  int colour_asked = 0;
  bool moves_on = false;  // gives no frame twice, as a simulated one
  camera::CameraDrops dropped = {};

  Task<Result<camera::StereoModel>> open() override {
    ++opened;
    if (!plugged) co_return fail("disconnected", "the camera is unplugged");
    co_return model_;
  }

  Task<Result<camera::StereoFrame>> next(Time after, bool colour) override {
    if (taken_ <= after || moves_on) {
      co_await sleep(executor_, 100ms);
      ++number_;
      taken_ = executor_.now();
    }
    if (!plugged) co_return fail("disconnected", "the camera is unplugged");
    camera::StereoFrame frame = draw_scene(scene, model_, number_, random_);
    for (const Picture& picture : pictures) {
      frame.left = pasted(*frame.left, picture.grey, picture.at);
      frame.right = pasted(*frame.right, picture.grey, picture.at - cv::Point(picture.disparity_px, 0));
    }
    frame.captured = taken_;
    colour_asked += colour ? 1 : 0;
    if (colour) frame.left = in_colour(*frame.left);
    co_return frame;
  }

  camera::CameraDrops drops() const override { return dropped; }

  const camera::StereoModel& model() const { return model_; }
  void resize(int width, int height) {
    model_.width = width;
    model_.height = height;
  }
  // The same view in more pixels, or in fewer.
  void magnify(double scale) {
    resize(cvRound(scale * model_.width), cvRound(scale * model_.height));
    model_.focal_px *= scale;
    model_.centre_x_px = (model_.width - 1) / 2.0;
    model_.centre_y_px = (model_.height - 1) / 2.0;
  }

 private:
  static std::shared_ptr<const Image> pasted(Image image, const cv::Mat1b& picture, cv::Point at) {
    for (int y = 0; y < picture.rows; ++y) {
      std::uint8_t* row = image.pixels.data() + (at.y + y) * image.width + at.x;
      std::copy_n(picture.ptr<std::uint8_t>(y), picture.cols, row);
    }
    return std::make_shared<Image>(std::move(image));
  }
  // A little less blue than grey is.
  static std::shared_ptr<const Image> in_colour(const Image& grey) {
    auto image = std::make_shared<Image>(Image{grey.width, grey.height, 3, {}});
    for (const std::uint8_t pixel : grey.pixels) {
      const std::uint8_t blue = pixel - pixel / 8;
      image->pixels.insert(image->pixels.end(), {blue, pixel, pixel});
    }
    return image;
  }

  Executor& executor_;
  Random random_;
  camera::StereoModel model_;
  std::uint64_t number_ = 0;
  Time taken_{};
};

}  // namespace pizarra::vision
