#include "blackboard/wire/handshake_watch.hpp"

namespace pizarra::wire {

namespace {

constexpr int broken_off = ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL;
constexpr int refusals = ZMQ_EVENT_HANDSHAKE_FAILED_AUTH | ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL | broken_off;
// Once, it is a board that ended just now, or one whose end of the line came before its reason.
constexpr int most_broken_off = 3;

}  // namespace

HandshakeWatch::HandshakeWatch(Executor& executor, zmq::context_t& context, zmq::socket_t& socket, bool with_key,
                               Listener listener)
    : with_key_(with_key),
      listener_(std::move(listener)),
      events_(executor, context, socket, refusals | ZMQ_EVENT_HANDSHAKE_SUCCEEDED,
              [this](std::uint16_t event, std::uint32_t value) { note(event, value); }) {}

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
  if (with_key_) {
    return {"unreachable",
            "the board breaks off: its key is another than board.key says, or it uses no keys at this address",
            {},
            {}};
  }
  return {"not-permitted", "the board breaks off, as one does that asks for a key: name one with --key FILE", {}, {}};
}

}  // namespace pizarra::wire
