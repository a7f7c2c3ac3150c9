#include "blackboard/wire/wire_socket.hpp"

#include <unistd.h>

#include "blackboard/wire/address_to_bind.hpp"
#include "blackboard/wire/half_open.hpp"
#include "blackboard/wire/wire_address.hpp"

namespace pizarra::wire {

namespace {

// Then others have their turn: a group of the journal is on its way to the disk while the next one comes.
constexpr int messages_at_once = 16;
// ZeroMQ takes a message of each connection in turn, and a board has no more sessions.
constexpr int a_turn_of_each = 1024;
// A message that has reached this machine is in the socket by then, even where its threads wait for busy processors.
constexpr Duration under_way_at_most = 100ms;
constexpr int linger_ms = 50;
constexpr int reconnect_ms = 50;
constexpr int reconnect_most_ms = 1000;

std::unexpected<Failure> refused_address(const zmq::error_t& error, const std::string& address) {
  const char* symbol = error.num() == EADDRINUSE ? "address-in-use" : "bad-address";
  return fail(symbol, std::string("ZeroMQ refuses the address: ") + error.what(), to_datum(address));
}

std::string user_of(zmq::message_t& message) {
  const char* user = zmq_msg_gets(message.handle(), "User-Id");
  return user == nullptr ? "" : user;
}

}  // namespace

WireSocket::WireSocket(Executor& executor, Kind kind, Receiver receiver)
    : executor_(executor),
      kind_(kind),
      receiver_(std::move(receiver)),
      context_(1),
      socket_(context_, kind == Kind::router ? zmq::socket_type::router : zmq::socket_type::dealer) {
  socket_.set(zmq::sockopt::linger, linger_ms);
  socket_.set(zmq::sockopt::sndhwm, high_water);
  socket_.set(zmq::sockopt::rcvhwm, kind == Kind::router ? read_ahead : high_water);
  socket_.set(zmq::sockopt::maxmsgsize, longest_message);
  let_go_when_half_open(socket_);
  if (kind == Kind::router) {
    // Otherwise what cannot be delivered would be lost without a word.
    socket_.set(zmq::sockopt::router_mandatory, true);
    end_the_endless();
  } else {
    // A message to a server that is away would reach the next one, which knows nothing of it.
    socket_.set(zmq::sockopt::immediate, true);
    socket_.set(zmq::sockopt::reconnect_ivl, reconnect_ms);
    socket_.set(zmq::sockopt::reconnect_ivl_max, reconnect_most_ms);
  }
  file_ = socket_.get(zmq::sockopt::fd);
  executor_.watch_readable(file_, [this] { pump(); });
}

WireSocket::~WireSocket() {
  executor_.unwatch_readable(file_);
  if (pump_timer_ != 0) executor_.cancel(pump_timer_);
  // ZeroMQ leaves them behind. One that is gone already is fine.
  for (const std::string& file : bound_files_) unlink(file.c_str());
}

void WireSocket::end_the_endless() {
  const auto ended = [this] {
    sender_key_.clear();
    receiver_("", std::nullopt);
  };
  endless_.emplace(executor_, context_, socket_, longest_message,
                   EndlessWatch::Listener{.heard_until = [this] { return heard_until(); }, .ended = ended});
}

Result<std::string> WireSocket::bind(const std::string& address, const KeyPair* own) {
  const Result<std::string> place = address_to_bind(address);
  if (!place) return fail(place);
  try {
    // Each address keeps the options that were set when it was bound.
    socket_.set(zmq::sockopt::curve_server, own != nullptr);
    if (own != nullptr) socket_.set(zmq::sockopt::curve_secretkey, own->secret_key);
    socket_.set(zmq::sockopt::ipv6, is_ipv6(address));
    keyed_ = keyed_ || own != nullptr;
    socket_.bind(*place);
    schedule_pump();
    std::string bound = socket_.get(zmq::sockopt::last_endpoint);
    if (is_ipc(bound)) bound_files_.push_back(ipc_path(bound));
    return bound;
  } catch (const zmq::error_t& error) {
    return refused_address(error, address);
  }
}

Result<void> WireSocket::connect(const std::string& address, const ClientKeys* keys, std::optional<Listener> listener) {
  try {
    if (keys != nullptr) {
      socket_.set(zmq::sockopt::curve_serverkey, keys->board_key);
      socket_.set(zmq::sockopt::curve_publickey, keys->own.public_key);
      socket_.set(zmq::sockopt::curve_secretkey, keys->own.secret_key);
    }
    if (listener) handshakes_.emplace(executor_, context_, socket_, keys != nullptr, std::move(*listener));
    connected_to_ = address;
    socket_.set(zmq::sockopt::ipv6, is_ipv6(address));
    socket_.connect(address);
    schedule_pump();
    return {};
  } catch (const zmq::error_t& error) {
    return refused_address(error, address);
  }
}

void WireSocket::connect_again() { connect_to(connected_to_); }

void WireSocket::connect_to(const std::string& address) {
  try {
    socket_.disconnect(connected_to_);
  } catch (const zmq::error_t&) {
    // ZeroMQ may have let go of it by itself.
  }
  connected_to_ = address;
  socket_.set(zmq::sockopt::ipv6, is_ipv6(address));
  socket_.connect(connected_to_);
  schedule_pump();
}

bool WireSocket::send(const std::string& peer, std::string_view frame) {
  // Sending may consume the one sign that something has come; who is pumping looks again in any case.
  if (!pumping_) schedule_pump();
  const auto dont_wait = zmq::send_flags::dontwait;
  try {
    if (kind_ == Kind::dealer) return socket_.send(zmq::buffer(frame), dont_wait).has_value();
    if (under_way_.bytes_to(peer) + frame.size() > most_under_way) return false;
    const auto routed = socket_.send(zmq::buffer(peer), dont_wait | zmq::send_flags::sndmore);
    return routed && socket_.send(under_way_.message(peer, frame), dont_wait).has_value();
  } catch (const zmq::error_t&) {
    // The peer is gone: EHOSTUNREACH.
    return false;
  }
}

void WireSocket::pump() {
  const Time begun = executor_.now();
  pumping_ = true;
  int received = 0;
  while (received < messages_at_once && receive_one()) ++received;
  pumping_ = false;
  note_look(begun, received);
  if (received == messages_at_once) schedule_pump();
}

Time WireSocket::heard_until() {
  schedule_pump();
  return heard_until_;
}

void WireSocket::note_look(Time begun, int received) {
  received_in_round_ += received;
  const bool found_all = received < messages_at_once && begun >= round_begun_ + under_way_at_most;
  if (!found_all && received_in_round_ < a_turn_of_each) return;
  heard_until_ = std::exchange(round_begun_, begun);
  received_in_round_ = 0;
}

bool WireSocket::receive_one() {
  std::string peer;
  zmq::message_t part;
  try {
    if (!socket_.recv(part, zmq::recv_flags::dontwait)) return false;
    if (kind_ == Kind::router) {
      peer = part.to_string();
      if (!part.more() || !socket_.recv(part)) return true;
    }
    if (keyed_) sender_key_ = user_of(part);
    if (endless_ && endless_->suspects_any()) endless_->heard(part);
    const bool whole = !part.more();
    if (whole) {
      receiver_(peer, part.to_string_view());
      return true;
    }
    while (part.more() && socket_.recv(part)) {
    }
  } catch (const zmq::error_t&) {
    // Interrupted by a signal; the executor comes back.
    schedule_pump();
    return false;
  }
  receiver_(peer, std::nullopt);
  return true;
}

void WireSocket::schedule_pump() {
  if (pump_timer_ != 0) return;
  pump_timer_ = executor_.call_at(executor_.now(), [this] {
    pump_timer_ = 0;
    pump();
  });
}

namespace {

class ZeroMq : public Transport {
 public:
  std::unique_ptr<FrameSocket> open(Executor& executor, FrameSocket::Kind kind,
                                    FrameSocket::Receiver receiver) override {
    return std::make_unique<WireSocket>(executor, kind, std::move(receiver));
  }
};

}  // namespace

Transport& zeromq() {
  static ZeroMq transport;
  return transport;
}

}  // namespace pizarra::wire
