#include "tests/agents/vision/drawn_planes.hpp"

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/segmentation.hpp"
#include "agents/vision/objects/plane_look.hpp"
#include "agents/vision/sight/face_plane.hpp"

namespace pizarra::vision {

const Corners square = {{-half_mm, -half_mm}, {half_mm, -half_mm}, {half_mm, half_mm}, {-half_mm, half_mm}};
constexpr double arm = half_mm / 3;
const Corners cross = {{-arm, -half_mm}, {arm, -half_mm}, {arm, -arm}, {half_mm, -arm}, {half_mm, arm},   {arm, arm},
                       {arm, half_mm},   {-arm, half_mm}, {-arm, arm}, {-half_mm, arm}, {-half_mm, -arm}, {-arm, -arm}};

camera::StereoModel one_camera() {
  return {.width = 640, .height = 480, .focal_px = 600, .centre_x_px = 319.5, .centre_y_px = 239.5, .base_line_mm = 0};
}

cv::Matx33d turned_about(const cv::Vec3d& rad) {
  cv::Matx33d out;
  cv::Rodrigues(rad, out);
  return out;
}

cv::Mat1b filled(const Corners& corners, Random& random, double noise, int finer) {
  const cv::Rect around = cv::boundingRect(std::vector<cv::Point2f>(corners.begin(), corners.end())) + cv::Size(8, 8);
  std::vector<cv::Point> fine;
  constexpr int bits = 8;
  for (const cv::Point2d& p : corners) {
    const cv::Point2d at = finer * (p - cv::Point2d(around.tl()) + cv::Point2d(0.5, 0.5)) - cv::Point2d(0.5, 0.5);
    fine.emplace_back(cvRound(at.x * (1 << bits)), cvRound(at.y * (1 << bits)));
  }
  cv::Mat1f large(around.height * finer, around.width * finer, 200.F);
  cv::fillPoly(large, std::vector<std::vector<cv::Point>>{fine}, 25, cv::LINE_8, bits);
  cv::Mat1f image(480, 640, 200.F);
  cv::resize(large, image(around), around.size(), 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(image, image, {}, 0.7, 0.7);
  for (float& level : image) level += static_cast<float>(random.uniform(-1.7, 1.7) * noise);
  cv::Mat1b out;
  image.convertTo(out, CV_8U);
  return out;
}

Corners projected(const Corners& plane, const cv::Matx33d& turn, const cv::Vec3d& place) {
  Corners out;
  for (const cv::Point2d& p : plane) {
    const cv::Vec3d at = turn * cv::Vec3d(p.x, p.y, 0) + place;
    out.emplace_back(319.5 + 600 * at[0] / at[2], 239.5 + 600 * at[1] / at[2]);
  }
  return out;
}

LearnedSample learned(const Corners& plane, Random& random, double light) {
  cv::Mat1b image = filled(projected(plane, cv::Matx33d::eye(), {0, 0, 500}), random);
  for (int x = 0; x < image.cols; ++x) image.col(x) *= 1 + light * (x - image.cols / 2.0);
  ImageSegmentation segmentation(image);
  LearnedSample out;
  for (const SeenMark& mark : segmentation.marks()) {
    out.set_picture(template_from_picture(portray_mark(segmentation.cut(), mark.contour, mark.tone)->picture));
    out.contrast = print_contrast(mark);
    out.height_px = mark.height_px;
    out.area_px = mark.area_px;
    out.roundness = mark.roundness;
    const FrontView front = view_as_seen(to_image_of(mark), 500.0 / 600);
    out.size_mm = std::sqrt(front.area_mm2);
    out.size_by = LearnedSample::SizeBy::guessed_face;
    out.slimness = mark.slimness;
    if (!out.has_form()) out.axis_deg = front.axis_deg;
  }
  return out;
}

std::optional<Registered> registered(const cv::Mat1b& image, const LearnedSample& sample) {
  const ImageCut cut = look_at(image, {0, 0, image.cols, image.rows}, noise_of(image));
  for (const LevelRegion& region : level_regions(cut.pixels, sample.tone)) {
    const std::optional<PlaneFit> fit = fit_region(cut, sample, region.reach);
    if (!fit || !is_outline_of(*fit)) continue;
    const std::optional<PlanePose> pose = pose_in_plane(one_camera(), sample, *fit);
    if (pose) return Registered{*fit, *pose};
  }
  return std::nullopt;
}

Corners circle() {
  Corners out;
  for (int i = 0; i < 180; ++i) {
    out.push_back(half_mm * cv::Point2d(std::cos(i * CV_PI / 90), std::sin(i * CV_PI / 90)));
  }
  return out;
}

double degrees_between(const cv::Matx33d& a, const cv::Matx33d& b) {
  const cv::Vec3d one(a(0, 2), a(1, 2), a(2, 2));
  const cv::Vec3d other(b(0, 2), b(1, 2), b(2, 2));
  return std::acos(std::min(1.0, one.dot(other))) * 180 / CV_PI;
}

}  // namespace pizarra::vision
