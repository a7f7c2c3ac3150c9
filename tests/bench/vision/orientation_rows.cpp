// How marks are turned that are tilted by 20 to 60 degrees, 0.6 m away, as FIND tells it: by the left camera of a pair
// and by one camera alone, modulo the mark's symmetry. Where the other tilt is told as well, the nearer of both counts.

#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_learner.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr double range_mm = 600;
constexpr double degrees_a_rad = 180 / CV_PI;
const std::vector<std::string> names = {"circle", "square", "cross", "triangle"};

struct View {
  std::string mark;
  cv::Vec3d place_mm;  // from the left camera
  cv::Matx33d turn = cv::Matx33d::eye();
};

camera::StereoModel camera_of(bool is_pair) {
  camera::StereoModel out{.width = 640, .height = 480, .focal_px = 700, .centre_x_px = 319.5, .centre_y_px = 239.5};
  out.base_line_mm = is_pair ? 80 : 0;
  out.learned_at_mm = range_mm;
  return out;
}

cv::Point2d seen_at(const camera::StereoModel& model, const cv::Vec3d& place, double beside_mm) {
  return {model.centre_x_px + model.focal_px * (place[0] - beside_mm) / place[2],
          model.centre_y_px + model.focal_px * place[1] / place[2]};
}

cv::Mat1b drawn(const camera::StereoModel& model, const View& view, double beside_mm, Random& random) {
  Shape shape = mark_shape(view.mark);
  for (Outline& outline : shape) {
    for (cv::Point2d& p : outline) {
      p = seen_at(model, view.turn * cv::Vec3d(p.x, p.y, 0) + view.place_mm, beside_mm);
    }
  }
  cv::Mat1f image(model.height, model.width, 165.F);
  paint(image, shape, 25);
  cv::GaussianBlur(image, image, {}, 0.7, 0.7);
  cv::RNG of_sensor(random.bits());
  cv::Mat1f noise(image.size(), 0.F);
  of_sensor.fill(noise, cv::RNG::NORMAL, 0, 2);
  cv::Mat1b out;
  cv::Mat(image + noise).convertTo(out, CV_8U);
  return out;
}

vision::StereoSight sight_of(const camera::StereoModel& model, const View& view, Random& random) {
  const cv::Mat1b left = drawn(model, view, 0, random);
  if (model.is_single()) return {left, cv::Mat1b(left.size(), std::uint8_t{165}), model};
  return {left, drawn(model, view, model.base_line_mm, random), model};
}

vision::LearnedObjects learned_by(const camera::StereoModel& model, Random& random) {
  vision::LearnedObjects out;
  for (const std::string& name : names) {
    const View view{.mark = name, .place_mm = {model.base_line_mm / 2, 0, range_mm}};
    vision::MarkLearner learner(name, seen_at(model, view.place_mm, 0), out);
    while (!learner.done()) {
      vision::StereoSight sight = sight_of(model, view, random);
      learner.feed(sight).value();
    }
    vision::LearnedSample sample = learner.sample();
    sample.number = 1;
    out.add(name, std::move(sample));
  }
  return out;
}

cv::Matx33d turned_about(const cv::Vec3d& rad) {
  cv::Matx33d out;
  cv::Rodrigues(rad, out);
  return out;
}

View random_view(const std::string& mark, const camera::StereoModel& model, Random& random) {
  const double tilt = random.uniform(20, 60) / degrees_a_rad;
  const double lies = random.uniform(0, 2 * CV_PI);
  const cv::Vec3d place(model.base_line_mm / 2 + random.uniform(-150, 150), random.uniform(-100, 100), range_mm);
  return {mark, place,
          turned_about(tilt * cv::Vec3d(std::cos(lies), std::sin(lies), 0)) *
              turned_about({0, 0, random.uniform(-CV_PI, CV_PI)})};
}

cv::Vec3d away_of(const cv::Matx33d& turn) { return {turn(0, 2), turn(1, 2), turn(2, 2)}; }

