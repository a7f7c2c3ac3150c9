// The eyes on photographs that are not ours (photographs.hpp): what FIND tells of each mark before one camera, beside
// tags of the same size in the same places, which ours and the peers look for.

#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <set>

#include "agents/vision/sight/mark_finder.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/vision/photographs.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

// Of marks that one who looks for them told.
struct Told {
  int shown = 0;
  int answers = 0;
  int wrong = 0;
  int sure = 0;
  int sure_far_off = 0;
  std::vector<double> off_px;

  double recall_percent() const { return 100.0 * static_cast<double>(off_px.size()) / std::max(1, shown); }
  double sure_percent() const { return 100.0 * sure / std::max<double>(1, static_cast<double>(off_px.size())); }
  void count(const PhotographedMark& mark, std::optional<cv::Point2d> seen, double confidence = 0) {
    ++shown;
    if (!seen) return;
    ++answers;
    const double off = cv::norm(*seen - mark.centre);
    if (off > same_place_px) {
      ++wrong;
      return;
    }
    off_px.push_back(off);
    if (confidence < surely) return;
    ++sure;
    sure_far_off += off > sure_within_px ? 1 : 0;
  }
  void add(const Told& other) {
    shown += other.shown;
    answers += other.answers;
    wrong += other.wrong;
    sure += other.sure;
    sure_far_off += other.sure_far_off;
    off_px.insert(off_px.end(), other.off_px.begin(), other.off_px.end());
  }
};

using ByWho = std::map<std::string, Told>;
using ByCondition = std::map<std::string, ByWho>;

const char* const our_shapes = "shapes";
const std::set<std::string> not_whole = {"quarter-covered", "half-covered", "unlearned", "bare", "pair"};
const std::map<std::string, std::string> peer_of = {{"4x4", "ArUco"}, {"36h11", "AprilTag"}};
const std::map<std::string, std::string> family_of = {{"4x4", "aruco-4x4-50"}, {"36h11", "apriltag-36h11"}};

class Judge {
 public:
  Judge(const VisionBench& bench, const PhotographSet& set)
      : bench_(bench), objects_(learn_from(set.learning, photographs_camera())) {}

  void look_at(const Photograph& photo) {
    const cv::Mat1b image = photo.left();
    ByWho& told = told_[photo.condition];
    if (photo.kind == our_shapes) return find_shapes(photo, image, told[our_shapes]);
    find_tags(photo, image, told["our " + photo.kind]);
    for (const TagDetector& peer : bench_.peers) {
      if (peer.name == peer_of.at(photo.kind)) ask_peer(peer, photo, image, told[peer.name]);
    }
  }
  const ByCondition& told() const { return told_; }

 private:
  void find_shapes(const Photograph& photo, const cv::Mat1b& image, Told& told) {
    vision::StereoSight sight(image, cv::Mat1b::zeros(image.size()), model_);
    vision::MarkFinder finder(objects_);
    for (const vision::LearnedObject& object : objects_.all()) {
      const Result<vision::FoundMark> found = finder.find(sight, object, {});
      const auto mark = std::ranges::find(photo.marks, object.name, &PhotographedMark::name);
      if (mark != photo.marks.end()) {
        told.count(*mark, found ? std::optional(found->pair.left.centre) : std::nullopt, found ? found->confidence : 0);
        continue;
      }
      ++told.answers;
      if (!found) continue;
      ++told.wrong;
      told.sure += found->confidence >= surely ? 1 : 0;
    }
  }
  void find_tags(const Photograph& photo, const cv::Mat1b& image, Told& told) {
    vision::StereoSight sight(image, cv::Mat1b::zeros(image.size()), model_);
    for (const PhotographedMark& mark : photo.marks) {
      const auto found = sight.find(vision::Tag{family_of.at(photo.kind), tag_in_place_of(mark.name)});
      told.count(mark, found ? std::optional(found->left.centre) : std::nullopt,
                 found ? found->likeness.confidence() : 0);
    }
  }
  static void ask_peer(const TagDetector& peer, const Photograph& photo, const cv::Mat1b& image, Told& told) {
    const std::vector<SeenTag> seen = peer.detect(image);
    for (const PhotographedMark& mark : photo.marks) {
      const auto found = std::ranges::find(seen, tag_in_place_of(mark.name), &SeenTag::number);
      told.count(mark, found != seen.end() ? std::optional(found->centre) : std::nullopt);
    }
  }

  const VisionBench& bench_;
  const vision::LearnedObjects objects_;
  const camera::StereoModel model_ = photographs_camera();
  ByCondition told_;
};

std::vector<Peer> peers_in(const ByWho& told, const std::function<double(const Told&)>& value) {
  std::vector<Peer> out;
  for (const auto& [who, counts] : told) {
    if (who != our_shapes) out.push_back({who, value(counts)});
  }
  return out;
}

double median_px(const Told& told) { return percentile(told.off_px, 0.5); }
double most_px(const Told& told) { return percentile(told.off_px, 0.95); }

std::string described(const Told& told) {
  return fmt::format(
      "{} marks; centre off {:.2f} px in the median, {:.2f} at 95 %; {:.0f} % of them surely, {} of these "
      "over a pixel off; {} wrong",
      told.shown, median_px(told), most_px(told), told.sure_percent(), told.sure_far_off, told.wrong);
}

void say_whole(Figures& figures, const std::string& condition, const ByWho& told, double least_recall) {
  const Told& ours = told.at(our_shapes);
  figures.say({condition + ", recall", ours.recall_percent(), "%", at_least(least_recall),
               peers_in(told, [](const Told& t) { return t.recall_percent(); }), described(ours)});
}

