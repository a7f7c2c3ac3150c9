#include "blackboard/streams/file_passing.hpp"

#include <array>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <sys/socket.h>

namespace pizarra::streams {

namespace {

constexpr std::size_t control_bytes = CMSG_SPACE(max_packet_files * sizeof(int));
using Control = std::array<char, control_bytes>;

void take_files(msghdr& message, std::vector<File>& files) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS) continue;
    const std::size_t count = (part->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (std::size_t i = 0; i < count; ++i) {
      int number = -1;
      std::memcpy(&number, CMSG_DATA(part) + i * sizeof(int), sizeof number);
      files.emplace_back(number);
    }
  }
}

}  // namespace

bool send_packet(const File& socket, std::string_view text, std::span<const int> files) {
  assert(text.size() <= max_packet_text && files.size() <= max_packet_files);
  alignas(cmsghdr) Control control{};
  iovec part{const_cast<char*>(text.data()), text.size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (!files.empty()) {
    message.msg_control = control.data();
    message.msg_controllen = CMSG_SPACE(files.size_bytes());
    cmsghdr* header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(files.size_bytes());
    std::memcpy(CMSG_DATA(header), files.data(), files.size_bytes());
  }
  return sendmsg(socket.number(), &message, MSG_DONTWAIT | MSG_NOSIGNAL) >= 0;
}

std::expected<Packet, NoPacket> receive_packet(const File& socket) {
  std::array<char, max_packet_text> text{};
  alignas(cmsghdr) Control control{};
  iovec part{text.data(), text.size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t size = recvmsg(socket.number(), &message, MSG_DONTWAIT | MSG_CMSG_CLOEXEC);
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return std::unexpected(NoPacket::yet);
  if (size <= 0) return std::unexpected(NoPacket::more);
  Packet packet{std::string(text.data(), static_cast<std::size_t>(size)), {}};
  take_files(message, packet.files);
  return packet;
}

bool peer_is_trusted(const File& socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  if (getsockopt(socket.number(), SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0) return false;
  return peer.uid == geteuid() || peer.uid == 0;
}

}  // namespace pizarra::streams