// By which the truth differs from what is told, about the camera's axes, rad: the least of those that look the same. Of
// a circle that of its normal.
cv::Vec3d off_rad(const std::string& mark, const cv::Matx33d& told, const cv::Matx33d& truth) {
  if (mark == "circle") {
    const cv::Vec3d across = away_of(told).cross(away_of(truth));
    const double sine = cv::norm(across);
    return sine > 0 ? std::atan2(sine, away_of(told).dot(away_of(truth))) / sine * across : cv::Vec3d();
  }
  const int turns = mark == "triangle" ? 3 : 4;
  cv::Vec3d least(CV_PI, CV_PI, CV_PI);
  for (int i = 0; i < turns; ++i) {
    cv::Vec3d off;
    cv::Rodrigues(truth * turned_about({0, 0, 2 * CV_PI * i / turns}) * told.t(), off);
    if (cv::norm(off) < cv::norm(least)) least = off;
  }
  return least;
}

struct Tally {
  int shown = 0;
  int told = 0;
  int flips_told = 0;  // the other tilt may be it as well
  double squares = 0;
  // Of the tilt about two axes in the mark's plane, and of the range.
  int angles_within = 0;
  int ranges_within = 0;

  void count(const View& view, const vision::MarkPose& pose, double beside_mm) {
    ++told;
    cv::Vec3d off = off_rad(view.mark, pose.turn, view.turn);
    if (pose.flipped) {
      ++flips_told;
      const cv::Vec3d other = off_rad(view.mark, pose.flipped->turn, view.turn);
      if (cv::norm(other) < cv::norm(off)) off = other;
    }
    squares += off.dot(off);
    for (const int column : {0, 1}) {
      const cv::Vec3d axis(pose.turn(0, column), pose.turn(1, column), pose.turn(2, column));
      const Eigen::Vector3d about(axis[0], axis[1], axis[2]);
      const double spread = std::sqrt(about.dot(pose.covariance.bottomRightCorner<3, 3>() * about));
      angles_within += std::abs(off.dot(axis)) < 2 * spread ? 1 : 0;
    }
    const cv::Vec3d truth = view.place_mm - cv::Vec3d(beside_mm, 0, 0);
    const cv::Vec3d sight = truth / cv::norm(truth);
    const Eigen::Vector3d along(sight[0], sight[1], sight[2]);
    const double spread = std::sqrt(along.dot(pose.covariance.topLeftCorner<3, 3>() * along));
    ranges_within += std::abs((pose.place_mm - truth).dot(sight)) < 2 * spread ? 1 : 0;
  }
  double rms_deg() const { return degrees_a_rad * std::sqrt(squares / std::max(1, told)); }
};

Tally found_in(const camera::StereoModel& model, int views, Random random) {
  const vision::LearnedObjects objects = learned_by(model, random);
  Tally out;
  for (int i = 0; i < views; ++i) {
    const std::string& name = names[static_cast<std::size_t>(i) % names.size()];
    const View view = random_view(name, model, random);
    vision::StereoSight sight = sight_of(model, view, random);
    const Result<vision::FoundMark> found = vision::MarkFinder(objects).find(sight, *objects.find(name), Time());
    ++out.shown;
    if (found && found->pose) out.count(view, *found->pose, model.base_line_mm / 2);
  }
  return out;
}

void say_tally(Figures& figures, const std::string& who, const Tally& tally, double most_deg) {
  figures.say(
      {"orientation at 0.6 m, " + who + ", RMS",
       tally.rms_deg(),
       "degrees",
       at_most(most_deg),
       {},
       fmt::format("{} of {} told, {} of these with the other tilt", tally.told, tally.shown, tally.flips_told)});
  const double told = std::max(1, tally.told);
  figures.say({"orientation, " + who + ", within two spreads",
               50 * tally.angles_within / told,
               "%",
               {},
               {},
               fmt::format("95 is honest; ranges {:.1f} %", 100 * tally.ranges_within / told)});
}

}  // namespace

void orientation(VisionBench& bench) {
  const int views = std::max(4, bench.runs * 2 / 5);
  const Random random = Random(bench.seed).split("orientation");
  say_tally(bench.figures, "a pair", found_in(camera_of(true), views, random), 1);
  say_tally(bench.figures, "one camera", found_in(camera_of(false), views, random), 3);
}

}  // namespace pizarra::bench
