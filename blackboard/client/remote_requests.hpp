#pragma once

// The requests of a client that the board has not answered yet, by their numbers. Each is sent in its turn, and again
// while no answer comes. Who asked is told what came of it, once.
//
//   RemoteRequests requests(executor, socket, clock);
//   const wire::RequestId id = requests.add({.body = "(ask ...)", .repeatable = true, .done = [](Result<Datum>) {}});
//   requests.begin_session(session);
//   requests.send_waiting();
//   if (requests.contains(id)) requests.take(id)(reply);

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "blackboard/client/clock_offset.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/wire/frame_socket.hpp"
#include "blackboard/wire/wire.hpp"
#include "lisp/datum.hpp"

namespace pizarra::client {

class RemoteRequests {
 public:
  using Done = std::function<void(Result<Datum>)>;
  struct Request {
    std::string body;
    // Whether doing it again on a board that may have done it is harmless.
    bool repeatable = false;
    Done done = {};
    std::optional<Time> deadline = {};
    std::optional<Time> sent = {};
  };
  static constexpr std::size_t most = 1024;
  // Request N waits until all up to N - 128 are answered. The board remembers the answers to a session's last 256
  // requests, in case they are sent again, and keeps half as many for a client that does not read.
  static constexpr wire::RequestId most_ahead = 128;
  // A client and the board tell each other so often how long a fact was under way.
  static constexpr Duration between_timed = 10ms;

  // Of a session they say when they were sent, by the board's clock. All three outlive them.
  RemoteRequests(Executor& executor, wire::FrameSocket& socket, const ClockOffset& board_clock)
      : executor_(executor), socket_(socket), board_clock_(board_clock) {}

  bool empty() const { return requests_.empty(); }
  bool is_full() const { return requests_.size() >= most; }
  wire::RequestId add(Request request);
  void forget(wire::RequestId id) { requests_.erase(id); }
  bool contains(wire::RequestId id) const { return requests_.contains(id); }
  // Takes out one that is there, and answers who is to be told.
  Done take(wire::RequestId id);
  // Whether some wait for others to be answered.
  bool some_wait() const { return first_waiting_ < next_; }

  // The session that they are sent in from now on. Where the server has forgotten the one before, those fail that may
  // have been done in it.
  void begin_session(wire::SessionId session);
  // Those that may go: all of them where the server has forgotten nothing, else those that were not sent in this
  // session.
  void send_all(bool is_session_before);
  void send(wire::RequestId id) { send(id, requests_.at(id)); }
  // Those that wait and may go, together.
  void send_waiting();
  // Also those whose answer is overdue.
  void send_again();
  // Those that a board answers which does not know whether it leads. One that leads is asked anew.
  void send_recalls();

  // Fails those for which the condition holds.
  void fail_where(const std::function<bool(Request&)>& condition, const Failure& failure);

  // Whether it is answered by a board that does not know whether it leads.
  static bool recalls(std::string_view body) { return body.starts_with("(recall "); }

 private:
  void fail_what_may_have_happened();
  void send(wire::RequestId id, Request& request);
  void write_to(std::string& frame, wire::RequestId id, const Request& request, Time now);
  std::optional<Time> time_to_say(const Request& request, Time now);

  Executor& executor_;
  wire::FrameSocket& socket_;
  const ClockOffset& board_clock_;
  std::map<wire::RequestId, Request> requests_;
  wire::SessionId session_ = 0;
  wire::RequestId next_ = 1;
  wire::RequestId first_waiting_ = 1;  // all before it may have gone
  Time timed_{};                       // the last one that said when it was sent
};

}  // namespace pizarra::client
