#include "blackboard/streams/stream_guest.hpp"

#include <cerrno>
#include <cstring>
#include <sys/epoll.h>

#include "blackboard/streams/abstract_address.hpp"

namespace pizarra::streams {

Result<std::unique_ptr<StreamGuest>> StreamGuest::come(Executor& executor, const std::string& door,
                                                       const std::string& stream, Streams::Receiver receiver,
                                                       Lost lost) {
  File socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  File bells(epoll_create1(EPOLL_CLOEXEC));
  const AbstractAddress address(door);
  const bool connected = socket && bells && connect(socket.number(), address.get(), address.size()) == 0;
  if (!connected) return fail("unreachable", std::strerror(errno), to_datum(stream));
  if (!peer_is_trusted(socket)) {
    return fail("unreachable", "the process that shows these images belongs to another user", to_datum(stream));
  }
  if (stream.size() > max_packet_text || !send_packet(socket, stream)) {
    return fail("unreachable", "the door does not listen", to_datum(stream));
  }
  return std::unique_ptr<StreamGuest>(
      new StreamGuest(executor, std::move(socket), std::move(bells), std::move(receiver), std::move(lost)));
}

StreamGuest::StreamGuest(Executor& executor, File socket, File bells, Streams::Receiver receiver, Lost lost)
    : executor_(executor),
      socket_(std::move(socket)),
      bells_(std::move(bells)),
      receiver_(std::move(receiver)),
      lost_(std::move(lost)) {
  executor_.watch_readable(socket_.number(), [this] { hear(); });
  executor_.watch_readable(bells_.number(), [this] { look(); });
}

StreamGuest::~StreamGuest() {
  executor_.unwatch_readable(socket_.number());
  executor_.unwatch_readable(bells_.number());
}

void StreamGuest::hear() {
  std::expected<Packet, NoPacket> packet = receive_packet(socket_);
  if (!packet && packet.error() == NoPacket::yet) return;
  // The bell may have rung for a frame in this ring before the ring came.
  if (packet && take_ring(std::move(*packet))) return look();
  executor_.unwatch_readable(socket_.number());
  const Lost lost = lost_;
  lost();
}

// It comes with the first frame, and again when frames have grown, with the same bell.
bool StreamGuest::take_ring(Packet packet) {
  constexpr std::size_t ring_and_bell = 2;
  if (packet.files.size() != ring_and_bell) return false;
  Result<SharedRingView> ring = SharedRingView::of(packet.files[0]);
  if (!ring) return false;
  ring_.emplace(std::move(*ring));
  if (bell_) return true;
  bell_ = std::move(packet.files[1]);
  epoll_event ringing{};
  ringing.events = EPOLLIN | EPOLLET;
  return epoll_ctl(bells_.number(), EPOLL_CTL_ADD, bell_.number(), &ringing) == 0;
}

void StreamGuest::look() {
  epoll_event rung{};
  [[maybe_unused]] const int bells = epoll_wait(bells_.number(), &rung, 1, 0);
  std::optional<StreamFrame> frame = ring_ ? ring_->newest() : std::nullopt;
  if (!frame) return;
  const Streams::Receiver receive = receiver_;
  receive(*frame);
}

}  // namespace pizarra::streams
