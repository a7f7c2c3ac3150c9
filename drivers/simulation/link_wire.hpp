#pragma once

// The device link's wire, for its two ends alone. A call is one part, `(call ID REQUEST)`. An answer is
// `(answer ID VALUES ((WIDTH HEIGHT CHANNELS) ...))`, or `(answer ID (fail ...) ())`, and then one part of pixels an
// image. ID counts up within one client.
//
//   while (auto parts = link_wire::receive_parts(socket)) take(link_wire::read_call((*parts)[1].to_string_view()));

#include <zmq.hpp>

#include "drivers/simulation/link.hpp"

namespace pizarra::simulation::link_wire {

inline constexpr std::size_t most_calls = 64;
inline constexpr std::size_t most_images = 2;
inline constexpr std::int64_t longest_message = 8 << 20;  // bytes
inline constexpr int most_queued = 256;                   // messages each way
// A move of 10 000 waypoints is 70 000 elements.
inline constexpr std::size_t longest_text = 4 << 20;

struct Call {
  std::uint64_t id;
  Datum request;
};
struct WireAnswer {
  std::uint64_t id;
  Result<Message> message;
};

using Parts = std::vector<zmq::message_t>;

std::string call_text(const Call& call);
Result<Call> read_call(std::string_view text);
Parts answer_parts(const WireAnswer& answer);
Result<WireAnswer> read_answer(const Parts& parts);

// All parts of the next message, or nothing when none waits. Parts beyond the first 8 are dropped.
std::optional<Parts> receive_parts(zmq::socket_t& socket);
void limit(zmq::socket_t& socket);

}  // namespace pizarra::simulation::link_wire
