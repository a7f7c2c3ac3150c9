#include "tests/agents/vision/photograph.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/bench/vision/outline.hpp"

namespace pizarra::vision {
namespace {

constexpr double desk_level = 95;
constexpr double light_level = 205;
constexpr double dark_level = 28;
constexpr double key_level = 45;
constexpr double skin_level = 150;
constexpr double paper_width_mm = 230;
constexpr double paper_height_mm = 170;

double radians(double degrees) { return degrees * CV_PI / 180; }

// From the sheet, its middle at the origin, to the camera, which looks along z.
cv::Point3d in_camera(const Photograph& photograph, cv::Point2d p) {
  const double roll = radians(photograph.roll_deg);
  const cv::Point2d rolled(p.x * std::cos(roll) - p.y * std::sin(roll), p.x * std::sin(roll) + p.y * std::cos(roll));
  const double pan = radians(photograph.pan_deg);
  const double tilt = radians(photograph.tilt_deg);
  const double x = rolled.x * std::cos(pan);
  const double z = rolled.x * std::sin(pan);
  return {x + photograph.aside_mm.x, rolled.y * std::cos(tilt) + photograph.aside_mm.y,
          z - rolled.y * std::sin(tilt) + photograph.distance_mm};
}

bench::Shape projected(const Photograph& photograph, const bench::Shape& shape, cv::Point2d at_mm) {
  bench::Shape out(shape);
  for (bench::Outline& outline : out) {
    for (cv::Point2d& p : outline) p = photograph.project(p + at_mm);
  }
  return out;
}

// Multiplies the picture with what light falls on it.
void light_up(cv::Mat1f& picture, const Photograph& photograph) {
  const double reach = std::hypot(picture.cols, picture.rows) / 2;
  const double edge_px = 0.1 * picture.cols;
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      const double across = static_cast<double>(x) / picture.cols - 0.5;
      const double away = std::hypot(x - picture.cols / 2.0, y - picture.rows / 2.0) / reach;
      const double into_shadow = std::clamp((y - x - 0.25 * picture.rows) / edge_px, -0.5, 0.5);
      const double shaded = 1 - (1 - photograph.shadow) * (into_shadow + 0.5);
      const double light = photograph.light * (1 - photograph.slope * across) * (1 - 0.25 * away * away) * shaded;
      picture(y, x) *= static_cast<float>(light);
    }
  }
}

// Drawn once; each row of each picture reads them from a place of its own.
const std::vector<float>& normal_numbers() {
  static const std::vector<float> numbers = [] {
    Random random(77);
    std::vector<float> out(1 << 16);
    for (float& number : out) number = static_cast<float>(random.normal());
    return out;
  }();
  return numbers;
}

// On the desk, its keys dark, left of the sheet and right of it; and what holds the sheet.
void paint_clutter(cv::Mat1f& picture, const Photograph& photograph) {
  const auto put = [&](const bench::Shape& shape, cv::Point2d at_mm, double level) {
    bench::paint(picture, projected(photograph, shape, at_mm), static_cast<float>(level));
  };
  for (const double side : {-1.0, 1.0}) {
    put(bench::box(70, 200), {side * 160, 0}, light_level - 40);
    for (int row = -4; row <= 4; ++row) {
      for (const int column : {-1, 0, 1}) put(bench::box(16, 16), {side * 160 + 19.0 * column, 19.0 * row}, key_level);
    }
  }
  for (const double x : {-8.0, 12.0}) put(bench::box(16, 70), {x, paper_height_mm / 2 + 18}, skin_level);
}

}  // namespace

const std::vector<PrintedShape>& printed_shapes() {
  static const std::vector<PrintedShape> shapes = {
      {"circle", {-45, -35}}, {"triangle", {45, -35}}, {"square", {-45, 35}}, {"cross", {45, 35}}};
  return shapes;
}

cv::Point2d Photograph::project(cv::Point2d sheet_mm) const {
  const cv::Point3d p = in_camera(*this, sheet_mm);
  return {(size.width - 1) / 2.0 + focal_px() * p.x / p.z, (size.height - 1) / 2.0 + focal_px() * p.y / p.z};
}

double Photograph::range_mm(cv::Point2d sheet_mm) const { return cv::norm(in_camera(*this, sheet_mm)); }

cv::Point2d Photograph::seen_at(const std::string& shape) const {
  const auto found = std::ranges::find(shapes, shape, &PrintedShape::name);
  return project(found->at_mm);
}

cv::Mat3b Photograph::take(Random& random) const {
  cv::Mat1f picture(size, static_cast<float>(desk_level));
  bench::paint(picture, projected(*this, bench::box(paper_width_mm, paper_height_mm), {0, 0}),
               static_cast<float>(light_on_dark ? dark_level : light_level));
  for (const PrintedShape& shape : shapes) {
    const bench::Shape outline = bench::placed(bench::mark_shape(shape.name), {0, 0}, shape.scale, shape.turn_deg);
    bench::paint(picture, projected(*this, outline, shape.at_mm),
                 static_cast<float>(light_on_dark ? light_level : dark_level));
  }
  if (cluttered) paint_clutter(picture, *this);
  cv::GaussianBlur(picture, picture, {0, 0}, blur_px);
  light_up(picture, *this);
  const std::vector<float>& normal = normal_numbers();
  cv::Mat3b out(size);
  for (int y = 0; y < size.height; ++y) {
    const float* number = normal.data() + random.below(normal.size() - 3 * static_cast<std::size_t>(size.width));
    for (int x = 0; x < size.width; ++x) {
      // A warm lamp: blue is darker than red.
      for (int channel = 0; channel < 3; ++channel) {
        const double tint = 0.88 + 0.08 * channel;
        out(y, x)[channel] = cv::saturate_cast<std::uint8_t>(picture(y, x) * tint + noise * *number++);
      }
    }
  }
  std::vector<std::uint8_t> file;
  cv::imencode(".jpg", out, file, {cv::IMWRITE_JPEG_QUALITY, jpeg_quality});
  return cv::imdecode(file, cv::IMREAD_COLOR);
}

}  // namespace pizarra::vision
