#pragma once

// A cell as Foxglove and its kin show one: channels of JSON messages with the public schemas (foxglove.Log and others),
// made of facts. Lengths are metres there; the frame is `base`.
//
//   /tf       foxglove.FrameTransform   where each arm's grip is, from arm-pose
//   /scene    foxglove.SceneUpdate      a ball where each object is believed to be, from place
//   /story    foxglove.Log              from event
//
//   /facts    pizarra.Fact              every fact that is followed, told or gone, as its text
//   /camera, /annotated   foxglove.CompressedImage   what the eyes see and what they make of it, live alone
//
//   for (const FoxgloveMessage& message : foxglove_messages(fact)) write(message.channel, fact.when, message.json);

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blackboard/fact.hpp"

namespace pizarra::console {

struct FoxgloveChannel {
  std::string_view topic;
  std::string_view schema_name;
  std::string_view schema;  // JSON
};

// In the order of their numbers.
std::span<const FoxgloveChannel> foxglove_channels();

// The channels of images, which are no facts: their numbers follow those. Each shows the stream of the first kind that
// is there.
struct FoxgloveImages {
  FoxgloveChannel channel;
  std::span<const std::string_view> kinds;
};
std::span<const FoxgloveImages> foxglove_images();
std::string foxglove_image(Time captured, std::string_view jpeg);

struct FoxgloveMessage {
  std::size_t channel;
  std::string json;
};

// Of a fact that was told, and of one that is gone since `when`.
std::vector<FoxgloveMessage> foxglove_messages(const Fact& fact);
std::vector<FoxgloveMessage> foxglove_messages_of_gone(const Fact& fact, Time when);

// The patterns to watch for all channels, and for one alone.
std::span<const std::string_view> foxglove_patterns();
std::span<const std::string_view> foxglove_patterns(std::size_t channel);

}  // namespace pizarra::console
