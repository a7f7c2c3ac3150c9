#include "drivers/arm/motoman/bsc_block.hpp"

#include <algorithm>
#include <array>

#include "drivers/line/octets.hpp"
#include "drivers/line/printable.hpp"

namespace pizarra::arm {

namespace {

constexpr char soh = 0x01;
constexpr char stx = 0x02;
constexpr char etx = 0x03;
constexpr char dle = 0x10;
constexpr char etb = 0x17;
constexpr std::string_view ends("\x03\x17");
constexpr std::string_view never_in_text("\x01\x04\x05\x10\x15");
constexpr std::size_t block_header_size = 6;
constexpr std::size_t sum_size = 2;
constexpr std::size_t longest_block = 1 + block_header_size + 1 + bsc::longest_text + 1 + sum_size;

std::uint16_t sum_of(std::string_view octets) {
  std::uint16_t sum = 0;
  for (const char c : octets) sum = static_cast<std::uint16_t>(sum + static_cast<unsigned char>(c));
  return sum;
}

bool is_text(char c) { return line::is_printable(c) || c == '\r' || c == '\n'; }

bool begins_a_block(char c) { return c == soh || c == stx; }

// How many of the octets are the sign at their front: 0 where more must come, none where no sign begins so.
std::optional<std::size_t> size_of_sign(std::string_view octets) {
  for (const std::string_view sign : {bsc::enquiry, bsc::nak, bsc::end, bsc::ack0, bsc::ack1}) {
    if (octets.starts_with(sign)) return sign.size();
  }
  if (octets == std::string_view(&dle, 1)) return 0;
  if (!begins_a_block(octets.front())) return std::nullopt;
  // An octet that cannot stand in a block ends a block that noise began.
  if (octets.find_first_of(never_in_text, 1) < octets.find_first_of(ends)) return std::nullopt;
  const std::size_t last = octets.find_first_of(ends);
  if (last == std::string_view::npos && octets.size() >= longest_block) return std::nullopt;
  if (last == std::string_view::npos || octets.size() < last + 1 + sum_size) return 0;
  return last + 1 + sum_size;
}

}  // namespace

std::vector<std::string> write_bsc(const BscMessage& message) {
  std::vector<std::string> blocks;
  std::string_view left = message.text;
  do {
    std::string summed = blocks.empty() ? message.header + stx : std::string();
    summed += left.substr(0, bsc::longest_text);
    left.remove_prefix(std::min(left.size(), bsc::longest_text));
    summed += left.empty() ? etx : etb;
    line::OctetWriter block(line::ByteOrder::little);
    block.u8(static_cast<std::uint8_t>(blocks.empty() ? soh : stx)).text(summed).u16(sum_of(summed));
    blocks.push_back(block.octets());
  } while (!left.empty());
  return blocks;
}

Result<std::optional<line::Frame>> frame_of_bsc(std::string_view octets) {
  std::size_t noise = 0;
  while (noise < octets.size()) {
    const std::optional<std::size_t> size = size_of_sign(octets.substr(noise));
    if (size && noise == 0 && *size > 0) return line::Frame{*size, octets.substr(0, *size)};
    if (size && noise == 0) return std::nullopt;
    if (size) break;
    ++noise;
  }
  if (noise == 0) return std::nullopt;
  return line::Frame{noise, std::string_view()};
}

BscSign read_bsc(std::string_view frame) {
  using Kind = BscSign::Kind;
  constexpr std::array<std::pair<std::string_view, Kind>, 5> characters{{{bsc::enquiry, Kind::enquiry},
                                                                         {bsc::ack0, Kind::ack0},
                                                                         {bsc::ack1, Kind::ack1},
                                                                         {bsc::nak, Kind::nak},
                                                                         {bsc::end, Kind::end}}};
  for (const auto& [octets, kind] : characters) {
    if (frame == octets) return {kind};
  }
  if (frame.size() < 2 + sum_size) return {Kind::damaged};
  const std::string_view summed = frame.substr(1, frame.size() - 1 - sum_size);
  const std::uint16_t sum = line::OctetReader(frame.substr(frame.size() - sum_size), line::ByteOrder::little).u16();
  const bool first = frame.front() == soh;
  const bool whole = !first || (summed.size() > block_header_size && summed[block_header_size] == stx);
  if (sum != sum_of(summed) || !whole) return {Kind::damaged};
  BscSign block{Kind::block};
  block.last = summed.back() == etx;
  std::string_view text = summed.substr(0, summed.size() - 1);
  if (first) {
    block.part.header = text.substr(0, block_header_size);
    text.remove_prefix(block_header_size + 1);
  }
  // A zero more or less is nothing to the sum.
  if (!std::ranges::all_of(text, is_text)) return {Kind::damaged};
  block.part.text = text;
  return block;
}

}  // namespace pizarra::arm
