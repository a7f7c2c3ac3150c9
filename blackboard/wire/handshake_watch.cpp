#include "blackboard/wire/handshake_watch.hpp"

#include <cstring>

namespace pizarra {

namespace {

constexpr const char* events_at = "inproc://handshakes";
constexpr int broken_off = ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL;
constexpr int refusals = ZMQ_EVENT_HANDSHAKE_FAILED_AUTH | ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL | broken_off;
// Once, it is a board that ended just now, or one whose end of the line came before its reason.
constexpr int most_broken_off = 3;

}  // namespace

HandshakeWatch::HandshakeWatch(Executor& executor, zmq::context_t& context, zmq::socket_t& socket, bool with_key,
                               Listener listener)
    : executor_(executor),
      watched_(socket),
      with_key_(with_key),
      listener_(std::move(listener)),
      events_(context, zmq::socket_type::pair) {
  events_.set(zmq::sockopt::linger, 0);
  zmq_socket_monitor(watched_.handle(), events_at, refusals | ZMQ_EVENT_HANDSHAKE_SUCCEEDED);
  events_.connect(events_at);
  file_ = events_.get(zmq::sockopt::fd);
  executor_.watch_readable(file_, [this] { pump(); });
  // ZeroMQ tells the file of what comes after something was looked for in vain.
  pump();
}

HandshakeWatch::~HandshakeWatch() {
  executor_.unwatch_readable(file_);
  zmq_socket_monitor(watched_.handle(), nullptr, 0);
}

void HandshakeWatch::pump() {
  try {
    zmq::message_t event;
    while (events_.recv(event, zmq::recv_flags::dontwait)) {
      std::uint16_t kind = 0;
      std::uint32_t value = 0;
      const bool formed = event.size() == sizeof kind + sizeof value;
      if (formed) std::memcpy(&kind, event.data(), sizeof kind);
      if (formed) std::memcpy(&value, static_cast<const char*>(event.data()) + sizeof kind, sizeof value);
      while (event.more() && events_.recv(event)) {
      }
      note(kind, value);
    }
  } catch (const zmq::error_t&) {
    // Interrupted by a signal: the next event brings this one along.
  }
}

void HandshakeWatch::note(std::uint16_t event, std::uint32_t value) {
  if (event == ZMQ_EVENT_HANDSHAKE_SUCCEEDED) listener_.let_in();
  broken_off_ = event == broken_off ? broken_off_ + 1 : 0;
  const bool certain = event != broken_off || broken_off_ >= most_broken_off;
  if (certain && (event & refusals) != 0) listener_.refused(failure_of(event, value));
}

Failure HandshakeWatch::failure_of(std::uint16_t event, std::uint32_t value) const {
  if (event == ZMQ_EVENT_HANDSHAKE_FAILED_AUTH) {
    return {"not-permitted", "the board does not accept this key", {}, {}};
  }
  if (event == ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL && value == ZMQ_PROTOCOL_ERROR_ZMTP_MECHANISM_MISMATCH) {
    const char* sentence = with_key_ ? "the board uses no keys at this address, and this client has one: leave it away"
                                     : "the board asks for a key at this address: name one with --key FILE";
    return {"not-permitted", sentence, {}, {}};
  }
  if (with_key_) return {"unreachable", "the board breaks off: its key may be another than board.key says", {}, {}};
  return {"not-permitted", "the board breaks off, as one does that asks for a key: name one with --key FILE", {}, {}};
}

}  // namespace pizarra
