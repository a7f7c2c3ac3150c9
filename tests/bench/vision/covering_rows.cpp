// Something that comes to lie over a mark or a tag that is tracked, from any side, and leaves it again: a hand slides
// over it, or it goes behind what stands, slowly or fast, or both move. How much of what is told meanwhile to be seen
// is off: by 2 px where a hand slides over, and by 1 px of all that is told for sure.

#include <cmath>
#include <fmt/format.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr double wrong_px = 2;
constexpr double surely = 0.9;
constexpr double surely_wrong_px = 1;
// The most wrong ones among those that are told surely.
constexpr double most_wrong_percent = 100.0 / 300;
constexpr double tag_mm = 44;
constexpr int frames_before = 5;
constexpr double hand_mm = 150;
constexpr double reach_mm = 34;  // from where the hand touches no mark to where it hides all of it

constexpr SceneRanges lab_ranges = {.least_light = 0.7,
                                    .most_light = 1.3,
                                    .least_scale = 0.8,
                                    .most_scale = 1.2,
                                    .most_turn_deg = 30,
                                    .most_noise = 8,
                                    .most_blur_px = 1};

enum class Way : std::uint8_t { hand, mark_slowly, mark_quickly, both };

struct Covering {
  SceneMark mark;    // in the middle of its way
  double direction;  // radians, where the hand comes from
  double speed_mm;   // a frame, of the one against the other
  double by_mark;    // which part of that the mark moves
  double aside;      // and how far along the hand's edge meanwhile, for every mm
  double level;
  double depth_mm;

  // With the hand's edge so far from the mark's centre.
  Scene at(Scene scene, double edge_mm) const {
    const double scale = scale_at(mark.depth_mm);
    const cv::Point2d from(std::cos(direction), std::sin(direction));
    SceneMark& now = scene.marks.front();
    now = mark;
    now.centre -= by_mark * edge_mm * scale * (from + aside * cv::Point2d(-from.y, from.x));
    scene.things = {{.shape = placed(box(hand_mm, hand_mm), now.centre + (edge_mm + hand_mm / 2) * scale * from, scale,
                                     direction * 180 / CV_PI),
                     .level = level,
                     .depth_mm = depth_mm,
                     .in_front = true}};
    return scene;
  }
};

double random_speed_mm(Way way, Random& random) {
  if (way == Way::mark_slowly) return random.uniform(0.6, 3);
  if (way == Way::mark_quickly) return random.uniform(8, 25);
  return random.below(2) == 0 ? random.uniform(1, 4) : random.uniform(8, 25);
}

Covering random_covering(Way way, const Scene& scene, Random& random) {
  const double levels[] = {60, 110, scene.ground_level};
  const double depth_mm = scene.marks.front().depth_mm;
  Covering out{scene.marks.front(),
               random.uniform(0, 2 * CV_PI),
               random_speed_mm(way, random),
               0,
               0,
               levels[random.below(3)],
               depth_mm * (random.below(2) == 0 ? 0.98 : 0.8)};
  if (way == Way::hand) return out;
  out.mark.centre = {random.uniform(140, 220), random.uniform(90, 150)};
  out.by_mark = way == Way::both ? random.uniform(-1, 1.5) : 1;
  out.aside = random.uniform(-0.8, 0.8);
  return out;
}

struct Told {
  int seen = 0;
  int wrong = 0;
  int sure = 0;
  int surely_wrong = 0;

  void count(const std::vector<vision::TrackSighting>& sightings, cv::Point2d truth) {
    if (!sightings.front().seen) return;
    ++seen;
    const double off_px = cv::norm(sightings.front().centre - truth);
    wrong += off_px > wrong_px ? 1 : 0;
    if (sightings.front().confidence < surely) return;
    ++sure;
    surely_wrong += off_px > surely_wrong_px ? 1 : 0;
  }
  double percent() const { return 100.0 * wrong / std::max(1, seen); }
  double percent_of_sure() const { return 100.0 * surely_wrong / std::max(1, sure); }
};

struct ToldToBoth {
  Told by_pair;
  Told by_one;
};

