// The computing time of the eyes, in turns with the detectors of tags on the same scenes: one thread each, and its own
// time.

#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/vision/sight/confined_sights.hpp"
#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr int rounds = 15;
constexpr int repeats = 20;  // within a round
constexpr int scenes_in_turn = 10;

struct Pair {
  cv::Mat1b left;
  cv::Mat1b right;
};

// Ordinary scenes: the five marks, some clutter, light and noise as in a lab.
constexpr SceneRanges lab_ranges = {.least_light = 0.7,
                                    .most_light = 1.3,
                                    .least_scale = 0.8,
                                    .most_scale = 1.2,
                                    .most_turn_deg = 30,
                                    .most_noise = 6,
                                    .most_clutter = 6};

std::vector<Scene> lab_scenes(std::uint64_t seed) {
  Random random(seed);
  std::vector<Scene> out;
  while (out.size() < scenes_in_turn) {
    Scene scene = random_scene(lab_ranges, random);
    if (scene.marks.size() == scene_marks().size()) out.push_back(std::move(scene));
  }
  return out;
}

// Detecting tags in the same places, once in every scene.
std::function<void()> peer_work(const TagDetector& peer, const std::vector<Scene>& scenes, Random& random) {
  std::vector<cv::Mat1b> images;
  for (const Scene& scene : scenes) images.push_back(draw(with_tags(scene, peer.tags), Side::left, random));
  return [images, detect = peer.detect] {
    for (const cv::Mat1b& image : images) detect(image);
  };
}

// Detecting tags in both images of every scene, and how each of them lies by each image.
std::function<void()> peer_poses(const TagDetector& peer, const std::vector<Scene>& scenes, Random& random) {
  std::vector<cv::Mat1b> images;
  for (const Scene& scene : scenes) {
    for (const Side side : {Side::left, Side::right}) images.push_back(draw(with_tags(scene, peer.tags), side, random));
  }
  const camera::StereoModel camera = scene_camera();
  const cv::Matx33d matrix(camera.focal_px, 0, camera.centre_x_px, 0, camera.focal_px, camera.centre_y_px, 0, 0, 1);
  const std::vector<cv::Point3f> square = {{-10, 10, 0}, {10, 10, 0}, {10, -10, 0}, {-10, -10, 0}};
  return [images, matrix, square, detect = peer.detect] {
    cv::Vec3d turn;
    cv::Vec3d place;
    for (const cv::Mat1b& image : images) {
      for (const SeenTag& tag : detect(image)) {
        cv::solvePnP(square, tag.corners, matrix, {}, turn, place, false, cv::SOLVEPNP_IPPE_SQUARE);
      }
    }
  };
}

std::function<void()> template_matching(const std::vector<Scene>& scenes, Random& random) {
  const Scene learned = learning_scene();
  const cv::Mat1b image = draw(learned, Side::left, random);
  std::vector<cv::Mat> templates;
  for (const SceneMark& mark : learned.marks) {
    templates.push_back(image(cv::Rect(cv::Point(mark.centre) - cv::Point(15, 15), cv::Size(31, 31))).clone());
  }
  std::vector<cv::Mat1b> images;
  for (const Scene& scene : scenes) images.push_back(draw(scene, Side::left, random));
  return [images, templates] {
    cv::Mat response;
    for (const cv::Mat1b& each : images) {
      for (const cv::Mat& one : templates) cv::matchTemplate(each, one, response, cv::TM_CCOEFF_NORMED);
    }
  };
}

// How many are seen, of how many.
struct Seen {
  std::size_t seen = 0;
  std::size_t shown = 0;
  std::string said() const {
    return fmt::format("{:.1f} % of them seen", 100.0 * static_cast<double>(seen) / static_cast<double>(shown));
  }
};

using Work = std::pair<std::string, std::function<void()>>;

std::vector<Work> peers_work(const VisionBench& bench, const std::vector<Scene>& scenes, Random& random,
                             decltype(peer_work)& work = peer_work) {
  std::vector<Work> out;
  for (const TagDetector& peer : bench.peers) out.emplace_back(peer.name, work(peer, scenes, random));
  return out;
}

// The part of a peer's time that a figure may take, and which of the peer's times that is.
struct Share {
  double part;
  std::string text;
};

