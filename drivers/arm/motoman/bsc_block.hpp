#pragma once

// Octets on a serial line by the rules that Yaskawa's older controllers share with IBM's Binary Synchronous
// Communications: control characters, and blocks that carry text.
//
//   ENQ  ACK0 (10 30)  ACK1 (10 31)  NAK  EOT
//   SOH "01,000" STX "RPOSJ" CR ETX sum     // the sum of all from behind SOH to ETX, 16 bits, little-endian
//   STX "..." ETB sum                       // a block that goes on one before; ETB instead of ETX: more follow
//
//   const Result<BscSign> sign = read_bsc(frame);
//
// Facts from: manuals of the ERC and the NX100 by way of public clients; the XRC's own was not to be had.

#include <string>
#include <string_view>
#include <vector>

#include "drivers/line/frames.hpp"

namespace pizarra::arm {

struct BscMessage {
  std::string header;  // what it is: "01,000" a command, "90,000" a code, "90,001" data
  std::string text;
  bool operator==(const BscMessage&) const = default;
};

namespace bsc {

inline constexpr std::string_view enquiry = "\x05";
inline constexpr std::string_view ack0 = "\x10\x30";
inline constexpr std::string_view ack1 = "\x10\x31";
inline constexpr std::string_view nak = "\x15";
inline constexpr std::string_view end = "\x04";

inline constexpr std::string_view command = "01,000";
inline constexpr std::string_view code = "90,000";
inline constexpr std::string_view data = "90,001";
inline constexpr std::size_t longest_text = 256;  // of one block

}  // namespace bsc

// One thing heard.
struct BscSign {
  enum class Kind : std::uint8_t { enquiry, ack0, ack1, nak, end, block, damaged };
  Kind kind;
  BscMessage part = {};  // of a block; without a header where it goes on one before
  bool last = false;     // of a block
};

// The blocks that carry it.
std::vector<std::string> write_bsc(const BscMessage& message);
// For Frames: noise between signs is passed over, as empty frames.
Result<std::optional<line::Frame>> frame_of_bsc(std::string_view octets);
// Of one frame that is not empty.
BscSign read_bsc(std::string_view frame);

}  // namespace pizarra::arm
