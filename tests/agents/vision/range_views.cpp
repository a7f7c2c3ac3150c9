#include "tests/agents/vision/range_views.hpp"

#include <cmath>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/vision/sight/mark_learner.hpp"

namespace pizarra::vision {
namespace {

constexpr float ground_level = 165;
constexpr float mark_level = 25;
constexpr double reach_mm = 32;
constexpr int margin_px = 10;

const char* const marks[] = {"circle", "square", "cross", "triangle"};

bench::Shape shape_called(const std::string& mark) {
  if (mark != "tag") return bench::mark_shape(mark);
  cv::Mat drawn;
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  dictionary->drawMarker(17, dictionary->markerSize + 2, drawn);
  return bench::tag_shape(drawn == 0, 44);
}

double radians(double degrees) { return degrees * CV_PI / 180; }

// Turned about the line of sight, then about the vertical, then about the horizontal.
cv::Point3d turned(const RangeView& view, cv::Point2d p) {
  const double roll = radians(view.roll_deg);
  const double yaw = radians(view.yaw_deg);
  const double pitch = radians(view.pitch_deg);
  const cv::Point2d q(std::cos(roll) * p.x - std::sin(roll) * p.y, std::sin(roll) * p.x + std::cos(roll) * p.y);
  const cv::Point3d yawed(q.x * std::cos(yaw), q.y, q.x * std::sin(yaw));
  return {yawed.x, yawed.y * std::cos(pitch) + yawed.z * std::sin(pitch),
          yawed.z * std::cos(pitch) - yawed.y * std::sin(pitch)};
}

void learn(LearnedObjects& objects, const RangeViews& views, const std::string& mark, double depth_mm, int number) {
  Random random = Random(5).split(mark);
  const RangeView view{.mark = mark, .place = {0, 0, depth_mm}, .noise = 2, .blur_px = 0.7};
  MarkLearner learner(mark, views.seen_at(view.place, false), objects);
  while (!learner.done()) {
    StereoSight sight(views.draw(view, false, random), views.draw(view, true, random), views.camera);
    learner.feed(sight).value();
  }
  LearnedSample sample = learner.sample();
  sample.number = number;
  objects.add(mark, std::move(sample));
}

// Shapes as near and as far as they are told apart, from half to 1.8 times as high as learned.
LearnedObjects learned_by(const RangeViews& views) {
  LearnedObjects out;
  for (const char* mark : marks) {
    int number = 0;
    for (const double depth_mm : {400, 750, 1100}) learn(out, views, mark, depth_mm, ++number);
  }
  learn(out, views, "tag", 400, 1);
  return out;
}

}  // namespace

RangeViews::RangeViews(const camera::StereoModel& seen_by) : camera(seen_by), learned_(learned_by(*this)) {}

RangeViews::RangeViews(const camera::StereoModel& seen_by, LearnedObjects learned)
    : camera(seen_by), learned_(std::move(learned)) {}

cv::Point2d RangeViews::seen_at(const cv::Point3d& point, bool right) const {
  const double beside_mm = (right ? -0.5 : 0.5) * camera.base_line_mm;
  return {camera.centre_x_px + camera.focal_px * (point.x + beside_mm) / point.z,
          camera.centre_y_px + camera.focal_px * point.y / point.z};
}

bench::Shape RangeViews::shape_of(const RangeView& view, bool right) const {
  bench::Shape out = shape_called(view.mark);
  for (bench::Outline& outline : out) {
    for (cv::Point2d& p : outline) p = seen_at(view.place + turned(view, p), right);
  }
  return out;
}

// Anywhere where both images show the whole of it.
RangeView RangeViews::random_view(const RangeConditions& conditions, Random& random) const {
  RangeView out;
  out.mark = marks[random.below(std::size(marks))];
  const double depth_mm = random.uniform(conditions.least_mm, conditions.most_mm);
  const double mm_per_px = depth_mm / camera.focal_px;
  const double margin_mm = reach_mm + margin_px * mm_per_px;
  const double left_mm = -camera.centre_x_px * mm_per_px + margin_mm + camera.base_line_mm / 2;
  const double right_mm = (camera.width - 1 - camera.centre_x_px) * mm_per_px - margin_mm - camera.base_line_mm / 2;
  const double down_mm = (camera.height - 1) / 2.0 * mm_per_px - margin_mm;
  out.place = {random.uniform(left_mm, right_mm), random.uniform(-down_mm, down_mm), depth_mm};
  out.yaw_deg = random.uniform(-1, 1) * conditions.most_tilt_deg;
  out.pitch_deg = random.uniform(-1, 1) * conditions.most_tilt_deg;
  out.roll_deg = random.uniform(-1, 1) * conditions.most_roll_deg;
  out.noise = random.uniform(conditions.least_noise, conditions.most_noise);
  out.blur_px = random.uniform(conditions.least_blur_px, conditions.most_blur_px);
  const double direction = random.uniform(0, 2 * CV_PI);
  out.light_slope = conditions.most_light_slope * cv::Point2d(std::cos(direction), std::sin(direction));
  return out;
}

cv::Mat1b RangeViews::draw(const RangeView& view, bool right, Random& random) const {
  cv::Mat1f image(camera.height, camera.width, ground_level);
  bench::paint(image, shape_of(view, right), mark_level);
  bench::Shape cover = view.cover;
  for (bench::Outline& outline : cover) {
    for (cv::Point2d& p : outline) p.x -= right ? view.cover_disparity_px : 0;
  }
  if (!cover.empty()) bench::paint(image, cover, static_cast<float>(view.cover_level));
  if (view.blur_px > 0) cv::GaussianBlur(image, image, {13, 13}, view.blur_px, view.blur_px, cv::BORDER_REPLICATE);
  for (int y = 0; y < image.rows; ++y) {
    const double down = view.light_slope.y * (y - image.rows / 2.0) / image.cols;
    for (int x = 0; x < image.cols; ++x) {
      image(y, x) *= static_cast<float>(1 + down + view.light_slope.x * (x - image.cols / 2.0) / image.cols);
    }
  }
  cv::RNG of_sensor(random.bits());
  cv::Mat1f noise(image.size(), 0.F);
  if (view.noise > 0) of_sensor.fill(noise, cv::RNG::NORMAL, 0, view.noise);
  cv::Mat1b out;
  cv::Mat(image + noise).convertTo(out, CV_8U);
  return out;
}

std::optional<RangeTold> RangeViews::look(const RangeView& view, const camera::StereoModel& believed,
                                          Random& random) const {
  StereoSight sight(draw(view, false, random), draw(view, true, random), believed);
  MarkTracker tracker(learned_);
  tracker.add(*learned_.find(view.mark)).value();
  const TrackSighting seen = tracker.update(sight, Time()).front();
  if (!seen.seen || !seen.right_centre) return std::nullopt;
  return RangeTold{seen.range_mm - cv::norm(view.place), seen.range_spread_mm, seen.confidence};
}

}  // namespace pizarra::vision
