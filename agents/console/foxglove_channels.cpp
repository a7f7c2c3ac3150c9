#include "agents/console/foxglove_channels.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <nettle/base64.h>
#include <numbers>

#include "lisp/json.hpp"
#include "lisp/writer.hpp"

namespace pizarra::console {

namespace {

enum : std::size_t { tf, scene, story, facts };

constexpr double metres = 0.001;
// A place is told, and no size: a ball marks it.
constexpr double ball_m = 0.03;

constexpr std::string_view transform_schema =
    R"({"title":"foxglove.FrameTransform","type":"object","properties":{"timestamp":{"type":"object","title":"time","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}},"parent_frame_id":{"type":"string"},"child_frame_id":{"type":"string"},"translation":{"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}},"rotation":{"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"},"w":{"type":"number"}}}}})";

constexpr std::string_view scene_schema =
    R"({"title":"foxglove.SceneUpdate","type":"object","properties":{"deletions":{"type":"array","items":{"type":"object"}},"entities":{"type":"array","items":{"type":"object"}}}})";

constexpr std::string_view log_schema =
    R"({"title":"foxglove.Log","type":"object","properties":{"timestamp":{"type":"object","title":"time","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}},"level":{"type":"integer"},"message":{"type":"string"},"name":{"type":"string"},"file":{"type":"string"},"line":{"type":"integer"}}})";

constexpr std::string_view fact_schema =
    R"({"title":"pizarra.Fact","type":"object","properties":{"id":{"type":"integer"},"relation":{"type":"string"},"text":{"type":"string"},"teller":{"type":"string"},"because":{"type":"array","items":{"type":"integer"}},"gone":{"type":"boolean"}}})";

constexpr std::string_view image_schema =
    R"({"title":"foxglove.CompressedImage","type":"object","properties":{"timestamp":{"type":"object","title":"time","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}},"frame_id":{"type":"string"},"data":{"type":"string","contentEncoding":"base64"},"format":{"type":"string"}}})";

constexpr std::string_view plain_kinds[] = {"colour", "left"};
constexpr std::string_view annotated_kinds[] = {"annotated"};
constexpr FoxgloveImages image_channels[] = {
    {{"/camera", "foxglove.CompressedImage", image_schema}, plain_kinds},
    {{"/annotated", "foxglove.CompressedImage", image_schema}, annotated_kinds}};

constexpr FoxgloveChannel channels[] = {{"/tf", "foxglove.FrameTransform", transform_schema},
                                        {"/scene", "foxglove.SceneUpdate", scene_schema},
                                        {"/story", "foxglove.Log", log_schema},
                                        {"/facts", "pizarra.Fact", fact_schema}};

constexpr std::string_view patterns[] = {"(arm ?robot ?state ?action)",
                                         "(arm-joints ?robot ?joints)",
                                         "(arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz)",
                                         "(gripper ?robot ?opening)",
                                         "(commander ?robot ?client)",
                                         "(stop ?who ?reason)",
                                         "(place ?name ?x ?y ?z ?frame)",
                                         "(believed ?fact)",
                                         "(look ?eyes ?frame ?text ?of)",
                                         "(servo ?state ?object ?x ?y ?d)",
                                         "(goal ?n ?facts)",
                                         "(goal-state ?n ?state ?detail)",
                                         "(plan ?n ?operations)",
                                         "(operation ?i ?operation ?state)",
                                         "(event ?n ?kind ?sentence ?detail)"};

std::string time_json(Time when) {
  const auto microseconds = when.time_since_epoch().count();
  return fmt::format(R"({{"sec":{},"nsec":{}}})", microseconds / 1'000'000, microseconds % 1'000'000 * 1000);
}

std::string vector_json(double x, double y, double z) { return fmt::format(R"({{"x":{},"y":{},"z":{}}})", x, y, z); }

// Angles about the fixed x, then y, then z axis.
Eigen::Quaterniond rotation_of(double rx_deg, double ry_deg, double rz_deg) {
  const auto about = [](double degrees, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis);
  };
  return about(rz_deg, Eigen::Vector3d::UnitZ()) * about(ry_deg, Eigen::Vector3d::UnitY()) *
         about(rx_deg, Eigen::Vector3d::UnitX());
}

bool has_numbers(const Datum& fact, std::size_t first, std::size_t count) {
  if (fact.size() < first + count) return false;
  for (std::size_t i = first; i < first + count; ++i) {
    if (!fact[i].is_number()) return false;
  }
  return true;
}

std::string transform_json(const Fact& fact) {
  const Datum& at = fact.datum;
  const Eigen::Quaterniond turned = rotation_of(at[5].number(), at[6].number(), at[7].number());
  return fmt::format(
      R"({{"timestamp":{},"parent_frame_id":"base","child_frame_id":{},"translation":{},"rotation":{{"x":{},"y":{},"z":{},"w":{}}}}})",
      time_json(fact.when), json_string(fmt::format("{}-grip", at[1].text())),
      vector_json(at[2].number() * metres, at[3].number() * metres, at[4].number() * metres), turned.x(), turned.y(),
      turned.z(), turned.w());
}

