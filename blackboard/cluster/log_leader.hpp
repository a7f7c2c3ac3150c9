#pragma once

// The work of a leading board on its log, from when it won an epoch (won_epoch.hpp) until another leads. Its program
// serves clients meanwhile (programs/board/cluster_board.cpp); the tests run the same on a model of etcd, in virtual
// time.
//
//   const Result<void> leads = co_await stand_by(executor, standby, on_log);
//   LogLeader leader(executor, needs, keys, standby, standby->must_wait(executor.now()));
//   confirming = executor.spawn(leader.confirm());
//   co_await leader.catch_up();
//   Result<LogLeader::Begun> begun = leader.begin("etcd://A,B,C/blocks");   // a board's store, and where it writes
//   upkeep = executor.spawn(leader.keep_in_space());
//   co_await leader.until_it_serves();
//   if (leader.may_answer()) ...                                            // before each reply
//   leader.leave();                                                         // then `confirming` ends by itself
//
// It ends where another board leads, which an append may find out first: leader.end(failure).

#include <functional>
#include <memory>
#include <optional>

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/standby.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::cluster {

class LogLeader {
 public:
  struct Needs {
    // One for each of those who wait for answers at the same time.
    std::function<Result<std::shared_ptr<KeyValues>>()> connect;
    std::function<std::uint64_t()> nonce;
    std::function<Duration()> uptime;  // uptime.hpp
    OnAttempt on_log;
    OnAttempt on_upkeep;
    std::function<void()> on_end;
  };
  struct Counters {
    Revision revision = 0;
    FactId fact = 0;
  };
  struct Begun {
    std::shared_ptr<ClusterLog> log;
    std::unique_ptr<store::Store> store;
    std::vector<journal::RememberedReply> replies;
  };

  // `waits`: how long whoever led before may still answer.
  LogLeader(Executor& executor, Needs needs, LogKeys keys, std::shared_ptr<Standby> standby, Duration waits);

  // Of the board that serves; nothing before there is one.
  std::function<Counters()> counters = [] { return Counters(); };

  // Until leave(), and then it says that it answers nobody any more.
  Task<void> confirm();
  // What came to the log before this board led.
  Task<void> catch_up();
  Result<Begun> begin(const std::string& path);
  Task<void> until_it_serves();
  Task<void> keep_in_space();

  bool may_answer() const;
  // How old what it knows may be; nothing where it does not lead any more, or never knew that it did.
  std::optional<Duration> age() const;
  const WonEpoch& epoch() const { return *epoch_; }

  void leave() { leaves_ = true; }
  void end(const Failure& failure);
  const std::optional<Failure>& ended() const { return ended_; }

 private:
  void heard(const Result<Revision>& up_to, Duration sent);
  Result<std::shared_ptr<KeyValues>> connect();

  Executor& executor_;
  const Needs needs_;
  const LogKeys keys_;
  const std::shared_ptr<Standby> standby_;
  const std::shared_ptr<WonEpoch> epoch_;
  const Time serves_at_;
  std::shared_ptr<LogSpace> space_;
  LastConfirmation confirmation_;
  bool leaves_ = false;
  std::optional<Failure> ended_;
};

}  // namespace pizarra::cluster
