#include "tests/bench/vision/learned_marks.hpp"

#include <stdexcept>

namespace pizarra::bench {

Scene learning_scene() {
  Scene scene;
  for (std::size_t i = 0; i < scene_marks().size(); ++i) {
    scene.marks.push_back({.name = scene_marks()[i], .centre = {80.3 + 48.2 * static_cast<double>(i), 120.4}});
  }
  return scene;
}

vision::LearnedObjects learn_marks(std::uint64_t seed) {
  vision::LearnedObjects out;
  Random random = Random(seed).split("learning");
  const Scene scene = learning_scene();
  for (const SceneMark& mark : scene.marks) {
    vision::MarkLearner learner(mark.name, mark.centre, out);
    while (!learner.done()) {
      vision::StereoSight sight(draw(scene, Side::left, random), draw(scene, Side::right, random), scene_camera());
      const Result<void> fed = learner.feed(sight);
      if (!fed) throw std::runtime_error(mark.name + " cannot be learned: " + describe(fed.error()));
    }
    vision::LearnedSample sample = learner.sample();
    sample.number = 1;
    out.add(mark.name, std::move(sample));
  }
  return out;
}

}  // namespace pizarra::bench
