#include "agents/vision/agent/reply_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ranges>

#include "lisp/numbers.hpp"

namespace pizarra::vision {
namespace {

void add_pose(std::vector<Datum>& parts, const MarkPose& pose) {
  parts.push_back(pose_datum(pose));
  if (!pose.flipped) return;
  std::vector<Datum> out{"flipped"_sym};
  for (const double angle : angles_deg(pose.flipped->turn).val) out.push_back(to_datum(rounded(angle, 100)));
  out.push_back(to_datum(rounded(pose.flipped->share, 1000)));
  parts.push_back(Datum::list(std::move(out)));
}

Datum by_datum(std::span<const std::string> marks) {
  std::vector<Datum> out{"by"_sym};
  for (const std::string& mark : marks) out.push_back(Datum::string(mark));
  return Datum::list(std::move(out));
}

// The parts of a found fact that say where the mark is.
std::vector<Datum> parts_of(const FoundMark& found) {
  const SeenPair& pair = found.pair;
  const std::optional<cv::Point2d> right = pair.right ? std::optional(pair.right->centre) : std::nullopt;
  const SeenRange range = found.range.value_or(SeenRange());
  const Datum places = places_datum({pair.left.centre, right, range.mm, range.spread_mm});
  std::vector<Datum> out(places.items().begin(), places.items().end());
  if (found.pose) add_pose(out, *found.pose);
  return out;
}

}  // namespace

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

std::string_view track_state(const TrackSighting& sighting) {
  if (sighting.seen) return "seen";
  return sighting.bridged ? "bridged" : "lost";
}

Datum places_datum(const SeenPlaces& places) {
  const auto place = [](const char* where, cv::Point2d at) {
    return list(Datum::symbol(where), rounded(at.x, 100), rounded(at.y, 100));
  };
  std::vector<Datum> out{place("left", places.left)};
  if (places.right) out.push_back(place("right", *places.right));
  if (places.range_mm > 0) {
    out.push_back(list("range"_sym, rounded(places.range_mm, 100), rounded(places.range_spread_mm, 100)));
  }
  return Datum::list(std::move(out));
}

Datum pose_datum(const MarkPose& pose) {
  std::vector<Datum> out{"pose"_sym};
  const auto add = [&](double value, double parts) { out.push_back(to_datum(rounded(value, parts))); };
  add(pose.place_mm[0], 100);
  add(pose.place_mm[1], 100);
  add(pose.place_mm[2], 100);
  for (const double angle : angles_deg(pose.turn).val) add(angle, 100);
  std::vector<Datum> covariance;
  const auto unit = [&](int i) { return i < 3 ? 1 : degrees(1); };
  for (int i = 0; i < 6; ++i) {
    for (int k = i; k < 6; ++k) {
      covariance.push_back(to_datum(rounded(pose.covariance(i, k) * unit(i) * unit(k), 10000)));
    }
  }
  out.push_back(Datum::list(std::move(covariance)));
  return Datum::list(std::move(out));
}

Datum found_fact(std::uint64_t frame, const FoundMark& found) {
  constexpr std::size_t most_others = 8;
  const SeenPair& pair = found.pair;
  const Likeness& likely = pair.likeness;
  std::vector<Datum> elsewhere;
  for (const cv::Point2d& place : found.elsewhere | std::views::take(most_others)) {
    elsewhere.push_back(list(rounded(place.x, 100), rounded(place.y, 100)));
  }
  return list("found"_sym, found.name, frame, rounded(found.confidence, 1000),
              likely.second == nullptr ? "" : likely.second->name, rounded(likely.margin(), 1000),
              Datum::list(std::move(elsewhere)), Datum::list(parts_of(found)));
}

Datum tags_fact(std::uint64_t frame, Time captured, std::span<const FoundMark> seen) {
  std::vector<Datum> tags;
  for (const FoundMark& found : seen | std::views::take(most_tags_told)) {
    const Tag& tag = *found.pair.left.tag;
    std::vector<Datum> one{Datum::symbol(tag.family), to_datum(tag.number), to_datum(rounded(found.confidence, 1000))};
    std::ranges::move(parts_of(found), std::back_inserter(one));
    tags.push_back(Datum::list(std::move(one)));
  }
  return list("tags-seen"_sym, frame, captured.time_since_epoch().count(), Datum::list(std::move(tags)));
}

Datum look_fact(std::uint64_t frame, std::span<const TrackSighting> sightings) {
  std::vector<Datum> objects;
  for (const TrackSighting& s : sightings) {
    std::vector<Datum> one{to_datum(s.name), Datum::symbol(track_state(s))};
    const auto add = [&one](const Datum& parts) { one.insert(one.end(), parts.items().begin(), parts.items().end()); };
    if (s.seen || s.bridged) one.push_back(to_datum(rounded(s.confidence, 1000)));
    if (s.seen) {
      add(places_datum({s.centre, s.right_centre, s.range_mm, s.range_spread_mm}));
      if (s.yaw_deg) one.push_back(list("face"_sym, rounded(*s.yaw_deg, 10)));
      one.push_back(list("captured"_sym, s.captured.time_since_epoch().count()));
      one.push_back(list("second"_sym, s.second, rounded(s.margin, 1000)));
      if (s.pose) add_pose(one, *s.pose);
      if (!s.by.empty()) one.push_back(by_datum(s.by));
    }
    if (s.bridged) add(places_datum({.left = s.centre, .right = {}, .range_mm = s.range_mm}));
    objects.push_back(Datum::list(std::move(one)));
  }
  return list("look"_sym, frame, track_reply(sightings), Datum::list(std::move(objects)));
}

std::string get_reply(std::span<const std::string> names) {
  std::string listed;
  for (const std::string& name : names) listed += fmt::format("{}\"{}\"", listed.empty() ? "" : ", ", name);
  return fmt::format("(GET {} ({}))", names.size(), listed);
}

std::string get_reply(const LearnedObjects& objects) {
  std::vector<std::string> names;
  for (const LearnedObject& object : objects.all()) names.push_back(object.name);
  return get_reply(names);
}

}  // namespace pizarra::vision
