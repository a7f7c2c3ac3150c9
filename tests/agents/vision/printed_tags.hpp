#pragma once

// Eyes before printed tags of 36h11, square to the cameras, all at one distance.
//
//   class Tagged : public PrintedTags {};
//   TEST_F(Tagged, ...) { show(17, {80, 60}); live_with({.tagged = {...}}); }

#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tag_detection.hpp"
#include "tests/agents/vision/vision_life.hpp"

namespace pizarra::vision {

class PrintedTags : public Vision {
 protected:
  static constexpr int cell_px = 6;
  static constexpr double tag_px = 8 * cell_px;  // of 36h11, with its border
  static constexpr double disparity_px = 60;

  PrintedTags() { camera.scene.faces = {}; }
  double depth_mm() const { return camera.model().focal_px * camera.model().base_line_mm / disparity_px; }
  double side_mm() const { return tag_px * depth_mm() / camera.model().focal_px; }
  void live_with(VisionOptions options) {
    life.reset();
    life.emplace(executor, board, camera, &streams, std::move(options));
  }
  // Shows a tag on light ground, its upper left cell at that pixel.
  void show(int number, cv::Point at, std::string_view family = "apriltag-36h11") {
    cv::Mat1b print;
    cv::resize(print_of(*family_called(family), number), print, {}, cell_px, cell_px, cv::INTER_NEAREST);
    cv::Mat1b on_ground;
    const int around = 2 * cell_px;
    cv::copyMakeBorder(print, on_ground, around, around, around, around, cv::BORDER_CONSTANT, 255);
    on_ground = 30 + on_ground * (200.0 / 255);
    camera.pictures.push_back({on_ground, at - cv::Point(around, around), static_cast<int>(disparity_px)});
  }
};

}  // namespace pizarra::vision
