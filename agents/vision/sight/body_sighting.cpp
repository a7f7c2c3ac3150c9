#include "agents/vision/sight/body_sighting.hpp"

#include <algorithm>

namespace pizarra::vision {
namespace {

// Of the cosine of the angle at which a face is seen: at 45 degrees, where two faces look alike, some 6 degrees.
constexpr double clearly_more = 0.15;

// The cosine of the angle at which its face is seen; 0 where how it lies is not known.
double facing(const TrackSighting& mark) {
  if (!mark.pose) return 0;
  const cv::Vec3d into(mark.pose->turn(0, 2), mark.pose->turn(1, 2), mark.pose->turn(2, 2));
  return into.dot(mark.pose->place_mm) / cv::norm(mark.pose->place_mm);
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

}  // namespace pizarra::vision
