#pragma once

// What the tests of the eyes share: sights of drawn scenes, and the five objects of a cell as learned from clicks.

#include "agents/vision/sight/mark_learner.hpp"
#include "tests/agents/vision/scene.hpp"

namespace pizarra::vision {

inline const std::vector<std::string>& cell_marks() {
  static const std::vector<std::string> names = {"circle", "square", "cross", "triangle", "end-effector"};
  return names;
}

// How the scene calls the mark of a learned object.
inline std::string drawn_as(const std::string& name) { return name == "end-effector" ? "plate" : name; }

// Two cameras that show a part of the cell's images around their middle; and the left one of a pair alone.
inline camera::StereoModel two_cameras(int width, int height) {
  camera::StereoModel out;
  out.width = width;
  out.height = height;
  out.centre_x_px = (width - 1) / 2.0;
  out.centre_y_px = (height - 1) / 2.0;
  return out;
}
inline camera::StereoModel one_camera_of(camera::StereoModel pair) {
  pair.base_line_mm = 0;
  pair.learned_at_mm = 850;
  return pair;
}

// A drawn frame and its sight.
struct DrawnSight {
  DrawnSight(const Scene& scene, Random& random)
      : frame(draw_scene(scene, model(), 1, random)), sight(as_mat(*frame.left), as_mat(*frame.right), model()) {}
  static const camera::StereoModel& model() {
    static const camera::StereoModel rectified;
    return rectified;
  }
  camera::StereoFrame frame;
  StereoSight sight;
};

// Feeds frames of the scene until the learner is done or fails.
inline Result<LearnedSample> learn_from(const Scene& scene, MarkLearner& learner, Random& random) {
  while (!learner.done()) {
    DrawnSight drawn(scene, random);
    const Result<void> fed = learner.feed(drawn.sight);
    if (!fed) return fail(fed);
  }
  return learner.sample();
}

// A row of the five at 850 mm, 80 mm apart, learned by clicking near their centres.
inline const LearnedObjects& learned_cell() {
  static const LearnedObjects objects = [] {
    LearnedObjects out;
    Random random(11);
    Scene scene;
    for (std::size_t i = 0; i < cell_marks().size(); ++i) {
      scene.faces.push_back(
          {.mark = drawn_as(cell_marks()[i]), .place = {-160 + 80.0 * static_cast<double>(i), 0, 850}});
    }
    for (std::size_t i = 0; i < cell_marks().size(); ++i) {
      const cv::Point2d click = project(DrawnSight::model(), scene.faces[i].place, false) + cv::Point2d(1.2, -2);
      MarkLearner learner(cell_marks()[i], click, out);
      LearnedSample sample = learn_from(scene, learner, random).value();
      sample.number = 1;
      out.add(cell_marks()[i], std::move(sample));
    }
    return out;
  }();
  return objects;
}

}  // namespace pizarra::vision
