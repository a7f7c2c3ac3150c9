#include "agents/vision/sight/stereo_sight.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/other_outline.hpp"
#include "agents/vision/marks/tags.hpp"
#include "agents/vision/objects/part_look.hpp"
#include "agents/vision/sight/face_plane.hpp"
#include "agents/vision/sight/unyawed.hpp"

namespace pizarra::vision {
namespace {

constexpr double size_tolerance = 0.1;
constexpr double width_tolerance = 0.05;
constexpr double widest = 1.1;
// Nearer than this to the image's edge a mark cannot be measured, nor where its own half is not within.
constexpr double edge_px = 24;
constexpr double margin_px = 8;
// How far above and below a mark its partner reaches at most, besides a quarter of its height.
constexpr int partner_reach_px = 4;
// How much further than its centre a tag reaches that is looked for nearby, as a part of the image's height.
constexpr double tag_reach = 0.4;
// How far beside the border of a mark its tone and the ground's are looked for, and in which share of its rows.
constexpr int border_slack_px = 3;
constexpr double least_border_share = 0.7;
// A mark in the right image is of another size where its disparity is less than this part of what its size asks for.
constexpr double least_disparity_share = 0.87;

// The least disparity at which the object can be, going by its learned sizes; nothing where one was learned without.
std::optional<double> least_disparity(const camera::StereoModel& model, const LearnedObject& object,
                                      const SeenMark& left) {
  double largest_mm = 0;
  for (const LearnedSample& sample : object.samples) {
    if (sample.most_face_mm() <= 0) return std::nullopt;
    largest_mm = std::max(largest_mm, sample.most_face_mm());
  }
  return model.base_line_mm * unyawed(left, front_slimness(object)).size_px / largest_mm;
}

// Columns of the mark's right-hand border, a row each, from the top of its box.
std::vector<int> right_border(const SeenMark& mark) {
  std::vector<int> out(static_cast<std::size_t>(mark.box.height), mark.box.x);
  for (const cv::Point& p : mark.contour) {
    int& border = out[static_cast<std::size_t>(p.y - mark.box.y)];
    border = std::max(border, p.x);
  }
  return out;
}

// Whether the right image shows the mark's right-hand border at this disparity, as far as it reaches. A mark of which a
// part is seen may reach beyond the image.
bool shows_border(const cv::Mat1b& right, const SeenMark& left, const std::vector<int>& border, int disparity) {
  const double middle = (left.mark_level + left.ground_level) / 2;
  const auto is_mark = [&](int x, int y) { return (right(y, x) < middle) == (left.tone == MarkTone::dark); };
  int agreeing = 0;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const int y = left.box.y + static_cast<int>(i);
    const int x = border[i] - disparity;
    const bool within = x >= border_slack_px && x + border_slack_px < right.cols && y >= 0 && y < right.rows;
    if (within && is_mark(x - border_slack_px, y) && !is_mark(x + border_slack_px, y)) ++agreeing;
  }
  return agreeing >= least_border_share * static_cast<double>(border.size());
}

// Whether one yaw of the face gives both widths, as parts of the learned one. A face of yaw p, seen at slope t off the
// axis, is narrower than one that faces the camera. The factor is cos(p) + t sin(p) = sqrt(1 + t^2) cos(p - atan(t)).
bool yaw_explains(double left_width, double left_slope, double right_width, double right_slope, double tolerance) {
  const double full = std::sqrt(1 + left_slope * left_slope);
  if (left_width > widest * full) return false;
  const double turn = std::acos(std::min(1.0, left_width / full));
  for (const double side : {-1.0, 1.0}) {
    const double yaw = std::atan(left_slope) + side * turn;
    const double expected = std::cos(yaw) + right_slope * std::sin(yaw);
    if (std::abs(right_width / expected - 1) < tolerance) return true;
  }
  return false;
}

// The arm of a near cross shows three sides of a square.
bool is_part_of_another(const SeenMark& part, const std::vector<SeenMark>& marks, const LearnedObjects& objects,
                        const LearnedObject& object) {
  constexpr double most_of_it = 0.8;
  return std::ranges::any_of(marks, [&](const SeenMark& mark) {
    if ((mark.box & part.box).area() < most_of_it * part.box.area() || mark.area_px <= part.area_px) return false;
    return std::ranges::any_of(objects.all(), [&](const LearnedObject& other) {
      return !same_name(other.name, object.name) && is_recognised(mark, objects, other);
    });
  });
}

// `shown_height`: what of the height a tilt of the face would show.
bool is_whole_if_shown(double shown_height, const camera::StereoModel& model, const LearnedObject& object,
                       const SeenMark& left, const SeenMark& right) {
  const double mm_per_px = depth_mm(model, left.centre.x - right.centre.x) / model.focal_px;
  const double front = front_slimness(object);
  const Unyawed in_left = unyawed(left, front, shown_height);
  const Unyawed in_right = unyawed(right, front, shown_height);
  const double now_mm = in_left.size_px * mm_per_px;
  const double tolerance = size_tolerance + 2 * in_left.spread;
  return std::ranges::any_of(object.samples, [&](const LearnedSample& sample) {
    if (sample.most_face_mm() <= 0) return true;
    const double scale = now_mm / sample.face_mm();
    const double most = sample.most_face_mm() / sample.face_mm() * (1 + tolerance);
    if (scale < 1 - tolerance || scale > most) return false;
    return yaw_explains(scale * in_left.shown, (left.centre.x - model.centre_x_px) / model.focal_px,
                        scale * in_right.shown, (right.centre.x - model.centre_x_px) / model.focal_px,
                        width_tolerance + 1 / std::max(front, least_round) - 1 + 4 * in_left.spread);
  });
}

}  // namespace