// Says our figure, the peers beside it.
void say_time(VisionBench& bench, const std::string& name, const std::optional<Share>& share,
              const std::function<void()>& ours, const std::vector<Work>& others, const std::string& note = "") {
  const auto timed = [](const std::function<void()>& work) {
    return std::function<double()>([work] { return thread_seconds_of(work); });
  };
  std::vector<std::function<double()>> works{timed(ours)};
  std::vector<Peer> peers;
  for (const auto& [peer, work] : others) works.push_back(timed(work));
  const std::vector<double> seconds = medians_of_rounds(rounds, works);
  for (std::size_t i = 0; i < others.size(); ++i) {
    peers.push_back({others[i].first, {}});
    peers.back().value = seconds[i + 1] * 1e6 / scenes_in_turn;
  }
  const double ours_us = seconds[0] * 1e6 / (scenes_in_turn * repeats);
  const double aruco_us = *peers.front().value;
  const Goal goal = share ? at_most(aruco_us * share->part, "<= " + share->text) : Goal();
  const std::string compared = share ? note : fmt::format("{}, 1/{:.1f} of ArUco's time", note, aruco_us / ours_us);
  bench.figures.say({name, ours_us, "us", goal, std::move(peers), compared,
                     "the pixels of the contours, which are followed one by one"});
}

std::vector<Pair> pairs_of(const std::vector<Scene>& scenes, Random& random) {
  std::vector<Pair> out;
  for (const Scene& scene : scenes) {
    const cv::Mat1b left = draw(scene, Side::left, random);
    out.push_back({left, draw(scene, Side::right, random)});
  }
  return out;
}

// All that the agent computes for one FIND, which looks at a frame of its own, or at an area of it.
Result<vision::FoundMark> answer_find(const Pair& pair, const vision::LearnedObjects& objects,
                                      const vision::LearnedObject& object, std::optional<cv::Rect> area = {}) {
  vision::StereoSight sight(pair.left, pair.right, scene_camera());
  vision::ConfinedSights sights(sight);
  vision::MarkFinder finder(objects);
  return finder.find(sights.of(area), object, Time());
}

// A ninth of the image, around where each object is found in each scene; all of it where it is not.
using Areas = std::vector<std::vector<std::optional<cv::Rect>>>;  // by scene, then by object
Areas areas_of(const std::vector<Pair>& pairs, const vision::LearnedObjects& objects) {
  Areas out;
  for (const Pair& pair : pairs) {
    std::vector<std::optional<cv::Rect>>& of_scene = out.emplace_back();
    const cv::Rect image({0, 0}, pair.left.size());
    const cv::Size third = pair.left.size() / 3;
    for (const vision::LearnedObject& object : objects.all()) {
      const Result<vision::FoundMark> found = answer_find(pair, objects, object);
      of_scene.emplace_back();
      if (!found) continue;
      const cv::Point middle(found->pair.left.centre);
      of_scene.back() = cv::Rect(middle - cv::Point(third) / 2, third) & image;
    }
  }
  return out;
}

// Scenes that move there and back, a few pixels a frame, and who follows what is in them.
struct Followed {
  std::vector<Pair> frames;
  vision::MarkTracker tracker;
  std::size_t next = 0;
  Time now = {};
};

std::vector<Followed> followed(const std::vector<Scene>& scenes, const vision::LearnedObjects& objects,
                               Random& random) {
  std::vector<Followed> out;
  for (const Scene& scene : scenes) {
    Followed one{.frames = {}, .tracker = vision::MarkTracker(objects)};
    for (const double step : {0.0, 1.3, 3.1, 4.7, 3.6, 1.8}) {
      Scene moved = scene;
      for (SceneMark& mark : moved.marks) mark.centre += cv::Point2d(-step, 0.5 * step);
      one.frames.push_back({draw(moved, Side::left, random), draw(moved, Side::right, random)});
    }
    for (const vision::LearnedObject& object : objects.all()) {
      if (!one.tracker.add(object)) throw std::runtime_error("too many objects");
    }
    out.push_back(std::move(one));
  }
  return out;
}

Seen track_all(std::vector<Followed>& all) {
  Seen out;
  for (Followed& one : all) {
    for (int i = 0; i < repeats; ++i) {
      const Pair& pair = one.frames[one.next++ % one.frames.size()];
      vision::StereoSight sight(pair.left, pair.right, scene_camera());
      for (const vision::TrackSighting& sighting : one.tracker.update(sight, one.now += 100ms)) {
        ++out.shown;
        out.seen += sighting.seen ? 1 : 0;
      }
    }
  }
  return out;
}

