#include "drivers/line/exchanges.hpp"

#include <cassert>

#include "drivers/line/device_at.hpp"

namespace pizarra::line {

struct Exchanges::Waiting {
  Waiting(Exchanges& the_exchanges, std::uint32_t the_id)
      : exchanges(the_exchanges), id(the_id), come(the_exchanges.executor_) {
    exchanges.waiting_[id] = this;
  }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;
  ~Waiting() { exchanges.waiting_.erase(id); }

  Exchanges& exchanges;
  std::uint32_t id;
  Event come;
  std::string reply;
};

Exchanges::~Exchanges() { assert(waiting_.empty()); }

Task<Result<void>> Exchanges::open(Time deadline) {
  receiving_ = Job();
  const Result<void> open = co_await wire_.open(deadline);
  if (!open) co_return open;
  receiving_ = executor_.spawn(receive());
  co_return Result<void>();
}

Task<void> Exchanges::receive() {
  while (true) {
    const Time deadline = executor_.now() + look_again;
    Result<std::string> datagram = co_await wire_.receive(deadline);
    if (!datagram && datagram.error().symbol != "timeout") co_return;
    if (!datagram) continue;
    const std::optional<std::uint32_t> id = reply_id_(*datagram);
    if (!id) continue;
    const auto found = waiting_.find(*id);
    // A second copy, or one that came too late.
    if (found == waiting_.end() || found->second->come.is_set()) continue;
    found->second->reply = std::move(*datagram);
    found->second->come.set();
  }
}

Task<Result<std::string>> Exchanges::ask(std::uint32_t id, std::string request, Retries retries) {
  if (waiting_.contains(id)) co_return fail("busy", "too many requests wait for the device");
  Waiting waiting(*this, id);
  for (int i = 0; i < retries.tries; ++i) {
    const Result<void> sent = wire_.send(request);
    if (!sent) co_return fail(sent);
    const Time deadline = executor_.now() + retries.pause;
    const bool come = co_await waiting.come.wait(deadline);
    if (come) co_return std::move(waiting.reply);
  }
  co_return fail("no-answer", device_at("the device", wire_.place()) + " did not answer");
}

}  // namespace pizarra::line