cv::Mat grey_of(const Image& image) {
  cv::Mat view(image.height, image.width, CV_8UC(image.channels), const_cast<std::uint8_t*>(image.pixels.data()));
  if (image.channels == 3) cv::cvtColor(view, view, cv::COLOR_BGR2GRAY);
  return view;
}

StereoSight::StereoSight(const camera::StereoFrame& frame, const camera::StereoModel& model)
    : StereoSight(grey_of(*frame.left), grey_of(*frame.right), model) {}

StereoSight::StereoSight(cv::Mat left, cv::Mat right, const camera::StereoModel& model)
    : StereoSight(left, std::move(right), model, noise_of(left), std::nullopt) {}

StereoSight::StereoSight(cv::Mat left, cv::Mat right, const camera::StereoModel& model, double noise,
                         std::optional<cv::Rect> area)
    : left_(std::move(left)), right_(std::move(right)), model_(model), noise_(noise), area_(area) {}

StereoSight StereoSight::within(const cv::Rect& area) const {
  return {left_, right_, model_, noise_, area & cv::Rect({0, 0}, left_.size())};
}

// A partner is further left, and up to some rows higher or lower.
std::optional<cv::Rect> StereoSight::right_area() const {
  if (!area_) return std::nullopt;
  const int slack = area_->height / 4 + partner_reach_px;
  const cv::Rect rows(0, area_->y - slack, area_->br().x, area_->height + 2 * slack);
  return rows & cv::Rect({0, 0}, right_.size());
}

ImageSegmentation& StereoSight::left_segmentation() {
  if (!left_segmentation_) left_segmentation_.emplace(left_, noise_, model_.focal_px, area_);
  return *left_segmentation_;
}

ImageSegmentation& StereoSight::right_segmentation() {
  if (!right_segmentation_) right_segmentation_.emplace(right_, noise_, model_.focal_px, right_area());
  return *right_segmentation_;
}

// Of the first one only the rows are looked at; the whole image then serves all others.
std::vector<const SeenMark*> StereoSight::partners_of(const SeenMark& left) {
  if (!right_segmentation_ && !right_rows_) {
    const int reach = left.box.height / 4 + partner_reach_px;
    const cv::Rect rows(0, left.box.y - reach, right_.cols, left.box.height + 2 * reach);
    right_rows_.emplace(right_, noise_, model_.focal_px, rows);
    std::vector<const SeenMark*> partners = find_partners(left, right_rows_->marks());
    if (!partners.empty()) return partners;
  }
  return find_partners(left, right_segmentation().marks());
}

