#pragma once

// Requests and their replies over a line that loses, repeats and delays datagrams. A request bears an id that its reply
// repeats, so that several wait at once and none takes another's reply; it is sent again, the same, until the reply
// comes. A request that must not be carried out twice is sent once (`tries` 1), and its sender finds out whether it
// was.
//
//   Exchanges exchanges(executor, wire, hses_reply_id);
//   const Result<void> open = co_await exchanges.open(deadline);
//   const Result<std::string> reply = co_await exchanges.ask(id, request, {.tries = 100, .pause = 10ms});
//
// Failures: no-answer, disconnected, busy (an id that waits already).

#include <map>
#include <optional>

#include "blackboard/time/latch.hpp"
#include "drivers/line/datagram_wire.hpp"

namespace pizarra::line {

struct Retries {
  int tries = 100;
  Duration pause = 10ms;
};

class Exchanges {
 public:
  // The id that a datagram repeats; none where it is no reply at all.
  using ReplyId = std::optional<std::uint32_t> (*)(std::string_view datagram);

  // The wire outlives it.
  Exchanges(Executor& executor, DatagramWire& wire, ReplyId reply_id)
      : executor_(executor), wire_(wire), reply_id_(reply_id) {}
  ~Exchanges();
  Exchanges(const Exchanges&) = delete;
  Exchanges& operator=(const Exchanges&) = delete;

  Task<Result<void>> open(Time deadline);
  Task<Result<std::string>> ask(std::uint32_t id, std::string request, Retries retries = {});

 private:
  static constexpr Duration look_again = 3600s;
  struct Waiting;
  Task<void> receive();

  Executor& executor_;
  DatagramWire& wire_;
  ReplyId reply_id_;
  std::map<std::uint32_t, Waiting*> waiting_;
  Job receiving_;
};

}  // namespace pizarra::line