std::string pose_json(const Datum& place) {
  return fmt::format(R"({{"position":{},"orientation":{{"x":0,"y":0,"z":0,"w":1}}}})",
                     vector_json(place[2].number() * metres, place[3].number() * metres, place[4].number() * metres));
}

std::string entity_json(const Fact& fact) {
  const std::string name(fact.datum[1].text());
  const std::string pose = pose_json(fact.datum);
  const std::string ball = fmt::format(R"({{"pose":{},"size":{},"color":{{"r":0.9,"g":0.9,"b":0.9,"a":0.8}}}})", pose,
                                       vector_json(ball_m, ball_m, ball_m));
  const std::string label = fmt::format(
      R"({{"pose":{},"billboard":true,"font_size":14,"scale_invariant":true,"color":{{"r":1,"g":0.7,"b":0.2,"a":1}},"text":{}}})",
      pose, json_string(name));
  return fmt::format(
      R"({{"deletions":[],"entities":[{{"timestamp":{},"frame_id":"base","id":{},"lifetime":{{"sec":0,"nsec":0}},"frame_locked":false,"metadata":[],"arrows":[],"cubes":[],"spheres":[{}],"cylinders":[],"lines":[],"triangles":[],"texts":[{}],"models":[]}}]}})",
      time_json(fact.when), json_string(name), ball, label);
}

std::string deletion_json(const Fact& fact, Time when) {
  return fmt::format(R"({{"deletions":[{{"timestamp":{},"type":0,"id":{}}}],"entities":[]}})", time_json(when),
                     json_string(std::string(fact.datum[1].text())));
}

std::string log_json(const Fact& fact) {
  const Datum& event = fact.datum;
  constexpr int information = 2;
  constexpr int warning = 3;
  const bool odd = event[2].is_symbol("difference");
  return fmt::format(R"({{"timestamp":{},"level":{},"message":{},"name":{},"file":"","line":0}})", time_json(fact.when),
                     odd ? warning : information, json_string(std::string(event[3].text())),
                     json_string(std::string(event[2].text())));
}

std::string fact_json(const Fact& fact, bool gone) {
  std::string because;
  for (const FactId id : fact.because) because += (because.empty() ? "" : ",") + std::to_string(id);
  return fmt::format(R"({{"id":{},"relation":{},"text":{},"teller":{},"because":[{}],"gone":{}}})", fact.id,
                     json_string(std::string(fact.datum.head())), json_string(write(fact.datum)),
                     json_string(fact.teller), because, gone);
}

}  // namespace

std::span<const FoxgloveChannel> foxglove_channels() { return channels; }
std::span<const FoxgloveImages> foxglove_images() { return image_channels; }

std::string foxglove_image(Time captured, std::string_view jpeg) {
  std::string text(BASE64_ENCODE_RAW_LENGTH(jpeg.size()), '\0');
  base64_encode_raw(text.data(), jpeg.size(), reinterpret_cast<const std::uint8_t*>(jpeg.data()));
  return fmt::format(R"({{"timestamp":{},"frame_id":"camera","data":"{}","format":"jpeg"}})", time_json(captured),
                     text);
}

std::span<const std::string_view> foxglove_patterns() { return patterns; }

std::span<const std::string_view> foxglove_patterns(std::size_t channel) {
  if (channel == facts) return patterns;
  constexpr std::string_view relations[] = {"(arm-pose ", "(place ", "(event "};
  const auto* found =
      std::ranges::find_if(patterns, [&](std::string_view pattern) { return pattern.starts_with(relations[channel]); });
  return {found, 1};
}

std::vector<FoxgloveMessage> foxglove_messages(const Fact& fact) {
  std::vector<FoxgloveMessage> messages{{facts, fact_json(fact, false)}};
  const Datum& said = fact.datum;
  if (said.is_form("arm-pose") && has_numbers(said, 2, 6)) messages.push_back({tf, transform_json(fact)});
  if (said.is_form("place") && has_numbers(said, 2, 3)) messages.push_back({scene, entity_json(fact)});
  if (said.is_form("event") && said.size() == 5) messages.push_back({story, log_json(fact)});
  return messages;
}

std::vector<FoxgloveMessage> foxglove_messages_of_gone(const Fact& fact, Time when) {
  std::vector<FoxgloveMessage> messages{{facts, fact_json(fact, true)}};
  if (fact.datum.is_form("place")) messages.push_back({scene, deletion_json(fact, when)});
  return messages;
}

}  // namespace pizarra::console
