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

struct Patch {
  Outline outline;  // px from the image's left upper corner
  int level = 0;
};

// The patches of a scene as one camera sees them, later ones over earlier ones.
class Projection {
 public:
  Projection(const camera::StereoModel& model, bool right) : model_(model), right_(right) {}

  void add(const SceneFace& face, const Outline& outline, int turns, int level) {
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
    patches_.push_back({std::move(seen), level});
  }
  void add(const SceneBlot& blot) {
    const cv::Point2d half(blot.box.width / 2, blot.box.height / 2);
    const cv::Point2d moved(right_ ? blot.disparity_px : 0, 0);
    Outline seen = turned(box(-half.x, -half.y, half.x, half.y), blot.turn_deg);
    for (cv::Point2d& p : seen) p += blot.box.tl() + half - moved;
    patches_.push_back({std::move(seen), blot.level});
  }
  // Only the pixels that a patch touches are drawn finely: a scene is mostly ground.
  cv::Mat1b painted(int ground) const {
    cv::Mat1b image(model_.height, model_.width, static_cast<std::uint8_t>(ground));
    const cv::Rect touched = touched_pixels();
    if (touched.empty()) return image;
    cv::Mat1b fine(touched.height * oversampling, touched.width * oversampling, static_cast<std::uint8_t>(ground));
    for (const Patch& patch : patches_) fill(fine, patch, touched.tl());
    cv::resize(fine, image(touched), touched.size(), 0, 0, cv::INTER_AREA);
    return image;
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
  cv::Rect touched_pixels() const {
    cv::Rect out;
    for (const Patch& patch : patches_) {
      for (const cv::Point2d& p : patch.outline) {
        out |= cv::Rect(static_cast<int>(std::floor(p.x)) - 1, static_cast<int>(std::floor(p.y)) - 1, 3, 3);
      }
    }
    return out & cv::Rect(0, 0, model_.width, model_.height);
  }
  static void fill(cv::Mat1b& fine, const Patch& patch, cv::Point2d from) {
    if (patch.outline.empty()) return;
    std::vector<cv::Point> polygon;
    // fillPoly takes 1/16 px here and covers sample centres.
    for (const cv::Point2d& at : patch.outline) {
      const cv::Point2d p = at - from;
      polygon.emplace_back(static_cast<int>(std::lround((p.x * oversampling - 0.5) * 16)),
                           static_cast<int>(std::lround((p.y * oversampling - 0.5) * 16)));
    }
    cv::fillPoly(fine, std::vector<std::vector<cv::Point>>{polygon}, patch.level, cv::LINE_8, 4);
  }

  const camera::StereoModel& model_;
  bool right_;
  std::vector<Patch> patches_;
};

// Independent normal numbers of this spread: Random::normal() for all pixels at once.
cv::Mat1f normal_image(cv::Size size, double spread, Random& random) {
  cv::Mat1f radius(size);
  cv::Mat1f turn(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      radius(y, x) = static_cast<float>(1 - random.uniform(0, 1));
      turn(y, x) = static_cast<float>(2 * CV_PI * random.uniform(0, 1));
    }
  }
  cv::log(radius, radius);
  radius *= -2 * spread * spread;
  cv::sqrt(radius, radius);
  cv::Mat1f out;
  cv::Mat1f unused;
  cv::polarToCart(radius, turn, out, unused);
  return out;
}

std::shared_ptr<const Image> draw(const Scene& scene, const camera::StereoModel& model, bool right, Random& random) {
  Projection projection(model, right);
  for (const SceneFace& face : scene.faces) {
    const bool plate = face.mark == "plate";
    projection.add(face, plate ? box(-29, -34, 29, 22) : box(-30, -30, 30, 30), 0, plate ? 45 : 225);
    projection.add(face, outline_of(face.mark), face.quarter_turns, plate ? 225 : 25);
  }
  for (const SceneBlot& blot : scene.blots) projection.add(blot);
  cv::Mat1f light;
  projection.painted(scene.ground).convertTo(light, CV_32F);
  if (scene.blur_px > 0) cv::GaussianBlur(light, light, {7, 7}, scene.blur_px);
  cv::Mat1f across(1, model.width);
  for (int x = 0; x < model.width; ++x) across(x) = static_cast<float>(1 - scene.gradient * x / model.width);
  cv::multiply(light, cv::repeat(across, model.height, 1), light);
  if (scene.noise > 0) light += normal_image(light.size(), scene.noise, random);
  auto image = std::make_shared<Image>();
  image->width = model.width;
  image->height = model.height;
  image->pixels.resize(light.total());
  cv::Mat1b pixels(model.height, model.width, image->pixels.data());
  light.convertTo(pixels, CV_8U);
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
