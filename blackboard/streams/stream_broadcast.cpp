#include "blackboard/streams/stream_broadcast.hpp"

#include <algorithm>
#include <array>

#include "blackboard/streams/frame_text.hpp"
#include "blackboard/streams/shared_ring.hpp"
#include "blackboard/wire/half_open.hpp"
#include "blackboard/wire/keys.hpp"
#include "blackboard/wire/wire_address.hpp"

namespace pizarra::streams {

namespace {

constexpr int frames_under_way = 2;
// Enough for a frame, and not for a second of frames that nobody wants any more.
constexpr int socket_bytes = 1 << 18;
constexpr std::int64_t longest_message = max_image_bytes + (1 << 16);

struct Keys {
  std::string public_key;
  std::string secret_key;
};

Keys fresh_keys() {
  std::array<char, wire::key_length + 1> open{};
  std::array<char, wire::key_length + 1> secret{};
  zmq_curve_keypair(open.data(), secret.data());
  return {open.data(), secret.data()};
}

// Both ends alike: what does not answer is let go.
void set_common(zmq::socket_t& socket) {
  socket.set(zmq::sockopt::linger, 0);
  socket.set(zmq::sockopt::maxmsgsize, longest_message);
  wire::let_go_when_half_open(socket);
}

enum TicketPart : std::size_t { transport, at, server_key, public_key, secret_key, ticket_parts };

bool is_ticket(const Datum& ticket) {
  if (!ticket.is_form("tcp") || ticket.size() != ticket_parts) return false;
  const auto is_text = [](const Datum& part) { return part.is_string(); };
  const auto is_key = [](const Datum& part) { return part.text().size() == wire::key_length; };
  return std::ranges::all_of(ticket.items().subspan(at), is_text) &&
         std::ranges::all_of(ticket.items().subspan(server_key), is_key) &&
         wire::check_address(std::string(ticket[at].text())).has_value();
}

}  // namespace

Result<std::unique_ptr<StreamBroadcast>> StreamBroadcast::open(Executor& executor, const std::string& address) {
  const Result<void> formed = wire::check_address(address);
  if (!formed) return fail(formed);
  if (wire::is_ipc(address)) return fail("bad-address", "streams for other hosts go over tcp", to_datum(address));
  const bool anywhere =
      address.starts_with("tcp://*:") || address.starts_with("tcp://0.0.0.0:") || address.starts_with("tcp://[::]:");
  if (anywhere) return fail("bad-address", "name the host by which others reach this one", to_datum(address));
  std::unique_ptr<StreamBroadcast> broadcast(new StreamBroadcast(executor));
  const Result<void> bound = broadcast->bind(address);
  if (!bound) return fail(bound);
  return broadcast;
}

StreamBroadcast::StreamBroadcast(Executor& executor)
    : executor_(executor),
      doorkeeper_(executor, context_, [this](const std::string& key) { return key == admitted_; }),
      socket_(context_, zmq::socket_type::xpub) {
  set_common(socket_);
  socket_.set(zmq::sockopt::sndhwm, frames_under_way);
  socket_.set(zmq::sockopt::sndbuf, socket_bytes);
}

Result<void> StreamBroadcast::bind(const std::string& address) {
  const Keys own = fresh_keys();
  const Keys guest = fresh_keys();
  admitted_ = guest.public_key;
  try {
    socket_.set(zmq::sockopt::curve_server, true);
    socket_.set(zmq::sockopt::curve_secretkey, own.secret_key);
    socket_.set(zmq::sockopt::ipv6, wire::is_ipv6(address));
    socket_.bind(address);
  } catch (const zmq::error_t& error) {
    const char* symbol = error.num() == EADDRINUSE ? "address-in-use" : "bad-address";
    return fail(symbol, std::string("ZeroMQ refuses the address: ") + error.what(), to_datum(address));
  }
  ticket_ =
      list("tcp"_sym, socket_.get(zmq::sockopt::last_endpoint), own.public_key, guest.public_key, guest.secret_key);
  pump_ = std::make_unique<SocketPump>(executor_, socket_,
                                       [this](const zmq::message_t& part) { heard(part.to_string_view()); });
  return {};
}

// A subscription is a byte, 1 or 0, and the topic; the first of a topic and the last are heard of.
void StreamBroadcast::heard(std::string_view subscription) {
  if (subscription.empty()) return;
  const std::string topic(subscription.substr(1));
  constexpr std::size_t most_topics = 256;
  if (subscription.front() == 1 && topics_.size() < most_topics) topics_.insert(topic);
  if (subscription.front() == 0) topics_.erase(topic);
}

bool StreamBroadcast::watched(const std::string& stream) const { return topics_.contains(frame_topic(stream)); }

void StreamBroadcast::publish(const std::string& stream, const StreamFrame& frame) {
  if (!watched(stream)) return;
  // ZeroMQ drops it for those who have enough under way.
  [[maybe_unused]] const auto sent = socket_.send(zmq::buffer(frame_to_text(stream, frame)), zmq::send_flags::dontwait);
  pump_->schedule();
}

Result<std::unique_ptr<StreamListener>> StreamListener::come(Executor& executor, zmq::context_t& context,
                                                             const Datum& ticket, const std::string& stream,
                                                             Streams::Receiver receiver) {
  if (!is_ticket(ticket)) return fail("bad-ticket", "a ticket is (tcp ADDRESS KEY KEY KEY)", ticket);
  zmq::socket_t socket(context, zmq::socket_type::sub);
  set_common(socket);
  socket.set(zmq::sockopt::conflate, true);
  socket.set(zmq::sockopt::rcvbuf, socket_bytes);
  try {
    socket.set(zmq::sockopt::curve_serverkey, std::string(ticket[server_key].text()));
    socket.set(zmq::sockopt::curve_publickey, std::string(ticket[public_key].text()));
    socket.set(zmq::sockopt::curve_secretkey, std::string(ticket[secret_key].text()));
    socket.set(zmq::sockopt::subscribe, frame_topic(stream));
    const std::string address(ticket[at].text());
    socket.set(zmq::sockopt::ipv6, wire::is_ipv6(address));
    socket.connect(address);
  } catch (const zmq::error_t& error) {
    return fail("bad-ticket", std::string("ZeroMQ refuses it: ") + error.what(), ticket[at]);
  }
  std::unique_ptr<StreamListener> listener(new StreamListener(std::move(socket), stream, std::move(receiver)));
  listener->pump_ = std::make_unique<SocketPump>(
      executor, listener->socket_,
      [made = listener.get()](const zmq::message_t& part) { made->heard(part.to_string_view()); });
  return listener;
}

StreamListener::StreamListener(zmq::socket_t socket, std::string stream, Streams::Receiver receiver)
    : socket_(std::move(socket)), stream_(std::move(stream)), receiver_(std::move(receiver)) {}

void StreamListener::heard(std::string_view text) {
  const std::optional<StreamFrame> frame = frame_from_text(stream_, text);
  if (!frame) return;
  const Streams::Receiver receive = receiver_;
  receive(*frame);
}

}  // namespace pizarra::streams
