#pragma once

// A client's session with the board of another process, which is greeted until it answers, asked for a sign of life,
// and greeted again when it is lost. Where several boards keep one cell, the others are tried then.
//
// Lifecycle: made, connected once, and destroyed after all tasks that call(). Its client outlives it.
//
//   RemoteSession session(executor, "ipc:///tmp/cell", {"ipc:///tmp/cell"}, "vision", client, wire::zeromq());
//   Result<void> connected = session.connect(nullptr);
//   Result<Datum> reply = co_await session.call("(renew 3)", true, 5s);

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "blackboard/client/clock_offset.hpp"
#include "blackboard/client/remote_requests.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/time/task.hpp"
#include "blackboard/wire/frame_socket.hpp"
#include "blackboard/wire/keys.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::client {

class RemoteSession {
 public:
  // Whose session it is.
  class Client {
   public:
    virtual ~Client() = default;
    // The server has forgotten what was declared and watched.
    virtual void begin_again() = 0;
    // Before each reply: at which revision it is, and whether all changes up to that one were sent before, where the
    // server says so.
    virtual void reply_comes(std::optional<std::uint64_t> revision, bool is_all_sent) = 0;
    // What is said of a watch.
    virtual void heard(wire::WatchId watch, const Datum& message) = 0;
    // Some time has gone by in the session: what could not be said before may be said now.
    virtual void say_again() = 0;
  };

  // `address` is all of the addresses, as they were given.
  RemoteSession(Executor& executor, std::string address, std::vector<std::string> addresses, std::string teller,
                Client& client, wire::Transport& transport);
  RemoteSession(const RemoteSession&) = delete;
  RemoteSession& operator=(const RemoteSession&) = delete;
  ~RemoteSession();

  // Failure bad-address.
  Result<void> connect(const wire::ClientKeys* keys);

  // Beyond the time, fails with unreachable or unavailable.
  Task<Result<Datum>> call(std::string body, bool repeatable, Duration timeout);
  // A request that the session depends on, sent before those that wait for it. It has no end but its answer.
  wire::RequestId begin(std::string body, RemoteRequests::Done done);
  void forget(wire::RequestId request) { requests_.forget(request); }
  // False, and nothing sent, where that cannot be sent now.
  bool send(const Datum& message);

  wire::SessionId id() const { return id_; }
  bool joined() const { return joined_; }
  Time heard() const { return heard_; }
  const std::optional<Time>& said_goodbye() const { return goodbye_; }
  const ClockOffset& board_clock() const { return board_clock_; }
  const std::optional<Duration>& in_doubt_since() const { return in_doubt_; }
  void refuse_without_quorum() { waits_for_quorum_ = false; }

 private:
  void receive(std::string_view frame);
  void hear(const Datum& message);
  void greet();
  void welcomed(wire::SessionId session, wire::SessionId life);
  void ponged(Time said);
  void lose();
  void forget_greetings();
  void try_others(Time now);
  bool has_others() const { return addresses_.size() > 1; }
  void refused(const Failure& failure);
  void replied(const Datum& message);
  // Sends the requests that wait and may go, in one frame, when all callbacks that are due have run.
  void transmit_soon();
  void tick();
  void keep_alive(Time now);
  void give_up_overdue(Time due);
  void be_in_doubt(Duration age);
  Failure unavailable(bool sent) const;

  static constexpr const char* no_answer = "the board does not answer";

  Executor& executor_;
  const std::string address_;
  const std::vector<std::string> addresses_;
  std::size_t at_ = 0;          // which of them
  Time tried_{};                // since when
  Duration tries_for_ = 120ms;  // before the next one
  const std::string teller_;
  Client& client_;
  bool joined_ = false;
  bool is_of_the_first_ = false;  // whether the board seems to speak the first protocol
  int newer_hellos_ = 0;          // of a later protocol, sent and not refused
  wire::SessionId id_ = 0;
  wire::SessionId life_ = 0;  // the server's
  Time heard_{};
  Time greeted_{};
  Time pinged_{};
  int pings_under_way_ = 0;
  std::optional<Time> connect_again_;
  std::optional<Time> goodbye_;
  std::optional<Duration> in_doubt_;
  std::string silence_ = no_answer;  // what is known of it
  bool waits_for_quorum_ = true;
  ClockOffset board_clock_;
  Executor::TimerId tick_timer_ = 0;
  Executor::TimerId transmit_timer_ = 0;
  std::unique_ptr<wire::FrameSocket> socket_;
  RemoteRequests requests_;
};

}  // namespace pizarra::client
