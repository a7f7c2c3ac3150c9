#pragma once

// A board's time at the lead: what it does with the log from when it won until another leads. Its program serves
// clients meanwhile (programs/board/cluster_board.cpp); the tests run the same on a model of etcd, in virtual time.
//
//   const Result<void> leads = co_await stand_by(executor, standby, on_log);
//   Lead lead(executor, needs, keys, standby, standby->must_wait(executor.now()));
//   confirming = executor.spawn(lead.confirm());
//   co_await lead.catch_up();
//   Result<Lead::Begun> begun = lead.begin("etcd://A,B,C/blocks");        // a board's store, and where it writes
//   upkeep = executor.spawn(lead.keep_in_space());
//   co_await lead.until_it_serves();
//   if (lead.may_answer()) ...                                            // before each reply
//   lead.leave();                                                         // then `confirming` ends by itself
//
// It ends where another board leads, which an append may find out first: lead.end(failure).

#include <functional>
#include <memory>
#include <optional>

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/standby.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::cluster {

// How each attempt went: a failure, or that the log answers.
using OnAttempt = std::function<void(const Result<void>&)>;

// Until it leads. It fails with any failure but `unavailable`, which passes by waiting.
Task<Result<void>> stand_by(Executor& executor, std::shared_ptr<Standby> standby, OnAttempt on_log);

class Lead {
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
  Lead(Executor& executor, Needs needs, LogKeys keys, std::shared_ptr<Standby> standby, Duration waits);

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
  const Leadership& leadership() const { return *leadership_; }

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
  const std::shared_ptr<Leadership> leadership_;
  const Time serves_at_;
  std::shared_ptr<LogSpace> space_;
  Term term_;
  bool leaves_ = false;
  std::optional<Failure> ended_;
};

}  // namespace pizarra::cluster
