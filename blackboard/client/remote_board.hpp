#pragma once

// The wall to another process: a Board whose facts a BoardServer keeps.
//
//   Result<std::unique_ptr<RemoteBoard>> board = RemoteBoard::connect(executor, "ipc:///tmp/cell", "vision");
//
// Where several boards keep one cell, their addresses stand with commas between them: the one that leads answers, and
// when it is silent the others are tried.
//
// The server need not be there yet. A request is sent again while it is not answered, and fails with `unreachable`
// after five seconds. A board that refuses the client, or its key, has its requests fail with `not-permitted` at once,
// and is tried again every second. When the server was lost, relations are declared again and watches begin again
// (their next change is a resynchronised one); leases are lost (`unknown-lease`). A server that remembers the session
// from its journal does an interrupted transaction or take exactly once. On a server that does not, it fails with
// `unreachable`, because nobody can say whether it happened.
//
// Of several boards it may be that none can say whether it leads: they have no quorum of their log. Requests then wait,
// and fail with `unavailable`, or at once where the client wants that. recall() is answered even so, by what may be
// old.
//
// It outlives its watches and the tasks that use it.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "blackboard/board.hpp"
#include "blackboard/client/clock_offset.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/wire/frame_socket.hpp"
#include "blackboard/wire/keys.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::client {

class RemoteBoard : public Board {
 public:
  static constexpr Duration default_timeout = 5s;
  static constexpr std::size_t max_pending = 1024;  // requests that wait for an answer
  // Request N waits until all up to N - 128 are answered. The board remembers the answers to a session's last 256
  // requests, in case they are sent again, and keeps half as many for a client that does not read.
  static constexpr wire::RequestId most_ahead = 128;

  // With keys the teller is called by its key's name: KEY where that is its own, KEY/TELLER otherwise. Failures
  // bad-address and, as of check_teller_name(), bad-name.
  static Result<std::unique_ptr<RemoteBoard>> connect(Executor& executor, const std::string& address,
                                                      std::string teller, Duration timeout = default_timeout,
                                                      const std::optional<wire::ClientKeys>& keys = std::nullopt,
                                                      wire::Transport& transport = wire::zeromq());
  RemoteBoard(const RemoteBoard&) = delete;
  RemoteBoard& operator=(const RemoteBoard&) = delete;
  ~RemoteBoard() override;

  bool connected() const { return joined_; }
  // For how long nothing has been heard from the board; it is asked for a sign of life every half second.
  Duration silence() const { return executor_.now() - heard_; }
  // When the board said that it ends; nothing where it was heard again since.
  const std::optional<Time>& said_goodbye() const { return goodbye_; }
  // The board's clock, as far as its answers tell: what a fact's `when` is to be compared with. Nothing until it has
  // said so.
  std::optional<Time> board_time() const { return board_clock_.there(executor_.now()); }

  // From now on nothing waits for a quorum: what was not sent by then fails with `unavailable` and was not done.
  void refuse_without_quorum() { waits_for_quorum_ = false; }
  // Where the board does not know whether it leads: how long ago it still knew that it did.
  const std::optional<Duration>& in_doubt_since() const { return in_doubt_; }

  // Answers as things stood `age` ago or later. What is not settled may be undone.
  struct Recalled {
    Answers answers;
    Duration age{};
    bool settled = true;
  };
  // The same as ask() while a board leads.
  Task<Result<Recalled>> recall(Query query);

  // Declares the relation and holds its facts from then on: a question about it alone is answered here, as it is at a
  // revision that has all that this board's own requests did. Failures as of declare() and watch().
  Task<Result<void>> replicate(Relation relation);

  Task<Result<void>> declare(std::vector<Relation> relations) override;
  Task<Result<Revision>> transact(Transaction transaction) override;
  Task<Result<Answers>> ask(Query query) override;
  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override;
  Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) override;
  Task<Result<LeaseId>> lease(Duration length) override;
  Task<Result<void>> renew(LeaseId lease) override;
  Task<Result<void>> release(LeaseId lease) override;

 private:
  friend class RemoteChanges;
  using Done = std::function<void(Result<Datum>)>;
  struct Pending {
    std::string body;
    // Whether doing it again on a board that may have done it is harmless.
    bool repeatable;
    Done done;
    std::optional<Time> deadline = {};
    std::optional<Time> sent = {};
  };

  RemoteBoard(Executor& executor, std::string address, std::vector<std::string> addresses, std::string teller,
              Duration timeout, wire::Transport& transport);
  Task<Result<Datum>> call(Datum body, bool repeatable);
  Task<Result<Datum>> call_text(std::string body, bool repeatable);
  wire::RequestId begin(std::string body, bool repeatable, Done done);
  void forget(wire::RequestId request) { pending_.erase(request); }
  // Sends the requests that wait and may go, in one frame, when all callbacks that are due have run.
  void transmit_soon();
  void transmit_waiting();
  void transmit(wire::RequestId request, Pending& pending);
  void write_request(std::string& frame, wire::RequestId request, const Pending& pending, Time now);
  std::optional<Time> time_to_say(const Pending& pending, Time now);
  bool send(const Datum& message);

  void receive(std::string_view frame);
  void hear(const Datum& message);
  void greet();
  void welcomed(wire::SessionId session, wire::SessionId life);
  void lose_session();
  void forget_greetings();
  void try_others(Time now);
  bool has_others() const { return addresses_.size() > 1; }
  // Fails those requests under way for which the condition holds.
  template <class Condition>
  void fail_where(const Condition& condition, const Failure& failure);
  void refused(const Failure& failure);
  void fail_what_may_have_happened();
  void redeclare();
  void replied(const Datum& message);
  void tick();
  void retransmit(Time now);
  void give_up_overdue(Time now);
  static bool recalls(std::string_view body) { return body.starts_with("(recall "); }
  void be_in_doubt(Duration age);
  Failure unavailable(bool sent) const;

  Executor& executor_;
  const std::string address_;  // or several, as they were given
  const std::vector<std::string> addresses_;
  std::size_t at_ = 0;          // which of them
  Time tried_{};                // since when
  Duration tries_for_ = 120ms;  // before the next one
  const std::string teller_;
  const Duration timeout_;
  bool joined_ = false;
  bool is_of_the_first_ = false;  // whether the board seems to speak the first protocol
  int newer_hellos_ = 0;          // of a later protocol, sent and not refused
  wire::SessionId session_ = 0;
  wire::SessionId life_ = 0;  // the server's
  Time heard_{};
  Time greeted_{};
  Time pinged_{};
  std::optional<Time> connect_again_;
  std::optional<Time> goodbye_;
  std::optional<Duration> in_doubt_;
  static constexpr const char* no_answer = "the board does not answer";
  std::string silence_ = no_answer;  // what is known of it
  bool waits_for_quorum_ = true;
  ClockOffset board_clock_;
  int pings_under_way_ = 0;
  static constexpr Duration between_timed = 10ms;
  Time timed_{};          // the last request that said when it was sent
  Time arrival_timed_{};  // the last change of which it is said how long it took
  wire::RequestId next_request_ = 1;
  wire::RequestId first_waiting_ = 1;  // all before it may have gone
  wire::WatchId next_watch_ = 1;
  std::map<wire::RequestId, Pending> pending_;
  std::map<std::string, Relation> declared_;
  std::map<wire::WatchId, class RemoteChanges*> streams_;
  std::unique_ptr<class Replicas> replicas_;
  Executor::TimerId tick_timer_ = 0;
  Executor::TimerId transmit_timer_ = 0;
  std::unique_ptr<wire::FrameSocket> socket_;
};

}  // namespace pizarra::client