std::optional<SeenPair> StereoSight::find(const LearnedObjects& objects, const LearnedObject& object,
                                          std::optional<cv::Point2d> near, double reach_px,
                                          std::span<const cv::Point2d> others, std::optional<cv::Point2d> seen_last) {
  if (object.tag() != nullptr) {
    if (!near) return find(*object.tag(), {}, others);
    const int reach = cvCeil(reach_px + tag_reach * left_.rows);
    const cv::Rect area(cvRound(near->x) - reach, cvRound(near->y) - reach, 2 * reach, 2 * reach);
    return find(*object.tag(), area, others);
  }
  std::vector<SeenMark> candidates;
  for (const SeenMark& mark : left_segmentation().marks()) {
    const bool within = !near || cv::norm(mark.centre - *near) <= reach_px;
    const auto is_there = [&](const cv::Point2d& place) { return mark.box.contains(place); };
    if (!within || std::ranges::any_of(others, is_there)) continue;
    if (is_recognised(mark, objects, object)) candidates.push_back(mark);
  }
  while (!candidates.empty()) {
    const SeenMark* best = find_object(candidates, objects, object, seen_last);
    if (best == nullptr) return std::nullopt;
    const std::vector<const SeenMark*> partners = partners_of(*best);
    const Likeness likely = *recognise(*best, objects, object);
    if (partners.empty() && is_cut_off(object, *best))
      return SeenPair{.left = *best, .right = std::nullopt, .likeness = likely};
    for (const SeenMark* partner : partners) {
      if (is_whole(model_, object, *best, *partner))
        return SeenPair{.left = *best, .right = *partner, .likeness = likely};
    }
    candidates.erase(candidates.begin() + (best - candidates.data()));
  }
  return std::nullopt;
}

std::vector<SeenPair> StereoSight::looks_in_plane(ImageSegmentation& segmentation, Regions& regions,
                                                  const LearnedObjects& objects, const LearnedObject& object) const {
  std::vector<SeenPair> out;
  for (const LearnedSample& sample : object.samples) {
    std::optional<std::vector<LevelRegion>>& of_tone = regions[static_cast<std::size_t>(sample.tone)];
    if (!of_tone) of_tone = level_regions(segmentation.image(), sample.tone, segmentation.area());
    for (const LevelRegion& region : *of_tone) {
      std::optional<PlaneLook> look = seen_in_plane(segmentation.cut(), sample, region);
      if (!look) continue;
      look->mark.focal_px = model_.focal_px;
      const std::optional<Likeness> likely = recognise(look->mark, objects, object);
      if (likely) out.push_back({.left = std::move(look->mark), .right = std::nullopt, .likeness = *likely});
    }
  }
  std::ranges::sort(out, {}, [](const SeenPair& seen) { return seen.likeness.error; });
  return out;
}

std::vector<SeenPair> StereoSight::find_in_plane(const LearnedObjects& objects, const LearnedObject& object) {
  std::vector<SeenPair> seen = looks_in_plane(left_segmentation(), left_regions_, objects, object);
  if (model_.is_single() || seen.empty()) return seen;
  const std::vector<SeenPair> in_right = looks_in_plane(right_segmentation(), right_regions_, objects, object);
  std::erase_if(seen, [&](SeenPair& pair) {
    for (const SeenPair& other : in_right) {
      if (!are_partners(pair.left, other.left) || !is_whole(model_, object, pair.left, other.left)) continue;
      pair.right = other.left;
      return false;
    }
    return !is_cut_off(object, pair.left);
  });
  return seen;
}

std::vector<SeenPair> StereoSight::find_parts(const LearnedObjects& objects, const LearnedObject& object) {
  std::vector<SeenPair> out;
  if (!model_.is_single()) return out;
  const ImageCut& cut = left_segmentation().cut();
  if (!left_edges_) left_edges_ = edge_chains(cut);
  const PlaneLens lens{model_.focal_px, {model_.centre_x_px, model_.centre_y_px}};
  for (PartLook& look : look_for_parts(cut, *left_edges_, objects, object, lens)) {
    SeenPair pair{.left = whole_mark(cut, look), .right = std::nullopt};
    if (!holds(pair.left) || is_part_of_another(pair.left, left_segmentation().marks(), objects, object)) continue;
    pair.left.focal_px = model_.focal_px;
    pair.likeness.other_form = odds_of_other_outline(look.sample->plane, look.fit);
    std::optional<PlanePose> pose = pose_in_plane(model_, *look.sample, look.fit);
    pair.plane = PlaneView{look.sample, std::move(look.fit), true, std::move(pose), true};
    out.push_back(std::move(pair));
  }
  return out;
}

