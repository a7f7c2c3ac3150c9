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

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "blackboard/board.hpp"
#include "blackboard/client/remote_session.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/wire/keys.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::client {

class RemoteBoard : public Board, private RemoteSession::Client {
 public:
  static constexpr Duration default_timeout = 5s;

  // With keys the teller is called by its key's name: KEY where that is its own, KEY/TELLER otherwise. Failures
  // bad-address and, as of check_teller_name(), bad-name.
  static Result<std::unique_ptr<RemoteBoard>> connect(Executor& executor, const std::string& address,
                                                      std::string teller, Duration timeout = default_timeout,
                                                      const std::optional<wire::ClientKeys>& keys = std::nullopt,
                                                      wire::Transport& transport = wire::zeromq());
  RemoteBoard(const RemoteBoard&) = delete;
  RemoteBoard& operator=(const RemoteBoard&) = delete;
  ~RemoteBoard() override;

  bool connected() const { return session_.joined(); }
  // For how long nothing has been heard from the board; it is asked for a sign of life every half second.
  Duration silence() const { return executor_.now() - session_.heard(); }
  // When the board said that it ends; nothing where it was heard again since.
  const std::optional<Time>& said_goodbye() const { return session_.said_goodbye(); }
  // The board's clock, as far as its answers tell: what a fact's `when` is to be compared with. Nothing until it has
  // said so.
  std::optional<Time> board_time() const { return session_.board_clock().there(executor_.now()); }

  // From now on nothing waits for a quorum: what was not sent by then fails with `unavailable` and was not done.
  void refuse_without_quorum() { session_.refuse_without_quorum(); }
  // Where the board does not know whether it leads: how long ago it still knew that it did.
  const std::optional<Duration>& in_doubt_since() const { return session_.in_doubt_since(); }

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

  RemoteBoard(Executor& executor, const std::string& address, std::vector<std::string> addresses, std::string teller,
              Duration timeout, wire::Transport& transport);
  Task<Result<Datum>> call(Datum body, bool repeatable);
  Task<Result<Datum>> call_text(std::string body, bool repeatable);

  void begin_again() override;
  void reply_comes(std::optional<std::uint64_t> revision, bool is_all_sent) override;
  void heard(wire::WatchId watch, const Datum& message) override;
  void say_again() override;
  void redeclare();

  Executor& executor_;
  const Duration timeout_;
  RemoteSession session_;
  std::map<std::string, Relation> declared_;
  Time arrival_timed_{};  // the last change of which it is said how long it took
  wire::WatchId next_watch_ = 1;
  std::map<wire::WatchId, class RemoteChanges*> streams_;
  std::unique_ptr<class Replicas> replicas_;
};

}  // namespace pizarra::client
