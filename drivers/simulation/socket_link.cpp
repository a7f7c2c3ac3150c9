#include "drivers/simulation/socket_link.hpp"

#include <cassert>

#include "drivers/simulation/link_wire.hpp"

namespace pizarra::simulation {

struct SocketLink::Waiting {
  Waiting(SocketLink& the_link, std::uint64_t the_id) : link(the_link), id(the_id), answered(the_link.executor_) {
    link.waiting_[id] = this;
  }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;
  ~Waiting() { link.waiting_.erase(id); }

  SocketLink& link;
  std::uint64_t id;
  Event answered;
  Result<Message> answer;
};

SocketLink::SocketLink(Executor& executor, zmq::context_t& context, const std::string& address)
    : executor_(executor), socket_(context, zmq::socket_type::dealer) {
  link_wire::limit(socket_);
  // Calls to a world that is away fail at once instead of being kept for the next one.
  socket_.set(zmq::sockopt::immediate, 1);
  socket_.connect(address);
  executor_.watch_readable(socket_.get(zmq::sockopt::fd), [this] { receive(); });
}

SocketLink::~SocketLink() {
  assert(waiting_.empty());
  executor_.unwatch_readable(socket_.get(zmq::sockopt::fd));
}

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
  if (waiting_.size() >= link_wire::most_calls) co_return fail("busy", "too many calls wait on the device link");
  const Time deadline = executor_.now() + timeout;
  const std::uint64_t id = ++last_id_;
  Waiting waiting(*this, id);
  Result<void> sent = send(id, request);
  // The world may be about to come up, or only just gone.
  while (!sent) {
    const bool away = sent.error().symbol == "disconnected";
    if (!away) co_return fail(sent);
    if (executor_.now() + reconnect_poll > deadline) co_return fail(sent);
    co_await sleep(executor_, reconnect_poll);
    sent = send(id, request);
  }
  const bool answered = co_await waiting.answered.wait(deadline);
  if (!answered) co_return fail("disconnected", "the world did not answer in time", request);
  co_return std::move(waiting.answer);
}

void SocketLink::receive() {
  while (auto parts = link_wire::receive_parts(socket_)) {
    Result<link_wire::WireAnswer> answer = link_wire::read_answer(*parts);
    if (!answer) continue;
    const auto found = waiting_.find(answer->id);
    // Nobody waits for it any more: it came after its deadline.
    if (found == waiting_.end()) continue;
    found->second->answer = std::move(answer->message);
    found->second->answered.set();
  }
}

}  // namespace pizarra::simulation
