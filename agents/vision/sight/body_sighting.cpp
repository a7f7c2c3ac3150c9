#include "agents/vision/sight/body_sighting.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace pizarra::vision {
namespace {

// Of the cosine of the angle at which a face is seen: at 45 degrees, where two faces look alike, some 6 degrees.
constexpr double clearly_more = 0.15;
// At 75 degrees a mark says next to nothing of how the body lies that the others do not say.
constexpr double least_facing = 0.25;

// The cosine of the angle at which its face is seen; 0 where how it lies is not known.
double facing(const TrackSighting& mark) {
  if (!mark.pose) return 0;
  const cv::Vec3d into(mark.pose->turn(0, 2), mark.pose->turn(1, 2), mark.pose->turn(2, 2));
  return into.dot(mark.pose->place_mm) / cv::norm(mark.pose->place_mm);
}

// The same of a mark of a body that lies so.
double facing_of(const MarkOnBody& mark, const MarkPose& body) {
  const cv::Matx33d turn = body.turn * mark.turn;
  const cv::Vec3d middle = body.place_mm + body.turn * mark.place_mm;
  return cv::Vec3d(turn(0, 2), turn(1, 2), turn(2, 2)).dot(middle) / cv::norm(middle);
}

// In the left image, around a mark of the body that is seen: where its others can be after a frame's motion.
cv::Rect area_around(const Body& body, const TrackSighting& seen, double focal_px) {
  const cv::Vec3d from = body.mark(seen.name)->place_mm;
  double apart_mm = 0;
  for (const MarkOnBody& mark : body.marks) apart_mm = std::max(apart_mm, cv::norm(mark.place_mm - from));
  // The side of a mark is half of one that comes into sight, and as much again for the motion.
  const cv::Rect box = cv::boundingRect(seen.contour);
  const int reach_px = cvCeil(focal_px * apart_mm / seen.range_mm) + std::max(box.width, box.height);
  const cv::Point middle(seen.centre);
  return {middle.x - reach_px, middle.y - reach_px, 2 * reach_px, 2 * reach_px};
}

// Those of the body, and of what was seen only what the newest frame shows.
std::vector<const TrackSighting*> marks_of(const Body& body, std::span<const TrackSighting> tracked) {
  std::vector<const TrackSighting*> out;
  Time newest = Time::min();
  for (const TrackSighting& each : tracked) {
    if (body.mark(each.name) == nullptr) continue;
    out.push_back(&each);
    if (each.seen) newest = std::max(newest, each.captured);
  }
  std::erase_if(out, [&](const TrackSighting* mark) { return mark->seen && mark->captured < newest; });
  return out;
}

// Seen before bridged before lost; of those seen the one that looks at the cameras most.
double weight(const TrackSighting& mark, const std::string& front) {
  const double stays = mark.name == front ? clearly_more : 0;
  if (mark.seen) return 4 + facing(mark) + stays;
  return mark.bridged ? 2 + stays : stays;
}

}  // namespace

TrackSighting body_sighting(const Body& body, std::span<const TrackSighting> tracked, std::string& front) {
  const std::vector<const TrackSighting*> marks = marks_of(body, tracked);
  TrackSighting out;
  if (!marks.empty()) {
    out = **std::ranges::max_element(marks, {}, [&](const TrackSighting* mark) { return weight(*mark, front); });
    front = out.name;
  }
  out.name = body.name;
  out.pose.reset();
  std::vector<MarkInSight> in_sight;
  for (const TrackSighting* mark : marks) {
    if (mark->seen && mark->pose) in_sight.push_back({body.mark(mark->name), *mark->pose});
  }
  std::optional<BodyPose> lies = body_pose(in_sight);
  if (lies) out.pose = lies->pose;
  if (lies) out.by = std::move(lies->by);
  return out;
}

std::map<std::string, cv::Rect> areas_of_unseen(const Body& body, std::span<const TrackSighting> tracked, Time captured,
                                                double focal_px) {
  std::vector<MarkInSight> in_sight;
  const TrackSighting* shows = nullptr;
  for (const TrackSighting& each : tracked) {
    const MarkOnBody* mark = body.mark(each.name);
    if (mark == nullptr || !each.seen || each.captured != captured) continue;
    shows = &each;
    if (each.pose) in_sight.push_back({mark, *each.pose});
  }
  if (shows == nullptr) return {};
  const std::optional<BodyPose> lies = body_pose(in_sight);
  const cv::Rect around = area_around(body, *shows, focal_px);
  std::map<std::string, cv::Rect> out;
  for (const TrackSighting& each : tracked) {
    const MarkOnBody* mark = body.mark(each.name);
    if (mark == nullptr || each.seen) continue;
    const bool is_turned_away = lies && facing_of(*mark, lies->pose) < least_facing;
    out[each.name] = is_turned_away ? cv::Rect() : around;
  }
  return out;
}

}  // namespace pizarra::vision
