// How marks are turned that are tilted by 20 to 60 degrees, 0.6 m away, as FIND tells it and as TRACK does after five
// frames: by a pair and by one camera, modulo the mark's symmetry. Where the other tilt is told as well, the nearer of
// both counts.

#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_learner.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr double range_mm = 600;
constexpr int frames_tracked = 5;
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

// Of errors, each with the spread that was told.
struct Spreads {
  int told = 0;
  int within = 0;  // two spreads

  void count(const cv::Vec3d& off, const cv::Vec3d& along, const Eigen::Matrix3d& covariance) {
    const Eigen::Vector3d way(along[0], along[1], along[2]);
    ++told;
    within += std::abs(off.dot(along)) < 2 * std::sqrt(way.dot(covariance * way)) ? 1 : 0;
  }
  std::string said() const { return fmt::format("{:.1f} %", 100.0 * within / std::max(1, told)); }
};

struct Tally {
  int shown = 0;
  int told = 0;
  int flips_told = 0;  // the other tilt may be it as well
  double squares = 0;
  Spreads angles = {};  // of the tilt, about two axes in the mark's plane
  Spreads ranges = {};
  Spreads places = {};  // beside the line of sight, either way

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
      angles.count(off, {pose.turn(0, column), pose.turn(1, column), pose.turn(2, column)},
                   pose.covariance.bottomRightCorner<3, 3>());
    }
    const cv::Vec3d truth = view.place_mm - cv::Vec3d(beside_mm, 0, 0);
    const cv::Vec3d sight = truth / cv::norm(truth);
    const cv::Vec3d down = cv::normalize(sight.cross(cv::Vec3d(1, 0, 0)));
    const Eigen::Matrix3d of_place = pose.covariance.topLeftCorner<3, 3>();
    ranges.count(pose.place_mm - truth, sight, of_place);
    for (const cv::Vec3d& beside : {down, down.cross(sight)}) places.count(pose.place_mm - truth, beside, of_place);
  }
  double rms_deg() const { return degrees_a_rad * std::sqrt(squares / std::max(1, told)); }
};

std::optional<vision::MarkPose> found(const camera::StereoModel& model, const vision::LearnedObjects& objects,
                                      const View& view, Random& random) {
  vision::StereoSight sight = sight_of(model, view, random);
  const Result<vision::FoundMark> mark = vision::MarkFinder(objects).find(sight, *objects.find(view.mark), Time());
  return mark ? mark->pose : std::nullopt;
}

std::optional<vision::MarkPose> tracked(const camera::StereoModel& model, const vision::LearnedObjects& objects,
                                        const View& view, Random& random) {
  vision::MarkTracker tracker(objects);
  tracker.add(*objects.find(view.mark)).value();
  std::optional<vision::MarkPose> pose;
  for (int frame = 0; frame < frames_tracked; ++frame) {
    vision::StereoSight sight = sight_of(model, view, random);
    pose = tracker.update(sight, Time() + frame * 33ms).front().pose;
  }
  return pose;
}

using PoseOf = std::optional<vision::MarkPose> (*)(const camera::StereoModel&, const vision::LearnedObjects&,
                                                   const View&, Random&);

Tally tally_of(PoseOf pose_of, const camera::StereoModel& model, int views, Random random) {
  const vision::LearnedObjects objects = learned_by(model, random);
  Tally out;
  for (int i = 0; i < views; ++i) {
    const View view = random_view(names[static_cast<std::size_t>(i) % names.size()], model, random);
    const std::optional<vision::MarkPose> pose = pose_of(model, objects, view, random);
    ++out.shown;
    if (pose) out.count(view, *pose, model.base_line_mm / 2);
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
  const double told = std::max(1, tally.angles.told);
  figures.say({"orientation, " + who + ", within two spreads",
               100 * tally.angles.within / told,
               "%",
               {},
               {},
               fmt::format("95 is honest; ranges {}, places beside the line of sight {}", tally.ranges.said(),
                           tally.places.said())});
}

}  // namespace

void orientation(VisionBench& bench) {
  const int views = std::max(4, bench.runs * 2 / 5);
  const Random random = Random(bench.seed).split("orientation");
  const camera::StereoModel pair = camera_of(true);
  const camera::StereoModel one = camera_of(false);
  say_tally(bench.figures, "FIND by a pair", tally_of(found, pair, views, random), 1);
  say_tally(bench.figures, "FIND by one camera", tally_of(found, one, views, random), 3);
  say_tally(bench.figures, "TRACK by a pair", tally_of(tracked, pair, views, random), 1);
  say_tally(bench.figures, "TRACK by one camera", tally_of(tracked, one, views, random), 3);
}

}  // namespace pizarra::bench