// There and back.
void cover(const vision::LearnedObjects& objects, const Scene& scene, const Covering& covering, Random& random,
           ToldToBoth& told) {
  const camera::StereoModel left_camera = scene_camera_alone();
  vision::MarkTracker one(objects);
  vision::MarkTracker pair(objects);
  for (vision::MarkTracker* tracker : {&one, &pair}) {
    if (!tracker->add(*objects.find(covering.mark.name))) throw std::runtime_error("too many objects");
  }
  Time time = {};
  const auto look = [&](const Scene& now) {
    const cv::Mat1b left = draw(now, Side::left, random);
    vision::StereoSight alone(left, cv::Mat1b::zeros(left.size()), left_camera);
    vision::StereoSight both(left, draw(now, Side::right, random), scene_camera());
    time += 100ms;
    told.by_one.count(one.update(alone, time), now.marks.front().centre);
    told.by_pair.count(pair.update(both, time), now.marks.front().centre);
  };
  for (int frame = 0; frame < frames_before; ++frame) look(covering.at(scene, reach_mm));
  const int steps = static_cast<int>(2 * reach_mm / covering.speed_mm);
  for (int step = -steps; step <= steps; ++step) {
    look(covering.at(scene, reach_mm - covering.speed_mm * (steps - std::abs(step))));
  }
}

// The first of ArUco's tags.
vision::LearnedObjects tag_learned() {
  vision::LearnedSample sample;
  sample.number = 1;
  sample.tag = vision::Tag{"aruco-4x4-50", 0};
  sample.size_mm = tag_mm / std::sqrt(12);
  vision::LearnedObjects out;
  out.add("tag", std::move(sample));
  return out;
}

Scene lone_mark(Random& random) {
  Scene out = random_scene(lab_ranges, random);
  out.marks = {out.marks[random.below(out.marks.size())]};
  return out;
}

ToldToBoth cover_marks(const VisionBench& bench, Way way, const std::string& name, int runs) {
  ToldToBoth out;
  for (int i = 0; i < runs; ++i) {
    Random random = Random(bench.seed).split(fmt::format("covering {} {}", name, i));
    const Scene scene = lone_mark(random);
    cover(bench.marks, scene, random_covering(way, scene, random), random, out);
  }
  return out;
}

ToldToBoth cover_tags(const VisionBench& bench, int runs) {
  const vision::LearnedObjects tags = tag_learned();
  ToldToBoth out;
  for (int i = 0; i < runs; ++i) {
    Random random = Random(bench.seed).split(fmt::format("covering tag {}", i));
    Scene scene = lone_mark(random);
    scene.marks.front().name = "tag";
    scene.marks.front().tag = bench.peers.front().tags.front();
    const auto way = static_cast<Way>(random.below(4));
    cover(tags, scene, random_covering(way, scene, random), random, out);
  }
  return out;
}

void say_sure(VisionBench& bench, const std::string& name, const ToldToBoth& told, int runs) {
  for (const auto& [who, by] : {std::pair("a pair", told.by_pair), std::pair("one camera", told.by_one)}) {
    bench.figures.say(
        {fmt::format("surely told 1 px off, {}, {}", name, who),
         by.percent_of_sure(),
         "%",
         at_most(most_wrong_percent),
         {},
         fmt::format("{} of {} sure ones of {} positions, {} times", by.surely_wrong, by.sure, by.seen, runs)});
  }
}

}  // namespace

void coverings(VisionBench& bench) {
  const int runs = std::max(1, bench.runs / 4);
  const std::pair<Way, const char*> ways[] = {{Way::hand, "a hand slides over"},
                                              {Way::mark_slowly, "slowly behind something"},
                                              {Way::mark_quickly, "quickly behind something"},
                                              {Way::both, "both move"}};
  for (const auto& [way, name] : ways) {
    const ToldToBoth told = cover_marks(bench, way, name, runs);
    say_sure(bench, name, told, runs);
    if (way != Way::hand) continue;
    for (const auto& [who, by] : {std::pair("a pair", told.by_pair), std::pair("one camera", told.by_one)}) {
      bench.figures.say({fmt::format("told 2 px off while a hand slides over, {}", who),
                         by.percent(),
                         "%",
                         at_most(0.1),
                         {},
                         fmt::format("{} of {} positions, {} hands", by.wrong, by.seen, runs)});
    }
  }
  say_sure(bench, "a tag", cover_tags(bench, runs), runs);
}

}  // namespace pizarra::bench
