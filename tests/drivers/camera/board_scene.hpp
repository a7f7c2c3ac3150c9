#pragma once

// A pair of cameras with known lenses before a chessboard, drawn ray by ray: what a calibration must find again.

#include <opencv2/calib3d.hpp>
#include <opencv2/core/affine.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "drivers/camera/calibration.hpp"

namespace pizarra::camera {

struct BoardScene {
  cv::Size size{480, 360};
  cv::Matx33d left{400, 0, 243, 0, 401, 176, 0, 0, 1};
  cv::Matx33d right{405, 0, 236, 0, 404, 183, 0, 0, 1};
  cv::Vec<double, 5> distortion{-0.22, 0.06, 0.001, -0.0005, 0};
  // From the left camera to the right one.
  cv::Affine3d between{cv::Vec3d(0.01, -0.03, 0.008), cv::Vec3d(-82, 1.5, 2)};
  CalibrationBoard board;
  // The image of the board's squares, all of them, so many px a square; empty: a chessboard.
  cv::Mat1b picture = {};

  // In the board's own frame.
  cv::Vec3d corner(std::size_t index) const {
    const auto i = static_cast<int>(index);
    return {i % board.columns * board.square_mm, i / board.columns * board.square_mm, 0};
  }

  // `pose` from the board to the left camera.
  cv::Mat1b draw(const cv::Affine3d& pose, bool from_right) const {
    constexpr int samples = 3;  // a pixel, each way
    const cv::Affine3d board_to_camera = from_right ? between * pose : pose;
    const cv::Affine3d camera_to_board = board_to_camera.inv();
    const cv::Vec3d eye = camera_to_board * cv::Vec3d(0, 0, 0);
    cv::Mat1f fine(samples * size.height, samples * size.width);
    const std::vector<cv::Point2d>& rays = from_right ? right_rays(samples) : left_rays(samples);
    for (int y = 0; y < fine.rows; ++y) {
      for (int x = 0; x < fine.cols; ++x) {
        const cv::Point2d& ray = rays[static_cast<std::size_t>(y * fine.cols + x)];
        const cv::Vec3d along = camera_to_board.rotation() * cv::Vec3d(ray.x, ray.y, 1);
        const cv::Vec3d there = eye - along * (eye[2] / along[2]);
        fine(y, x) = level(there[0] / board.square_mm, there[1] / board.square_mm);
      }
    }
    cv::Mat1b out;
    cv::resize(fine, fine, size, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(fine, fine, {0, 0}, 0.6);
    fine.convertTo(out, CV_8U);
    return out;
  }

 private:
  // One square all around the inner corners, then paper, then a grey wall.
  float level(double x, double y) const {
    const bool paper = x > -2 && y > -2 && x < board.columns + 1 && y < board.rows + 1;
    if (!paper) return 120;
    const bool squares = x > -1 && y > -1 && x < board.columns && y < board.rows;
    const bool dark = squares && (picture.empty() ? (cvFloor(x) + cvFloor(y)) % 2 == 0 : is_dark(x + 1, y + 1));
    return dark ? 35 : 215;
  }
  bool is_dark(double x, double y) const {
    const int square_px = picture.cols / (board.columns + 1);
    return picture(cvFloor(y * square_px), cvFloor(x * square_px)) < 128;
  }
  const std::vector<cv::Point2d>& left_rays(int samples) const {
    static const std::vector<cv::Point2d> rays = rays_of(left, samples);
    return rays;
  }
  const std::vector<cv::Point2d>& right_rays(int samples) const {
    static const std::vector<cv::Point2d> rays = rays_of(right, samples);
    return rays;
  }
  std::vector<cv::Point2d> rays_of(const cv::Matx33d& camera, int samples) const {
    std::vector<cv::Point2d> points;
    for (int y = 0; y < samples * size.height; ++y) {
      for (int x = 0; x < samples * size.width; ++x) {
        points.emplace_back((x + 0.5) / samples - 0.5, (y + 0.5) / samples - 0.5);
      }
    }
    std::vector<cv::Point2d> out;
    cv::undistortPoints(points, out, camera, distortion);
    return out;
  }
};

// The board's places before the cameras: all over the image, turned every way.
inline std::vector<cv::Affine3d> board_poses() {
  std::vector<cv::Affine3d> out;
  const cv::Vec3d turns[] = {{0.35, 0, 0}, {-0.35, 0.1, 0.1}, {0, 0.4, -0.1}, {0.1, -0.4, 0.05}, {0.3, 0.3, 0.2}};
  const cv::Vec3d places[] = {{-100, -70, 480}, {-190, -110, 620}, {-20, -110, 600}, {-190, -20, 640},
                              {0, -10, 620},    {-90, -60, 560},   {-100, -60, 760}};
  int turn = 0;
  for (const cv::Vec3d& place : places) {
    for (int i = 0; i < 2; ++i) out.emplace_back(turns[turn++ % 5], place);
  }
  return out;
}

}  // namespace pizarra::camera