std::optional<SeenPair> StereoSight::find(const Tag& tag, std::optional<cv::Rect> area,
                                          std::span<const cv::Point2d> others) {
  std::vector<SeenMark> seen = tags(tag, area);
  std::erase_if(seen, [&](const SeenMark& mark) {
    return std::ranges::any_of(others, [&](const cv::Point2d& place) { return mark.box.contains(place); });
  });
  return pair_of(tag, std::move(seen), {});
}

std::vector<SeenMark> StereoSight::tags(const Tag& tag, std::optional<cv::Rect> area) {
  std::vector<SeenMark> seen = tags_anywhere(tag);
  // Around the area of a wide one more is looked at.
  std::erase_if(seen, [&](const SeenMark& mark) { return !holds(mark) || (area && (mark.box & *area) != mark.box); });
  return seen;
}

std::vector<SeenMark> StereoSight::tags_anywhere(const Tag& tag) {
  const TagFamily* family = family_called(tag.family);
  if (family == nullptr || (area_ && area_->empty())) return {};
  auto found = left_tags_.find(tag.family);
  if (found == left_tags_.end()) {
    found = left_tags_.emplace(tag.family, squares_in(left_, *family, area_.value_or(cv::Rect()))).first;
  }
  return tags_among(left_, found->second, tag);
}

std::optional<SeenPair> StereoSight::follow(const Tag& tag, const cv::Rect& area, std::optional<double> disparity_px) {
  return pair_of(tag, follow_tag(left_, tag, area), disparity_px);
}

std::optional<SeenPair> StereoSight::pair_of(const Tag& tag, std::vector<SeenMark> seen,
                                             std::optional<double> disparity_px) const {
  constexpr double square = 1;
  if (seen.empty()) return std::nullopt;
  const auto left = std::ranges::max_element(seen, {}, &SeenMark::area_px);
  for (const SeenMark& other : seen) {
    if (&other != &*left && !may_be_one_cube(*left, other, square)) return std::nullopt;
  }
  const Likeness likely{.error = 0, .doubt = left->tag_doubt, .unlearned = left->tag_doubt};
  SeenPair out{.left = std::move(*left), .right = std::nullopt, .likeness = likely};
  if (model_.is_single()) return out;
  const auto take_partner = [&](std::vector<SeenMark> right) {
    std::erase_if(right, [&](const SeenMark& mark) { return !are_tag_partners(out.left, mark); });
    if (right.size() == 1) out.right = std::move(right.front());
  };
  const cv::Rect box = out.left.box;
  if (disparity_px) take_partner(follow_tag(right_, tag, area_around_tag(box - cv::Point(cvRound(*disparity_px), 0))));
  if (out.right) return out;
  // In the same rows, as far left as it may be.
  take_partner(find_tags(right_, tag, {0, box.y - box.height, box.br().x, 3 * box.height}));
  return out;
}

bool StereoSight::is_cut_off(const LearnedObject& object, const SeenMark& left) {
  if (model_.is_single()) return true;
  const std::optional<double> expected = least_disparity(model_, object, left);
  if (!expected) return true;
  if (left.centre.x - *expected >= std::max(edge_px, left.box.width / 2.0 + margin_px)) return false;
  const std::vector<int> border = right_border(left);
  for (int disparity = 1; disparity < least_disparity_share * *expected; ++disparity) {
    if (shows_border(right_segmentation().image(), left, border, disparity)) return false;
  }
  return true;
}

bool is_whole(const camera::StereoModel& model, const LearnedObject& object, const SeenMark& left,
              const SeenMark& right) {
  const double shown_height = face_plane(model, left, right).shown_height();
  return is_whole_if_shown(1, model, object, left, right) ||
         is_whole_if_shown(shown_height, model, object, left, right);
}

}  // namespace pizarra::vision