// ArUco's first tags, which the scenes of its peer bear.
vision::LearnedObjects tags_learned() {
  vision::LearnedObjects out;
  for (int number = 0; number < tags_of_a_scene; ++number) {
    vision::LearnedSample sample;
    sample.number = 1;
    sample.tag = vision::Tag{"aruco-4x4-50", number};
    out.add("tag-" + std::to_string(number), std::move(sample));
  }
  return out;
}

}  // namespace

void find_time(VisionBench& bench) {
  Random random(bench.seed);
  const std::vector<Scene> scenes = lab_scenes(bench.seed);
  std::vector<cv::Mat1b> images;
  for (const Scene& scene : scenes) images.push_back(draw(scene, Side::left, random));
  const auto find_all = [&] {
    for (int i = 0; i < repeats; ++i) {
      for (const cv::Mat1b& image : images) {
        vision::ImageSegmentation segmentation(image);
        for (const vision::LearnedObject& object : bench.marks.all())
          vision::find_object(segmentation.marks(), bench.marks, object);
      }
    }
  };
  std::vector<Work> others = peers_work(bench, scenes, random);
  others.emplace_back("five template matches", template_matching(scenes, random));
  say_time(bench, "find five objects, one image", Share{0.1, "1/10 of ArUco's detection"}, find_all, others);
  camera::StereoModel alone = scene_camera();
  alone.base_line_mm = 0;
  const auto answer_all = [&] {
    Seen out;
    for (int i = 0; i < repeats; ++i) {
      for (const cv::Mat1b& image : images) {
        vision::StereoSight sight(image, cv::Mat1b::zeros(image.size()), alone);
        for (const vision::LearnedObject& object : bench.marks.all()) {
          ++out.shown;
          out.seen += vision::MarkFinder(bench.marks).find(sight, object, Time()) ? 1 : 0;
        }
      }
    }
    return out;
  };
  const Seen answered = answer_all();
  say_time(
      bench, "answer five FINDs, one camera, with poses", {}, [&] { answer_all(); }, peers_work(bench, scenes, random),
      answered.said());
  const std::vector<Pair> pairs = pairs_of(scenes, random);
  // Another object in every scene, and each in each after all rounds.
  auto answer_each = [&, first = std::size_t{0}](const Areas* areas) mutable {
    Seen out;
    for (int i = 0; i < repeats; ++i, ++first) {
      for (std::size_t scene = 0; scene < pairs.size(); ++scene) {
        const std::size_t which = (first + scene) % bench.marks.all().size();
        const std::optional<cv::Rect> area = areas == nullptr ? std::nullopt : (*areas)[scene][which];
        ++out.shown;
        out.seen += answer_find(pairs[scene], bench.marks, bench.marks.all()[which], area) ? 1 : 0;
      }
    }
    return out;
  };
  const Seen seen = answer_each(nullptr);
  say_time(
      bench, "answer one FIND, both images, with depth", {}, [&] { answer_each(nullptr); },
      peers_work(bench, scenes, random), seen.said());
  const Areas areas = areas_of(pairs, bench.marks);
  const Seen seen_there = answer_each(&areas);
  say_time(
      bench, "the same, in a ninth of the image", {}, [&] { answer_each(&areas); }, peers_work(bench, scenes, random),
      seen_there.said());
}

void track_time(VisionBench& bench) {
  Random random(bench.seed);
  const std::vector<Scene> scenes = lab_scenes(bench.seed);
  std::vector<Followed> all = followed(scenes, bench.marks, random);
  say_time(
      bench, "track five objects, both images, six numbers",
      Share{1.0 / 8, "1/8 of ArUco's detection and solvePnP, both"}, [&] { track_all(all); },
      peers_work(bench, scenes, random, peer_poses));
}

void tag_time(VisionBench& bench) {
  Random random(bench.seed);
  std::vector<Scene> scenes = lab_scenes(bench.seed);
  const std::vector<Work> peers = peers_work(bench, scenes, random);
  for (Scene& scene : scenes) scene = with_tags(scene, bench.peers.front().tags);
  const vision::LearnedObjects tags = tags_learned();
  std::vector<Followed> all = followed(scenes, tags, random);
  const Seen seen = track_all(all);
  say_time(
      bench, "track five tags, both images, depth", Share{2, "twice ArUco's detection"}, [&] { track_all(all); }, peers,
      seen.said());
}

}  // namespace pizarra::bench
