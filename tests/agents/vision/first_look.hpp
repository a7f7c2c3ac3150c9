#pragma once

// Marks that are seen for the first time, whole or hidden in part by what lies as far away or nearer, by a pair of
// cameras and by the left one alone. How many are found, how many of these are told as sure, and how many of those are
// off, is counted.
//
//   FirstLooks looks(learned_as("bar", {.roll_deg = 90}));       // learned upright
//   looks.look("bar", FirstLooks::Cover::nearer, seed);
//   looks.by_pair.wrong;

#include "agents/vision/sight/wholeness.hpp"
#include "tests/agents/vision/eyes.hpp"
#include "tests/agents/vision/meeting.hpp"

namespace pizarra::vision {

// How a mark lies before the camera while it is learned.
struct Pose {
  double roll_deg = 0;
  double yaw_deg = 0;
  double pitch_deg = 0;
};

inline constexpr double learned_mm = 800;  // away

inline LearnedObjects learned_as(const std::string& mark, const Pose& pose) {
  Random random(17);
  Scene scene;
  scene.faces = {{.mark = drawn_as(mark),
                  .place = {10, 0, learned_mm},
                  .yaw_deg = pose.yaw_deg,
                  .roll_deg = pose.roll_deg,
                  .pitch_deg = pose.pitch_deg}};
  LearnedObjects out;
  MarkLearner learner(mark, project(DrawnSight::model(), scene.faces[0].place, false), out);
  LearnedSample sample = learn_from(scene, learner, random).value();
  sample.number = 1;
  out.add(mark, std::move(sample));
  return out;
}

class FirstLooks {
 public:
  enum class Cover : std::uint8_t { none, as_far, nearer };

  explicit FirstLooks(LearnedObjects learned) : objects(std::move(learned)) {}

  void look(const std::string& mark, Cover cover, std::uint64_t seed) {
    Random random = Random(seed).split("first look");
    Scene scene;
    scene.noise = random.uniform(1, 6);
    scene.blur_px = random.uniform(0.5, 1);
    const bool straight = faces || random.below(2) == 0;
    scene.faces = {
        {.mark = drawn_as(mark),
         .place = {random.uniform(-60, 80), random.uniform(-60, 60), random.uniform(nearest_mm, farthest_mm)},
         .yaw_deg = straight ? 0 : random.uniform(-30, 30),
         .roll_deg = straight ? 90.0 * static_cast<double>(random.below(2)) : random.uniform(0, 180)}};
    if (drawn_as(mark) == "plate") scene.faces[0].roll_deg = random.uniform(-10, 10);
    if (cover != Cover::none) hide_part(scene, cover, straight, random);
    DrawnSight drawn(scene, random);
    const cv::Point2d truth = project(DrawnSight::model(), scene.faces[0].place, false);
    camera::StereoModel alone = DrawnSight::model();
    alone.base_line_mm = 0;
    alone.learned_at_mm = 850;
    StereoSight left_only(drawn.sight.left(), cv::Mat::zeros(alone.height, alone.width, CV_8UC1), alone);
    count(drawn.sight, objects.all().front(), truth, by_pair);
    count(left_only, objects.all().front(), truth, by_one);
  }

  LearnedObjects objects;
  double nearest_mm = 560;
  double farthest_mm = 1000;
  bool faces = false;  // the cameras, always
  ToldOfMeeting by_pair;
  ToldOfMeeting by_one;

 private:
  void count(StereoSight& sight, const LearnedObject& object, cv::Point2d truth, ToldOfMeeting& told) const {
    const std::optional<SeenPair> found = sight.find(objects, object);
    TrackSighting sighting{.name = object.name, .centre = {}, .yaw_deg = {}, .contour = {}};
    sighting.seen = found.has_value();
    if (found) sighting.centre = found->left.centre;
    if (found) sighting.confidence = confidence_in_look(sight, object, *found);
    told.count(sighting, truth);
  }
  static void hide_part(Scene& scene, Cover cover, bool straight, Random& random) {
    const SceneFace& face = scene.faces[0];
    const double px_per_mm = DrawnSight::model().focal_px / face.place.z;
    const double from = straight ? CV_PI / 2 * static_cast<double>(random.below(4)) : random.uniform(0, 2 * CV_PI);
    const bool slim = face.mark == "bar" || face.mark == "thin-bar";
    const double along = from - face.roll_deg * CV_PI / 180;
    const double half_mm = slim ? 22 * std::abs(std::cos(along)) + 9 * std::abs(std::sin(along)) : 22;
    const double hidden_mm = random.uniform(0.1, 1) * half_mm;
    const cv::Point2d centre = project(DrawnSight::model(), face.place, false);
    const double disparity = DrawnSight::model().base_line_mm * px_per_mm;
    const cv::Point2d middle =
        centre + (50 + px_per_mm * (half_mm - hidden_mm)) * cv::Point2d(std::cos(from), std::sin(from));
    const int levels[] = {95, 150, 190, 225};
    scene.blots = {{.box = {middle.x - 50, middle.y - 50, 100, 100},
                    .level = levels[random.below(4)],
                    .disparity_px = disparity + (cover == Cover::as_far ? 0.5 : random.uniform(0.02, 0.3) * disparity),
                    .turn_deg = from * 180 / CV_PI}};
  }
};

}  // namespace pizarra::vision
