#include "drivers/arm/motoman/hses_packet.hpp"

#include "drivers/line/octets.hpp"

namespace pizarra::arm {

namespace {

constexpr std::string_view mark = "YERC";
constexpr std::string_view reserved = "99999999";
constexpr std::uint16_t header_size = 0x20;
constexpr std::uint8_t three = 3;  // which the manual calls reserved
constexpr std::uint8_t robot_control = 1;
constexpr std::uint8_t request_kind = 0;
constexpr std::uint8_t reply_kind = 1;
constexpr std::uint32_t last_block = 0x80000000;
constexpr std::size_t most_data = 0x1df;

line::OctetWriter begin(std::uint8_t kind, std::uint8_t id, std::uint32_t block, const std::string& data) {
  line::OctetWriter octets(line::ByteOrder::little);
  octets.text(mark).u16(header_size).u16(static_cast<std::uint16_t>(data.size()));
  octets.u8(three).u8(robot_control).u8(kind).u8(id).u32(block).text(reserved);
  return octets;
}

std::unexpected<Failure> wrong(const char* what) {
  return fail("bad-message", std::string("this is no message of a High Speed Ethernet Server: ") + what);
}

// Reads the part that requests and replies have in common. Answers the id.
Result<std::uint8_t> read_common(line::OctetReader& read, std::uint8_t kind) {
  if (read.text(mark.size()) != mark || read.u16() != header_size) return wrong("it does not begin like one");
  const std::uint16_t size = read.u16();
  if (read.u8() != three || read.u8() != robot_control) return wrong("it is not for the control of a robot");
  if (read.u8() != kind) return wrong("requests and replies are mixed up");
  const std::uint8_t id = read.u8();
  read.u32();
  read.text(reserved.size());
  constexpr std::size_t own_part = 8;
  if (!read.sound() || read.left() != own_part + size || size > most_data) return wrong("it is not as long as it says");
  return id;
}

}  // namespace

std::string write_hses(const HsesRequest& request) {
  line::OctetWriter octets = begin(request_kind, request.id, 0, request.data);
  octets.u16(request.command).u16(request.instance).u8(request.attribute).u8(request.service).u16(0);
  return octets.text(request.data).octets();
}

std::string write_hses(const HsesReply& reply) {
  line::OctetWriter octets = begin(reply_kind, reply.id, last_block, reply.data);
  const bool added = reply.added_status != 0;
  octets.u8(reply.service).u8(reply.status).u8(added ? 1 : 0).u8(0).u16(reply.added_status).u16(0);
  return octets.text(reply.data).octets();
}

Result<HsesRequest> read_hses_request(std::string_view datagram) {
  line::OctetReader read(datagram, line::ByteOrder::little);
  const Result<std::uint8_t> id = read_common(read, request_kind);
  if (!id) return fail(id);
  HsesRequest request{.id = *id};
  request.command = read.u16();
  request.instance = read.u16();
  request.attribute = read.u8();
  request.service = read.u8();
  read.u16();
  request.data = read.rest();
  return request;
}

Result<HsesReply> read_hses_reply(std::string_view datagram) {
  line::OctetReader read(datagram, line::ByteOrder::little);
  const Result<std::uint8_t> id = read_common(read, reply_kind);
  if (!id) return fail(id);
  HsesReply reply{.id = *id};
  reply.service = read.u8();
  reply.status = read.u8();
  const std::uint8_t added = read.u8();
  read.u8();
  reply.added_status = read.u16();
  if (added == 0) reply.added_status = 0;
  read.u16();
  reply.data = read.rest();
  return reply;
}

std::optional<std::uint32_t> hses_reply_id(std::string_view datagram) {
  const Result<HsesReply> reply = read_hses_reply(datagram);
  if (!reply) return std::nullopt;
  return reply->id;
}

}  // namespace pizarra::arm
