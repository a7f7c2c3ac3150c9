#include "agents/vision/sight/tracked_mark.hpp"

#include <algorithm>
#include <utility>

#include "agents/vision/sight/frame_time.hpp"

namespace pizarra::vision {
namespace {

double disparity_px(const SeenMark& left, const SeenMark& right) { return left.centre.x - right.centre.x; }

}  // namespace

cv::Point2d TrackedMark::expected(Time then) const {
  return left->centre + seconds_between(seen_at, then) * velocity_px;
}

std::optional<double> TrackedMark::expected_disparity_px(Time then) const {
  if (!right) return std::nullopt;
  return disparity_px(*left, *right) + seconds_between(seen_at, then) * disparity_change_px;
}

bool TrackedMark::is_bridged(Time now, cv::Size image) const {
  return left && now - seen_at <= longest_bridge && cv::Rect2d({}, cv::Size2d(image)).contains(expected(now));
}

void TrackedMark::take(SeenPair&& now, Time captured, double frame_s, double most_step_px) {
  const double seconds = seconds_between(seen_at, captured);
  const cv::Point2d velocity = left ? (now.left.centre - left->centre) / seconds : cv::Point2d();
  const bool steady = cv::norm(velocity) * frame_s < most_step_px;
  velocity_px = steady ? velocity : cv::Point2d();
  disparity_change_px = 0;
  if (now.right && left && right && steady) {
    disparity_change_px = (disparity_px(now.left, *now.right) - disparity_px(*left, *right)) / seconds;
  }
  if (const std::optional<LitMark> now_lit = LitMark::of(now.left)) lit = now_lit;
  left = std::move(now.left);
  right = std::move(now.right);
  seen_at = captured;
  missed = false;
}

void TrackedMark::lose() {
  whole.lose();
  *this = TrackedMark{.name = name,
                      .seen_before = seen_before,
                      .began_among_alike = began_among_alike,
                      .whole = whole,
                      .nearest = nearest,
                      .others = others,
                      .before = before,
                      .doubted_for = doubted_for};
}

// A cover that hid it for a while may go on hiding it for as long.
bool TrackedMark::is_doubted(const SeenPair& now, Time captured) {
  if (!before) return false;
  // What moved may have turned aside since.
  const double way_px = seconds_between(before->seen_at, captured) * cv::norm(before->velocity_px);
  const cv::Point2d off = now.left.centre - before->left->centre;
  const cv::Point2d on_its_way = std::min(1.0, way_px / std::max(1e-9, cv::norm(off))) * off;
  const bool is_there = before->left->box.contains(now.left.centre - on_its_way);
  const bool begins = doubted_for <= Duration();
  if (begins && !is_there) {
    doubted_for = std::clamp(captured - before->seen_at, longest_bridge, longest_doubt);
  }
  if (!begins && !missed && left) doubted_for -= captured - seen_at;
  if (!is_there && doubted_for > Duration()) return true;
  before.reset();
  doubted_for = {};
  return false;
}

}  // namespace pizarra::vision
