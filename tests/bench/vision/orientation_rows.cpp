// How marks are turned that are tilted by 20 to 60 degrees, 0.6 m away, as FIND tells it and as TRACK does after five
// frames: by a pair and by one camera, modulo the mark's symmetry. Where the other tilt is told as well, the nearer of
// both counts.

#include <cmath>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_learner.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/vision/pose_errors.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr double range_mm = 600;
constexpr int frames_tracked = 5;
const std::vector<std::string> names = {"circle", "square", "cross", "triangle"};

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

cv::Mat1b drawn(const camera::StereoModel& model, const PosedMark& view, double beside_mm, Random& random) {
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

vision::StereoSight sight_of(const camera::StereoModel& model, const PosedMark& view, Random& random) {
  const cv::Mat1b left = drawn(model, view, 0, random);
  if (model.is_single()) return {left, cv::Mat1b(left.size(), std::uint8_t{165}), model};
  return {left, drawn(model, view, model.base_line_mm, random), model};
}

vision::LearnedObjects learned_by(const camera::StereoModel& model, Random& random) {
  vision::LearnedObjects out;
  for (const std::string& name : names) {
    const PosedMark view{.mark = name, .place_mm = {model.base_line_mm / 2, 0, range_mm}};
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

PosedMark random_view(const std::string& mark, const camera::StereoModel& model, Random& random) {
  const double tilt = random.uniform(20, 60) / degrees_a_rad;
  const double lies = random.uniform(0, 2 * CV_PI);
  const cv::Vec3d place(model.base_line_mm / 2 + random.uniform(-150, 150), random.uniform(-100, 100), range_mm);
  return {mark, place,
          turned_about(tilt * cv::Vec3d(std::cos(lies), std::sin(lies), 0)) *
              turned_about({0, 0, random.uniform(-CV_PI, CV_PI)})};
}

std::optional<vision::MarkPose> found(const camera::StereoModel& model, const vision::LearnedObjects& objects,
                                      const PosedMark& view, Random& random) {
  vision::StereoSight sight = sight_of(model, view, random);
  const Result<vision::FoundMark> mark = vision::MarkFinder(objects).find(sight, *objects.find(view.mark), Time());
  return mark ? mark->pose : std::nullopt;
}

std::optional<vision::MarkPose> tracked(const camera::StereoModel& model, const vision::LearnedObjects& objects,
                                        const PosedMark& view, Random& random) {
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
                                                   const PosedMark&, Random&);

PoseTally tally_of(PoseOf pose_of, const camera::StereoModel& model, int views, Random random) {
  const vision::LearnedObjects objects = learned_by(model, random);
  PoseTally out;
  for (int i = 0; i < views; ++i) {
    const PosedMark view = random_view(names[static_cast<std::size_t>(i) % names.size()], model, random);
    const std::optional<vision::MarkPose> pose = pose_of(model, objects, view, random);
    ++out.shown;
    if (pose) out.count(view, *pose, model.base_line_mm / 2);
  }
  return out;
}

void say_tally(Figures& figures, const std::string& who, const PoseTally& tally, double most_deg) {
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