// No more than a percent under the peer.
void say_tags(Figures& figures, const std::string& condition, const ByWho& told) {
  for (const auto& [kind, peer] : peer_of) {
    const Told& ours = told.at("our " + kind);
    const double theirs = told.at(peer).recall_percent();
    figures.say({fmt::format("{}, tags {}, recall", condition, kind),
                 ours.recall_percent(),
                 "%",
                 at_least(std::max(98.0, theirs - 1)),
                 {{peer, theirs}},
                 described(ours)});
  }
}

void say_all(Figures& figures, const ByCondition& by_condition) {
  ByWho all;
  for (const auto& [condition, told] : by_condition) {
    if (not_whole.contains(condition)) continue;
    for (const auto& [who, counts] : told) all[who].add(counts);
  }
  if (!all.contains(our_shapes)) return;
  const Told& ours = all.at(our_shapes);
  say_whole(figures, "photographs of whole marks", all, 98.5);
  figures.say({"photographs, centre error, median", median_px(ours), "px", at_most(0.1), peers_in(all, median_px)});
  figures.say({"photographs, centre error, 95 %", most_px(ours), "px", at_most(0.3), peers_in(all, most_px)});
  figures.say({"photographs, wrong identities", 1e4 * ours.wrong / std::max(1, ours.answers), "in 10000", at_most(1),
               peers_in(all, [](const Told& t) { return 1e4 * t.wrong / std::max(1, t.answers); }),
               fmt::format("{} of {}", ours.wrong, ours.answers)});
  figures.say({"photographs, told surely when whole", ours.sure_percent(), "%", at_least(95)});
}

void say_covered(Figures& figures, const std::string& condition, const Told& told, double within_px, double least) {
  const auto within = std::ranges::count_if(told.off_px, [&](double off) { return off <= within_px; });
  figures.say({fmt::format("photographs, {}, told within {} px", condition, within_px),
               100.0 * static_cast<double>(within) / std::max(1, told.shown),
               "%",
               at_least(least),
               {},
               fmt::format("{} marks, {} told, {} surely, {} of these over a pixel off", told.shown, told.off_px.size(),
                           told.sure, told.sure_far_off)});
}

void say_unlearned(Figures& figures, const std::string& condition, const Told& told) {
  figures.say({fmt::format("photographs, {}, told for a learned shape", condition),
               1e4 * told.wrong / std::max(1, told.answers),
               "in 10000",
               at_most(1),
               {},
               fmt::format("{} of {} answers, {} surely", told.wrong, told.answers, told.sure)});
}

void say_condition(Figures& figures, const std::string& condition, const ByWho& told) {
  if (!not_whole.contains(condition)) {
    say_whole(figures, "photographs, " + condition, told, 98);
    return say_tags(figures, "photographs, " + condition, told);
  }
  const Told& ours = told.at(our_shapes);
  if (condition == "quarter-covered") say_covered(figures, condition, ours, 0.5, 98);
  if (condition == "half-covered") say_covered(figures, condition, ours, 1.5, 90);
  if (condition == "unlearned" || condition == "bare") say_unlearned(figures, condition, ours);
}

void say_pair(Figures& figures, const PhotographSet& set) {
  const camera::StereoModel model = photographs_pair();
  const vision::LearnedObjects objects = learn_from(set.learning, model);
  std::vector<double> off_percent;
  int shown = 0;
  int within = 0;
  int sure = 0;
  for (const Photograph& photo : set.photographs) {
    if (photo.condition != "pair" || photo.kind != our_shapes) continue;
    vision::StereoSight sight(photo.left(), photo.right(), model);
    vision::MarkFinder finder(objects);
    for (const PhotographedMark& mark : photo.marks) {
      ++shown;
      const Result<vision::FoundMark> found = finder.find(sight, *objects.find(mark.name), {});
      if (!found || !found->range) continue;
      const double truth = cv::norm(mark.place_mm - cv::Vec3d(model.base_line_mm / 2, 0, 0));
      off_percent.push_back(100 * std::abs(found->range->mm / truth - 1));
      within += std::abs(found->range->mm - truth) < 2 * found->range->spread_mm ? 1 : 0;
      sure += found->confidence >= surely ? 1 : 0;
    }
  }
  if (shown == 0) return;
  const auto measured = static_cast<double>(off_percent.size());
  const double told = std::max(1.0, measured);
  figures.say(
      {"photographs, a pair: measured", 100 * measured / shown, "%", at_least(98), {}, fmt::format("{} marks", shown)});
  figures.say({"photographs, a pair: depth at 0.4-0.9 m, median",
               percentile(off_percent, 0.5),
               "%",
               at_most(0.1),
               {},
               fmt::format("95 % within {:.2f} %, {:.0f} % within two spreads", percentile(off_percent, 0.95),
                           100 * within / told)});
  figures.say({"photographs, a pair: told surely", 100 * sure / told, "%", at_least(97)});
}

}  // namespace

void photographs(VisionBench& bench) {
  const PhotographFolder folder(bench.photographs, "photographs");
  const PhotographSet set = make_photographs(folder.path(), bench.seed, bench.photograph_scenes);
  Judge judge(bench, set);
  // Those of one condition lie together: its row is said as soon as they were looked at.
  for (std::size_t i = 0; i < set.photographs.size(); ++i) {
    const std::string& condition = set.photographs[i].condition;
    judge.look_at(set.photographs[i]);
    if (i + 1 == set.photographs.size() || set.photographs[i + 1].condition != condition) {
      say_condition(bench.figures, condition, judge.told().at(condition));
    }
  }
  say_all(bench.figures, judge.told());
  say_pair(bench.figures, set);
}

}  // namespace pizarra::bench
