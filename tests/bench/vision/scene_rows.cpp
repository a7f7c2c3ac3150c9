// How well the eyes see: recall, identities and centres over random scenes, depth at 0.6 m.

#include <cmath>
#include <fmt/format.h>

#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/wholeness.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr double same_place_px = 3;
constexpr double surely = 0.9;

struct Tally {
  int shown = 0;
  int found = 0;
  int sought = 0;
  int wrong = 0;  // a place that is not the object's
  int sure = 0;   // of those found
  // Triangles that one camera sees smaller than they were learned: it cannot know whether they are whole.
  int smaller = 0;
  int smaller_sure = 0;
  double squared_px = 0;

  void count(const SceneMark* truth, const cv::Point2d* seen) {
    ++sought;
    shown += truth != nullptr ? 1 : 0;
    if (seen == nullptr) return;
    if (truth == nullptr || cv::norm(*seen - truth->centre) > same_place_px) {
      ++wrong;
      return;
    }
    ++found;
    const cv::Point2d off = *seen - truth->centre;
    squared_px += off.dot(off);
  }
  double sure_percent() const { return 100.0 * sure / std::max(1, found); }
  double others_sure_percent() const { return 100.0 * (sure - smaller_sure) / std::max(1, found - smaller); }
  double recall_percent() const { return 100.0 * found / std::max(1, shown); }
  double wrong_in_10000() const { return 1e4 * wrong / std::max(1, sought); }
  double rms_px() const { return std::sqrt(squared_px / std::max(1, found)); }
};

bool is_smaller_triangle(const SceneMark& mark) {
  return (mark.name == "triangle" || mark.name == "end-effector") && mark.depth_mm > learning_depth_mm;
}

const SceneMark* mark_in(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.marks, name, &SceneMark::name);
  return found == scene.marks.end() ? nullptr : &*found;
}

void find_marks(const VisionBench& bench, const Scene& scene, const cv::Mat1b& image, Tally& tally) {
  const camera::StereoModel camera = scene_camera_alone();
  vision::StereoSight sight(image, cv::Mat1b::zeros(image.size()), camera);
  for (const vision::LearnedObject& object : bench.marks.all()) {
    const Result<vision::FoundMark> found = vision::MarkFinder(bench.marks).find(sight, object, Time());
    const int found_before = tally.found;
    const SceneMark* truth = mark_in(scene, object.name);
    tally.count(truth, found ? &found->pair.left.centre : nullptr);
    if (tally.found == found_before) continue;
    const int sure = found->confidence >= surely ? 1 : 0;
    tally.sure += sure;
    if (!is_smaller_triangle(*truth)) continue;
    ++tally.smaller;
    tally.smaller_sure += sure;
  }
}

void find_tags(const TagDetector& peer, const Scene& scene, const cv::Mat1b& image, Tally& tally) {
  const std::vector<SeenTag> seen = peer.detect(image);
  for (int number = 0; number < tags_of_a_scene; ++number) {
    const auto found = std::ranges::find(seen, number, &SeenTag::number);
    const auto index = static_cast<std::size_t>(number);
    tally.count(index < scene.marks.size() ? &scene.marks[index] : nullptr,
                found == seen.end() ? nullptr : &found->centre);
  }
}

void say_recall(VisionBench& bench, const std::string& where, const Tally& ours, std::vector<Peer> peers) {
  bench.figures.say({"recall" + where, ours.recall_percent(), "%", at_least(99.5), std::move(peers),
                     fmt::format("{} marks in {} scenes, seed {}", ours.shown, bench.scenes, bench.seed)});
}

// Of the mark, as FIND tells it; nothing where the pair does not see it.
std::optional<vision::SeenRange> found_range(vision::StereoSight& sight, const vision::LearnedObjects& marks,
                                             const std::string& name) {
  const Result<vision::FoundMark> found = vision::MarkFinder(marks).find(sight, *marks.find(name), Time());
  return found && found->pair.right ? found->range : std::nullopt;
}

void say_wrong(VisionBench& bench, const std::string& where, const Tally& ours, std::vector<Peer> peers) {
  bench.figures.say({"wrong identities" + where, ours.wrong_in_10000(), "in 10000", at_most(1), std::move(peers),
                     fmt::format("{} of {} answers", ours.wrong, ours.sought)});
}

}  // namespace

