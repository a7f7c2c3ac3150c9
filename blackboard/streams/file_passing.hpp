#pragma once

// Open files passed between processes of this machine, with a packet on a Unix socket (SOCK_SEQPACKET).
//
//   send_packet(socket, "ring", files);                                   // false: the other does not read, or is gone
//   const std::expected<Packet, NoPacket> packet = receive_packet(socket);

#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blackboard/streams/file.hpp"

namespace pizarra::streams {

struct Packet {
  std::string text;
  std::vector<File> files;
};

enum class NoPacket { yet, more };  // none has come yet; no more will, the other is gone

inline constexpr std::size_t max_packet_text = 256;
inline constexpr std::size_t max_packet_files = 4;

// Neither waits: the socket is a non-blocking one.
bool send_packet(const File& socket, std::string_view text, std::span<const int> files = {});
std::expected<Packet, NoPacket> receive_packet(const File& socket);

// Whether the process at the other end has this process's user, or is root's.
bool peer_is_trusted(const File& socket);

}  // namespace pizarra::streams
