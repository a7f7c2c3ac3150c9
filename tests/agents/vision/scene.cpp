#include "tests/agents/vision/scene.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace pizarra::vision {
namespace {

constexpr int oversampling = 8;

using Outline = std::vector<cv::Point2d>;  // mm around the centroid, y down

Outline box(double left, double top, double right, double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

Outline outline_of(const std::string& mark) {
  if (mark == "square") return box(-22, -22, 22, 22);
  if (mark == "bar") return box(-22, -11, 22, 11);
  if (mark == "thin-bar") return box(-24, -8, 24, 8);
  if (mark == "triangle" || mark == "plate") return {{0, -37 * 2 / 3.0}, {22, 37 / 3.0}, {-22, 37 / 3.0}};
  if (mark == "cross") {
    const double a = 22;
    const double b = 44 / 6.0;
    return {{-b, -a}, {b, -a}, {b, -b}, {a, -b}, {a, b}, {b, b}, {b, a}, {-b, a}, {-b, b}, {-a, b}, {-a, -b}, {-b, -b}};
  }
  if (mark != "circle") return {};
  Outline out;
  for (int i = 0; i < 90; ++i) out.emplace_back(22 * std::cos(i * CV_PI / 45), 22 * std::sin(i * CV_PI / 45));
  return out;
}

class Painter {
 public:
  Painter(cv::Mat& canvas, const camera::StereoModel& model, bool right)
      : canvas_(canvas), model_(model), right_(right) {}

  void fill(const SceneFace& face, const Outline& outline, int turns, int level) {
    const double yaw = face.yaw_deg * CV_PI / 180;
    const double pitch = face.pitch_deg * CV_PI / 180;
    Outline seen;
    for (const cv::Point2d& at : turned(outline, face.roll_deg + 90 * turns)) {
      const cv::Point2d p = face.scale * at;
      const cv::Point3d tilted(p.x * std::cos(yaw), p.y * std::cos(pitch) + p.x * std::sin(yaw) * std::sin(pitch),
                               p.x * std::sin(yaw) * std::cos(pitch) - p.y * std::sin(pitch));
      const cv::Point3d point = face.place + tilted;
      // Pixel (0, 0) covers -0.5 to 0.5.
      seen.push_back(project(model_, point, right_) + cv::Point2d(0.5, 0.5));
    }
    fill(seen, level);
  }
  void fill(const SceneBlot& blot) {
    const cv::Point2d half(blot.box.width / 2, blot.box.height / 2);
    const cv::Point2d moved(right_ ? blot.disparity_px : 0, 0);
    Outline seen = turned(box(-half.x, -half.y, half.x, half.y), blot.turn_deg);
    for (cv::Point2d& p : seen) p += blot.box.tl() + half - moved;
    fill(seen, blot.level);
  }

 private:
  static Outline turned(const Outline& outline, double degrees) {
    const double turn = degrees * CV_PI / 180;
    Outline out;
    for (const cv::Point2d& p : outline) {
      out.emplace_back(std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y);
    }
    return out;
  }
  // From the image's left upper corner, px.
  void fill(const Outline& outline, int level) {
    if (outline.empty()) return;
    std::vector<cv::Point> polygon;
    // fillPoly takes 1/16 px here and covers sample centres.
    for (const cv::Point2d& p : outline) {
      polygon.emplace_back(static_cast<int>(std::lround((p.x * oversampling - 0.5) * 16)),
                           static_cast<int>(std::lround((p.y * oversampling - 0.5) * 16)));
    }
    cv::fillPoly(canvas_, std::vector<std::vector<cv::Point>>{polygon}, level, cv::LINE_8, 4);
  }

  cv::Mat& canvas_;
  const camera::StereoModel& model_;
  bool right_;
};

std::shared_ptr<const Image> draw(const Scene& scene, const camera::StereoModel& model, bool right, Random& random) {
  cv::Mat canvas(model.height * oversampling, model.width * oversampling, CV_8UC1, scene.ground);
  Painter painter(canvas, model, right);
  for (const SceneFace& face : scene.faces) {
    const bool plate = face.mark == "plate";
    painter.fill(face, plate ? box(-29, -34, 29, 22) : box(-30, -30, 30, 30), 0, plate ? 45 : 225);
    painter.fill(face, outline_of(face.mark), face.quarter_turns, plate ? 225 : 25);
  }
  for (const SceneBlot& blot : scene.blots) painter.fill(blot);
  cv::Mat small;
  cv::resize(canvas, small, {model.width, model.height}, 0, 0, cv::INTER_AREA);
  cv::Mat1f light;
  small.convertTo(light, CV_32F);
  if (scene.blur_px > 0) cv::GaussianBlur(light, light, {7, 7}, scene.blur_px);
  auto image = std::make_shared<Image>();
  image->width = model.width;
  image->height = model.height;
  image->pixels.reserve(static_cast<std::size_t>(model.width * model.height));
  for (int y = 0; y < model.height; ++y) {
    for (int x = 0; x < model.width; ++x) {
      const double value =
          light(y, x) * (1 - scene.gradient * x / model.width) + (scene.noise > 0 ? scene.noise * random.normal() : 0);
      image->pixels.push_back(cv::saturate_cast<std::uint8_t>(value));
    }
  }
  return image;
}

}  // namespace

cv::Point2d project(const camera::StereoModel& model, const cv::Point3d& point, bool right) {
  const double offset_mm = (right ? -0.5 : 0.5) * model.base_line_mm;
  return {model.centre_x_px + model.focal_px * (point.x + offset_mm) / point.z,
          model.centre_y_px + model.focal_px * point.y / point.z};
}

camera::StereoFrame draw_scene(const Scene& scene, const camera::StereoModel& model, std::uint64_t number,
                               Random& random) {
  camera::StereoFrame out;
  out.number = number;
  out.left = draw(scene, model, false, random);
  out.right = draw(scene, model, true, random);
  return out;
}

cv::Mat as_mat(const Image& image) {
  const cv::Mat view(image.height, image.width, CV_8UC(image.channels), const_cast<std::uint8_t*>(image.pixels.data()));
  return view.clone();
}

}  // namespace pizarra::vision