void recall(VisionBench& bench) {
  Tally ours;
  std::vector<Tally> theirs(bench.peers.size());
  for (int i = 0; i < bench.scenes; ++i) {
    Random random = Random(bench.seed).split(fmt::format("scene {}", i));
    const Scene scene = random_scene(hard_ranges, random);
    find_marks(bench, scene, draw(scene, Side::left, random), ours);
    for (std::size_t p = 0; p < bench.peers.size(); ++p) {
      const cv::Mat1b image = draw(with_tags(scene, bench.peers[p].tags), Side::left, random);
      find_tags(bench.peers[p], scene, image, theirs[p]);
    }
  }
  const auto of_peers = [&](double (*value)(const Tally&)) {
    std::vector<Peer> out;
    for (std::size_t p = 0; p < theirs.size(); ++p) {
      out.push_back({bench.peers[p].name, {}});
      out.back().value = value(theirs[p]);
    }
    return out;
  };
  say_recall(bench, "", ours, of_peers([](const Tally& t) { return t.recall_percent(); }));
  say_wrong(bench, "", ours, of_peers([](const Tally& t) { return t.wrong_in_10000(); }));
  bench.figures.say(
      {"found surely", ours.sure_percent(), "%", {}, {}, fmt::format("{} of {} found", ours.sure, ours.found)});
  bench.figures.say({"found surely, but triangles smaller than learned",
                     ours.others_sure_percent(),
                     "%",
                     {},
                     {},
                     fmt::format("{} of {} found, and {} of {} such triangles", ours.sure - ours.smaller_sure,
                                 ours.found - ours.smaller, ours.smaller_sure, ours.smaller)});
  bench.figures.say(
      {"centre error, RMS", ours.rms_px(), "px", at_most(0.3), of_peers([](const Tally& t) { return t.rms_px(); })});
}

void solids(VisionBench& bench) {
  SceneRanges ranges = hard_ranges;
  ranges.solids = true;
  Tally ours;
  for (int i = 0; i < bench.scenes; ++i) {
    Random random = Random(bench.seed).split(fmt::format("solids {}", i));
    const Scene scene = random_scene(ranges, random);
    find_marks(bench, scene, draw(scene, Side::left, random), ours);
  }
  say_recall(bench, " among solid things", ours, {});
  say_wrong(bench, " among solid things", ours, {});
}

void depth(VisionBench& bench) {
  const SceneRanges near = {.least_light = 0.4,
                            .most_light = 1.6,
                            .least_scale = learning_depth_mm / 600,
                            .most_scale = learning_depth_mm / 600,
                            .most_turn_deg = 30,
                            .most_noise = 15,
                            .most_blur_px = 1.5,
                            .presence = 0.6};
  double squares = 0;
  int within_two = 0;  // spreads told
  int told = 0;
  int shown = 0;
  const int scenes = std::max(1, bench.scenes / 20);
  for (int i = 0; i < scenes; ++i) {
    Random random = Random(bench.seed).split(fmt::format("depth {}", i));
    const Scene scene = random_scene(near, random);
    vision::StereoSight sight(draw(scene, Side::left, random), draw(scene, Side::right, random), scene_camera());
    for (const SceneMark& mark : scene.marks) {
      ++shown;
      const std::optional<vision::SeenRange> range = found_range(sight, bench.marks, mark.name);
      if (!range) continue;
      const double truth = vision::range_mm(scene_camera(), mark.centre, disparity_px(mark.depth_mm));
      const double error = range->mm / truth - 1;
      squares += error * error;
      within_two += std::abs(range->mm - truth) < 2 * range->spread_mm ? 1 : 0;
      ++told;
    }
  }
  const double rms = told == 0 ? 100 : 100 * std::sqrt(squares / told);
  bench.figures.say(
      {"depth error at 0.6 m, RMS", rms, "%", at_most(1), {}, fmt::format("{} of {} marks measured", told, shown)});
  bench.figures.say({"within two spreads told", 100.0 * within_two / std::max(1, told), "%", {}, {}, "95 is honest"});
}

}  // namespace pizarra::bench
