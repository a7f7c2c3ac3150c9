#pragma once

// A frame as one message between hosts: the stream's name and a space, by which ZeroMQ subscribes, five little-endian
// words (number, time of capture, width, height, channels), and the pixels.
//
//   socket.send(frame_to_text("left", frame));
//   std::optional<StreamFrame> frame = frame_from_text("left", text);

#include <optional>
#include <string>
#include <string_view>

#include "blackboard/stream.hpp"

namespace pizarra::streams {

// The beginning of the stream's messages.
inline std::string frame_topic(const std::string& stream) { return stream + ' '; }

std::string frame_to_text(const std::string& stream, const StreamFrame& frame);
// Nothing where the text is not a frame of this stream.
std::optional<StreamFrame> frame_from_text(const std::string& stream, std::string_view text);

}  // namespace pizarra::streams
