#include "blackboard/streams/stream_door.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <sys/eventfd.h>
#include <sys/random.h>
#include <sys/socket.h>

#include "blackboard/streams/abstract_address.hpp"
#include "blackboard/streams/file_passing.hpp"

namespace pizarra::streams {

namespace {

constexpr int backlog = 64;

std::string unguessable_name() {
  std::array<std::uint64_t, 2> drawn{};
  // Bytes as few as these come whole, once the machine has begun.
  [[maybe_unused]] const ssize_t got = ::getrandom(drawn.data(), sizeof drawn, 0);
  return fmt::format("pizarra-stream-{:016x}{:016x}", drawn[0], drawn[1]);
}

// The counter does not fill in the life of a machine, unless a guest fills it.
void ring(const File& bell) {
  if (eventfd_write(bell.number(), 1) == 0) return;
  eventfd_t rung = 0;
  [[maybe_unused]] const int emptied = eventfd_read(bell.number(), &rung);
  [[maybe_unused]] const int again = eventfd_write(bell.number(), 1);
}

}  // namespace

Result<std::unique_ptr<StreamDoor>> StreamDoor::open(Executor& executor) {
  File socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  std::string name = unguessable_name();
  const AbstractAddress address(name);
  const bool listening =
      socket && bind(socket.number(), address.get(), address.size()) == 0 && listen(socket.number(), backlog) == 0;
  if (!listening) return fail("no-socket", std::strerror(errno));
  return std::unique_ptr<StreamDoor>(new StreamDoor(executor, std::move(socket), std::move(name)));
}

StreamDoor::StreamDoor(Executor& executor, File socket, std::string name)
    : executor_(executor), socket_(std::move(socket)), name_(std::move(name)) {
  executor_.watch_readable(socket_.number(), [this] { admit(); });
}

StreamDoor::~StreamDoor() {
  executor_.unwatch_readable(socket_.number());
  for (const auto& [number, guest] : guests_) executor_.unwatch_readable(number);
}

void StreamDoor::admit() {
  File socket(accept4(socket_.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (!socket || guests_.size() >= max_guests || !peer_is_trusted(socket)) return;
  const int number = socket.number();
  guests_.emplace(number, Guest{std::move(socket), {}, 0});
  executor_.watch_readable(number, [this, number] { hear(number); });
}

// A guest says its stream once, and then nothing any more.
void StreamDoor::hear(int number) {
  Guest& guest = guests_.at(number);
  const std::expected<Packet, NoPacket> packet = receive_packet(guest.socket);
  if (!packet && packet.error() == NoPacket::yet) return;
  if (!packet || !guest.stream.empty()) return dismiss(number);
  guest.stream = packet->text;
  Offer& offer = offers_[guest.stream];
  if (!offer.bell) offer.bell = File(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
}

void StreamDoor::dismiss(int number) {
  executor_.unwatch_readable(number);
  const std::string stream = guests_.extract(number).mapped().stream;
  const bool others = std::ranges::any_of(guests_, [&](const auto& guest) { return guest.second.stream == stream; });
  if (!others) offers_.erase(stream);
}

// A ring for images of this size; whether there is one.
bool StreamDoor::make_room(Offer& offer, std::size_t image_bytes) {
  if (offer.ring && offer.ring->largest_image() >= image_bytes) return true;
  Result<SharedRing> ring = SharedRing::make(image_bytes);
  if (!ring) return false;
  offer.ring = std::move(*ring);
  offer.ring_number = ++rings_made_;
  return true;
}

void StreamDoor::publish(const std::string& stream, const StreamFrame& frame) {
  const auto found = offers_.find(stream);
  if (found == offers_.end()) return;
  Offer& offer = found->second;
  // Without memory for it the frame is not seen, as one that is overtaken.
  if (!offer.bell || !make_room(offer, frame.image->pixels.size())) return;
  const std::array files{offer.ring->file().number(), offer.bell.number()};
  std::vector<int> gone;
  for (auto& [number, guest] : guests_) {
    if (guest.stream != stream || guest.ring == offer.ring_number) continue;
    guest.ring = offer.ring_number;
    if (!send_packet(guest.socket, "ring", files)) gone.push_back(number);
  }
  offer.ring->write(frame);
  ring(offer.bell);
  for (const int number : gone) dismiss(number);
}

}  // namespace pizarra::streams
