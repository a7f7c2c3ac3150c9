#include "tests/agents/vision/ground_looks.hpp"

#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/mark_learner.hpp"

namespace pizarra::vision {
namespace {

constexpr double mark_mm = 44;

camera::StereoModel one_of(camera::StereoModel pair, double size_px) {
  pair.base_line_mm = 0;
  pair.learned_at_mm = mark_mm * pair.focal_px / size_px;
  return pair;
}

bench::Shape moved_left(bench::Shape shape, double px) {
  for (bench::Outline& outline : shape) {
    for (cv::Point2d& p : outline) p.x -= px;
  }
  return shape;
}

}  // namespace

void ToldAtFirst::count(double confidence, double off) {
  ++told;
  if (confidence < surely) return;
  ++sure;
  wrong += off > off_px ? 1 : 0;
  most_off_px = std::max(most_off_px, off);
}

GroundLooks::GroundLooks(std::string of, std::uint64_t seed)
    : random(Random(seed).split("first look " + of)),
      name(std::move(of)),
      shape_(drawn_shape()),
      alone_(one_of(model_, size_px)),
      to_pair_(learned(model_)),
      to_one_(learned(alone_)) {}

bench::Shape GroundLooks::drawn_shape() {
  if (name == "rectangle") return bench::box(mark_mm, mark_mm / 2);
  if (name == "light triangle") return bench::mark_shape("triangle");
  if (name != "tag") return bench::mark_shape(name);
  const auto family = random.below(2) == 0 ? cv::aruco::DICT_4X4_50 : cv::aruco::DICT_APRILTAG_36h11;
  const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(family);
  cv::Mat drawn;
  dictionary->drawMarker(random.below(dictionary->bytesList.rows), dictionary->markerSize + 2, drawn);
  return bench::tag_shape(drawn == 0, mark_mm);
}

LearnedObjects GroundLooks::learned(const camera::StereoModel& by) {
  LearnedObjects out;
  MarkLearner learner("thing", centre_ + cv::Point2d(1, 1), out);
  while (!learner.done()) {
    StereoSight sight(draw(false), draw(true), by);
    learner.feed(sight).value();
  }
  LearnedSample sample = learner.sample();
  sample.number = 1;
  out.add("thing", std::move(sample));
  return out;
}

void GroundLooks::vary() {
  size_px = random.uniform(name == "tag" ? 24 : 18.5, 60);
  turn_deg = random.uniform(-30, 30);
  centre_ = {random.uniform(99, 120), random.uniform(58, 74)};
  ground = random.uniform(140, 200);
  light_slope = random.uniform(-0.15, 0.15);
  noise = random.uniform(1, 6);
  blur_px = random.uniform(0.5, 1);
  card_ = {};
  cover_ = {};
}

double GroundLooks::disparity_px() const { return model_.base_line_mm * size_px / mark_mm; }

void GroundLooks::put_cover(double from_deg, double edge_px, double level, std::optional<double> radius_px) {
  constexpr double straight_reach_px = 60;
  const double from = from_deg * CV_PI / 180;
  const double reach = radius_px.value_or(straight_reach_px);
  const cv::Point2d middle = centre_ + (edge_px + reach) * cv::Point2d(std::cos(from), std::sin(from));
  cover_ = bench::placed(radius_px ? bench::disc(reach) : bench::box(2 * reach, 4 * reach), middle, 1, from_deg);
  cover_level_ = level;
  cover_nearer_px_ = random.uniform(0.01, 0.3) * disparity_px();
}

void GroundLooks::put_card(const Margins& margins, double level) {
  const double high_px = name == "rectangle" ? size_px / 2 : size_px;
  card_ = bench::box(size_px + margins.left + margins.right, high_px + margins.up + margins.down);
  for (cv::Point2d& p : card_.front()) p += cv::Point2d(margins.right - margins.left, margins.down - margins.up) / 2;
  card_ = bench::placed(card_, centre_, 1, turn_deg);
  around_card_ = level;
}

cv::Mat1b GroundLooks::draw(bool to_the_right) {
  cv::Mat1f image(model_.height, model_.width, static_cast<float>(card_.empty() ? ground : around_card_));
  const double shift_px = to_the_right ? disparity_px() : 0;
  const auto put = [&](const bench::Shape& shape, double nearer_px, double level) {
    const double by_px = shift_px + (to_the_right ? nearer_px : 0);
    if (!shape.empty()) bench::paint(image, moved_left(shape, by_px), static_cast<float>(level));
  };
  const auto as_mark = [&](const bench::Shape& shape) {
    return bench::placed(shape, centre_, size_px / mark_mm, turn_deg);
  };
  put(card_, 0, ground);
  const bool light = name == "light triangle";
  if (light) put(as_mark(bench::mark_shape("plate")), 0, plate_level);
  put(as_mark(shape_), 0, light ? ground : mark_level);
  put(cover_, cover_nearer_px_, cover_level_);
  cv::GaussianBlur(image, image, {11, 11}, blur_px, blur_px, cv::BORDER_REPLICATE);
  cv::Mat1b out(image.size());
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const double light_there =
          1 + light_slope * ((x + 0.5) / image.cols - 0.5 + 0.5 * ((y + 0.5) / image.rows - 0.5));
      out(y, x) = cv::saturate_cast<std::uint8_t>(image(y, x) * light_there + noise * random.normal());
    }
  }
  return out;
}

void GroundLooks::find(StereoSight& sight, const LearnedObjects& objects, ToldAtFirst& told) const {
  const Result<FoundMark> found = MarkFinder(objects).find(sight, objects.all().front(), {});
  if (found) told.count(found->confidence, cv::norm(found->pair.left.centre - centre_));
}

void GroundLooks::count(const TrackSighting& sighting, ToldAtFirst& told) const {
  if (sighting.seen) told.count(sighting.confidence, cv::norm(sighting.centre - centre_));
}

void GroundLooks::look() {
  ToldAtFirst& of_one_told = size_px < learned_px ? by_one_farther : by_one;
  MarkTracker of_pair(to_pair_);
  MarkTracker of_one(to_one_);
  of_pair.add(to_pair_.all().front()).value();
  of_one.add(to_one_.all().front()).value();
  for (int frame = 0; frame < answers - 1; ++frame) {
    const cv::Mat1b left = draw(false);
    StereoSight both(left, draw(true), model_);
    StereoSight left_only(left, cv::Mat1b::zeros(left.size()), alone_);
    if (frame == 0) find(both, to_pair_, by_pair);
    if (frame == 0) find(left_only, to_one_, of_one_told);
    count(of_pair.update(both, Time() + frame * 100ms).front(), by_pair);
    count(of_one.update(left_only, Time() + frame * 100ms).front(), of_one_told);
  }
}

}  // namespace pizarra::vision
