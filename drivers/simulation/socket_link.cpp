#include "drivers/simulation/socket_link.hpp"

#include "drivers/simulation/link_wire.hpp"

namespace pizarra::simulation {

SocketLink::SocketLink(Executor& executor, zmq::context_t& context, const std::string& address)
    : executor_(executor), calls_(executor), socket_(context, zmq::socket_type::dealer) {
  link_wire::limit(socket_);
  // Calls to a world that is away fail at once instead of being kept for the next one.
  socket_.set(zmq::sockopt::immediate, 1);
  socket_.connect(address);
  executor_.watch_readable(socket_.get(zmq::sockopt::fd), [this] { receive(); });
}

SocketLink::~SocketLink() { executor_.unwatch_readable(socket_.get(zmq::sockopt::fd)); }

Result<void> SocketLink::send(std::uint64_t id, const Datum& request) {
  const std::string text = link_wire::call_text({id, request});
  if (text.size() > link_wire::longest_text) return fail("bad-request", "the request is too long");
  const auto sent = socket_.send(zmq::buffer(text), zmq::send_flags::dontwait);
  if (!sent) return fail("disconnected", "the world is away");
  // Sending may swallow the descriptor's one signal that something has arrived.
  receive();
  return {};
}

Task<Result<Message>> SocketLink::call(Datum request, Duration timeout) {
  if (calls_.size() >= link_wire::most_calls) co_return fail("busy", "too many calls wait on the device link");
  const Time deadline = executor_.now() + timeout;
  OpenCalls::Call waiting(calls_);
  Result<void> sent = send(waiting.number(), request);
  // The world may be about to come up, or only just gone.
  while (!sent) {
    const bool away = sent.error().symbol == "disconnected";
    if (!away) co_return fail(sent);
    if (executor_.now() + reconnect_poll > deadline) co_return fail(sent);
    co_await sleep(executor_, reconnect_poll);
    sent = send(waiting.number(), request);
  }
  std::optional<Result<Message>> answer = co_await waiting.answer(deadline);
  if (!answer) co_return fail("disconnected", "the world did not answer in time", request);
  co_return std::move(*answer);
}

void SocketLink::receive() {
  while (auto parts = link_wire::receive_parts(socket_)) {
    Result<link_wire::WireAnswer> answer = link_wire::read_answer(*parts);
    if (answer) calls_.take(answer->id, std::move(answer->message));
  }
}

}  // namespace pizarra::simulation
