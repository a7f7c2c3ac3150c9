// How TRACK follows four shapes through films that are not ours (photographs/make_films.py), before a pair and before
// one camera: what it sees of whole marks, how far off it tells them, and what it tells of covered ones.

#include <cmath>
#include <fmt/format.h>
#include <map>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/vision/photographs.hpp"
#include "tests/bench/vision/pose_errors.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr int frames_a_second = 30;
// Tilts between which the orientation is judged.
constexpr double least_tilt_deg = 20;
constexpr double most_tilt_deg = 60;

struct Followed {
  int films = 0;
  int whole = 0;  // that the frames show
  int seen = 0;   // of these
  int sure = 0;
  int covered = 0;  // of covered marks, what is told
  int sure_covered = 0;
  int far_off_covered = 0;  // of the sure ones
  int elsewhere = 0;        // of all that is told
  int told = 0;
  std::vector<double> off_px = {};
  std::vector<double> off_percent = {};  // of the range
  PoseTally tilted = {};

  void count(const PhotographedMark& mark, const vision::TrackSighting& sighting, double beside_mm) {
    const double off = sighting.seen ? cv::norm(sighting.centre - mark.centre) : 0;
    const bool is_sure = sighting.seen && sighting.confidence >= surely;
    told += sighting.seen ? 1 : 0;
    elsewhere += off > same_place_px ? 1 : 0;
    if (mark.hidden > 0) {
      covered += sighting.seen ? 1 : 0;
      sure_covered += is_sure ? 1 : 0;
      far_off_covered += is_sure && off > sure_within_px ? 1 : 0;
      return;
    }
    ++whole;
    if (!sighting.seen || off > same_place_px) return;
    ++seen;
    sure += is_sure ? 1 : 0;
    off_px.push_back(off);
    const double range = cv::norm(mark.place_mm - cv::Vec3d(beside_mm, 0, 0));
    if (sighting.range_mm > 0) off_percent.push_back(100 * std::abs(sighting.range_mm / range - 1));
    const double tilt = degrees_a_rad * std::acos(std::clamp(mark.turn(2, 2), -1.0, 1.0));
    if (sighting.pose && tilt >= least_tilt_deg && tilt <= most_tilt_deg) {
      tilted.count({mark.name, mark.place_mm, mark.turn}, *sighting.pose, beside_mm);
    }
  }
};

void follow(const std::vector<const Photograph*>& frames, const vision::LearnedObjects& objects,
            const camera::StereoModel& model, Followed& out) {
  vision::MarkTracker tracker(objects);
  for (const vision::LearnedObject& object : objects.all()) tracker.add(object).value();
  ++out.films;
  cv::Mat1b left;
  Time captured{};
  for (const Photograph* frame : frames) {
    // The tracker looks back at the left image of the frame before.
    const cv::Mat1b before = left;
    left = frame->left();
    vision::StereoSight sight(left, model.is_single() ? cv::Mat1b::zeros(left.size()) : frame->right(), model);
    captured += std::chrono::duration_cast<Duration>(std::chrono::seconds(1)) / frames_a_second;
    for (const vision::TrackSighting& sighting : tracker.update(sight, captured)) {
      const auto mark = std::ranges::find(frame->marks, sighting.name, &PhotographedMark::name);
      if (mark != frame->marks.end()) out.count(*mark, sighting, model.base_line_mm / 2);
    }
  }
}

double percent(int part, int all) { return 100.0 * part / std::max(1, all); }

void say(Figures& figures, const std::string& who, const Followed& of, double least_sure, double most_deg,
         const Goal& of_range) {
  const std::string name = "films, " + who + ": ";
  figures.say({name + "whole marks seen",
               percent(of.seen, of.whole),
               "%",
               at_least(98),
               {},
               fmt::format("{} in {} films", of.whole, of.films)});
  figures.say({name + "told surely when whole", percent(of.sure, of.seen), "%", at_least(least_sure)});
  figures.say({name + "centre error, median", percentile(of.off_px, 0.5), "px", at_most(0.1)});
  figures.say({name + "centre error, 95 %", percentile(of.off_px, 0.95), "px", at_most(0.3)});
  figures.say({name + "told over 5 px off",
               1e4 * of.elsewhere / std::max(1, of.told),
               "in 10000",
               at_most(1),
               {},
               fmt::format("{} of {} positions", of.elsewhere, of.told)});
  figures.say({name + "covered in part, surely told over a pixel off",
               percent(of.far_off_covered, of.sure_covered),
               "%",
               at_most(1.0 / 3),
               {},
               fmt::format("{} of {} sure ones of {} positions", of.far_off_covered, of.sure_covered, of.covered)});
  figures.say({name + "orientation at tilts of 20 to 60 degrees, RMS",
               of.tilted.rms_deg(),
               "degrees",
               at_most(most_deg),
               {},
               fmt::format("{} told, {} with the other tilt; within two spreads: angles {}, ranges {}, places {}",
                           of.tilted.told, of.tilted.flips_told, of.tilted.angles.said(), of.tilted.ranges.said(),
                           of.tilted.places.said())});
  figures.say({name + "range, median", percentile(of.off_percent, 0.5), "%", of_range});
}

}  // namespace

void films(VisionBench& bench) {
  const PhotographFolder folder(bench.photographs.empty() ? "" : bench.photographs + "-films", "films");
  const PhotographSet set = make_films(folder.path(), bench.seed, bench.films);
  std::map<std::string, std::vector<const Photograph*>> frames;
  for (const Photograph& frame : set.photographs) frames[frame.condition].push_back(&frame);
  const vision::LearnedObjects by_one = learn_from(set.learning, photographs_camera());
  const vision::LearnedObjects by_pair = learn_from(set.learning, photographs_pair());
  Followed one;
  Followed pair;
  for (const auto& [film, shown] : frames) {
    const bool both = shown.front()->has_right();
    follow(shown, both ? by_pair : by_one, both ? photographs_pair() : photographs_camera(), both ? pair : one);
  }
  if (pair.films > 0) say(bench.figures, "a pair", pair, 97, 1, at_most(0.1));
  if (one.films > 0) say(bench.figures, "one camera", one, 95, 3, {});
}

}  // namespace pizarra::bench
