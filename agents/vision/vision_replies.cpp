#include "agents/vision/vision_replies.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pizarra {

std::string learn_reply(const std::string& name, bool ok) {
  return fmt::format("(LEARN \"{}\" {})", name, ok ? "OK" : "FAIL");
}

std::string find_reply(const std::string& name, const std::optional<cv::Point2d>& place) {
  if (!place) return fmt::format("(FIND \"{}\" FAIL)", name);
  return fmt::format("(FIND \"{}\" OK ({:.2f}, {:.2f}))", name, place->x, place->y);
}

std::string track_reply(std::span<const TrackSighting> sightings) {
  std::string text = fmt::format("(TRACK {}", sightings.size());
  for (const TrackSighting& s : sightings) {
    text += s.seen ? fmt::format(" (\"{}\" OK ({:.2f}, {:.2f}, {:.2f}))", s.name, s.centre.x, s.centre.y, s.range_mm)
                   : fmt::format(" (\"{}\" FAIL)", s.name);
  }
  return text + ")";
}

Datum faces_fact(std::uint64_t frame, std::span<const TrackSighting> sightings) {
  std::vector<Datum> faces;
  for (const TrackSighting& s : sightings) {
    if (s.yaw_deg) faces.push_back(list(s.name, std::round(*s.yaw_deg * 10) / 10));
  }
  return list("faces"_sym, frame, Datum::list(std::move(faces)));
}

std::string get_reply(const LearnedObjects& objects) {
  std::string names;
  for (const LearnedObject& object : objects.all()) {
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", object.name);
  }
  return fmt::format("(GET {} ({}))", objects.all().size(), names);
}

}  // namespace pizarra
