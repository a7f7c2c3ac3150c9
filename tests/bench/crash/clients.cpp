#include "tests/bench/crash/clients.hpp"

#include <map>

#include "blackboard/time/real_executor.hpp"
#include "tests/bench/crash/client_tools.hpp"

namespace pizarra::bench {

namespace {

constexpr int at_once = 4;
constexpr Duration taker_lease = 1s;
constexpr Duration look_again_after = 100ms;
constexpr int more_than_is_remembered = 600;  // of a session's replies, 256
constexpr Duration longest_flood = 2s;
constexpr Duration between_floods = 1s;

Task<void> pause(Executor& executor, Duration length) { co_await sleep(executor, length); }

Task<void> tell_on(Board& board, int writer, std::int64_t& next, int reports) {
  co_await declare(board);
  while (true) {
    const std::int64_t n = ++next;
    Transaction transaction;
    transaction.tell(list("item"_sym, writer, n)).tell(list("counter"_sym, writer, n));
    const Result<Revision> told = co_await board.transact(std::move(transaction));
    if (told) report(reports, {Report::Kind::told, writer, n});
  }
}

Task<void> tell_item(Board& board, int writer, std::int64_t n, int reports, std::size_t& answered) {
  Datum item = list("item"_sym, writer, n);
  const Result<Revision> told = co_await board.tell(std::move(item));
  ++answered;
  if (told) report(reports, {Report::Kind::told, writer, n});
}

class Taker {
 public:
  Taker(Executor& executor, Board& board, std::int64_t who, int reports)
      : executor_(executor), board_(board), who_(who), reports_(reports) {}

  Task<void> run() {
    co_await declare(board_);
    while (true) {
      const Result<LeaseId> lease = co_await board_.lease(taker_lease);
      if (!lease) continue;
      bool sure = true;
      while (sure) sure = co_await take_one(*lease);
      // What it may have taken without knowing goes back.
      [[maybe_unused]] const Result<void> released = co_await board_.release(*lease);
    }
  }

 private:
  // Whether it knows what it holds.
  Task<bool> take_one(LeaseId lease) {
    const Result<void> renewed = co_await board_.renew(lease);
    if (!renewed) co_return false;
    Datum item = list("item"_sym, "?writer"_sym, "?n"_sym);
    const Result<std::optional<Fact>> taken = co_await board_.take(std::move(item), lease);
    if (!taken) co_return false;
    if (!*taken) co_await sleep(executor_, look_again_after);
    if (!*taken) co_return true;
    const Datum& fact = (*taken)->datum;
    Transaction transaction;
    transaction.settle((*taken)->id).tell(list("effect"_sym, fact[1], fact[2], who_ * 1'000'000'000 + ++serial_));
    const Result<Revision> made = co_await board_.transact(std::move(transaction));
    if (!made) co_return false;
    report(reports_, {Report::Kind::made, static_cast<std::int32_t>(fact[1].integer()), fact[2].integer()});
    co_return true;
  }

  Executor& executor_;
  Board& board_;
  const std::int64_t who_;
  const int reports_;
  std::int64_t serial_ = 0;
};

// A watch's changes, compared with one another and with the board's answer at the same revision.
class Follower {
 public:
  Follower(Board& board, int who, int reports) : board_(board), who_(who), reports_(reports) {}

  Task<void> follow() {
    co_await declare(board_);
    while (true) {
      Query query = counters();
      const Result<std::unique_ptr<Watch>> watch = co_await board_.watch(std::move(query));
      if (!watch) continue;
      bool more = true;
      while (more) {
        const Result<Change> change = co_await (*watch)->next();
        more = change.has_value();
        if (more) apply(*change);
      }
    }
  }
  Task<void> ask(Executor& executor) {
    while (true) {
      co_await sleep(executor, look_again_after);
      Query query = counters();
      const Result<Answers> answers = co_await board_.ask(std::move(query));
      if (!answers) continue;
      Counters there;
      for (const Answer& answer : answers->answers) add(there, answer);
      if (answers->revision >= revision_) asked_[answers->revision] = std::move(there);
    }
  }

 private:
  using Counters = std::map<std::int64_t, std::int64_t>;

  static Query counters() { return query_for(list("counter"_sym, "?writer"_sym, "?n"_sym)); }
  static bool add(Counters& to, const Answer& answer) {
    const Datum& fact = answer.facts.front().datum;
    return to.emplace(fact[1].integer(), fact[2].integer()).second;
  }

  void apply(const Change& change) {
    bool sound = change.resynchronised || change.revision >= revision_;
    if (change.resynchronised) {
      asked_.clear();
      known_.clear();
    }
    for (const auto& [revision, there] : asked_) {
      if (revision < change.revision && revision >= revision_) sound = sound && there == known_;
    }
    asked_.erase(asked_.begin(), asked_.lower_bound(change.revision));
    for (const Answer& answer : change.removed) {
      const Datum& fact = answer.facts.front().datum;
      const auto known = known_.find(fact[1].integer());
      sound = sound && known != known_.end() && known->second == fact[2].integer();
      if (known != known_.end()) known_.erase(known);
    }
    for (const Answer& answer : change.added) sound = add(known_, answer) && sound;
    revision_ = change.revision;
    if (!sound) report(reports_, {Report::Kind::gap, who_, static_cast<std::int64_t>(change.revision)});
  }

  Board& board_;
  const int who_;
  const int reports_;
  Counters known_;
  Revision revision_ = 0;
  std::map<Revision, Counters> asked_;  // what the board answered, at which revision
};

}  // namespace

void write_items(const std::string& address, int who, int reports) {
  RealExecutor executor;
  const auto board = connect(executor, address, "writer", who);
  std::int64_t next = 0;
  std::vector<Job> jobs;
  for (int i = 0; i < at_once; ++i) jobs.push_back(executor.spawn(tell_on(*board, who, next, reports)));
  executor.run_until([] { return false; });
}

void flood_items(const std::string& address, int who, int reports) {
  RealExecutor executor;
  std::int64_t next = 0;
  while (true) {
    // Another client each time: what it leaves behind is done once or not at all.
    const auto board = connect(executor, address, "flood", who);
    const Job declared = executor.spawn(declare(*board));
    executor.run_until([&] { return declared.done(); });
    std::size_t answered = 0;
    std::vector<Job> jobs;
    for (int i = 0; i < more_than_is_remembered; ++i) {
      jobs.push_back(executor.spawn(tell_item(*board, who, ++next, reports, answered)));
    }
    const Job waited = executor.spawn(pause(executor, longest_flood));
    executor.run_until([&] { return answered >= more_than_is_remembered / 2 || waited.done(); });
    jobs.clear();
    const Job rest = executor.spawn(pause(executor, between_floods));
    executor.run_until([&] { return rest.done(); });
  }
}

void take_items(const std::string& address, int who, int reports) {
  RealExecutor executor;
  const auto board = connect(executor, address, "taker", who);
  std::vector<std::unique_ptr<Taker>> takers;
  std::vector<Job> jobs;
  for (int i = 0; i < at_once; ++i) {
    takers.push_back(std::make_unique<Taker>(executor, *board, who * at_once + i, reports));
    jobs.push_back(executor.spawn(takers.back()->run()));
  }
  executor.run_until([] { return false; });
}

void watch_counters(const std::string& address, int who, int reports) {
  RealExecutor executor;
  const auto board = connect(executor, address, "watcher", who);
  Follower follower(*board, who, reports);
  const Job following = executor.spawn(follower.follow());
  const Job asking = executor.spawn(follower.ask(executor));
  executor.run_until([] { return false; });
}

}  // namespace pizarra::bench
