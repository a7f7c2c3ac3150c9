// Clients that read registers and compare them with what they read before they put another value there, and clients
// that take tokens for good.

#include <chrono>

#include "blackboard/time/random.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/bench/crash/client_tools.hpp"

namespace pizarra::bench {

namespace {

constexpr int comparers_at_once = 3;
constexpr int registers_at_once = 2;
constexpr auto register_lasts = std::chrono::seconds(4);
// The others are to come to their turn too.
constexpr Duration token_pause = 20ms;
constexpr Duration register_pause = 10ms;

// The same for all processes of this machine.
std::int64_t nanoseconds() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

class Comparer {
 public:
  Comparer(Executor& executor, Board& board, std::int64_t who, int reports, std::int64_t& serial, std::uint64_t seed)
      : executor_(executor), board_(board), who_(who), reports_(reports), serial_(serial), random_(seed) {}

  Task<void> run() {
    co_await declare(board_);
    while (true) {
      const std::int64_t era = std::chrono::nanoseconds(nanoseconds()) / register_lasts % 1'000'000;
      key_ = era * registers_at_once + static_cast<std::int64_t>(random_.below(registers_at_once));
      const bool known = co_await read();
      if (known) co_await put();
      co_await sleep(executor_, register_pause);
    }
  }

 private:
  Task<bool> read() {
    Operation read{.called = nanoseconds()};
    Query query = query_for(list("register"_sym, key_, "?value"_sym));
    const Result<Answers> answers = co_await board_.ask(std::move(query));
    if (!answers) co_return false;
    read.answered = nanoseconds();
    revision_ = answers->revision;
    value_ = answers->answers.empty() ? 0 : answers->answers.front().facts.front().datum[2].integer();
    read.value = value_;
    report(reports_, {Report::Kind::answered, static_cast<std::int32_t>(key_), next(), read});
    co_return true;
  }

  // By the value, or by that nothing has come since it was read.
  Task<void> put() {
    const std::int64_t n = next();
    const bool by_value = random_.below(2) == 0;
    Operation put{Operation::Kind::compare, Operation::Outcome::unknown, value_, n, nanoseconds(), Operation::never};
    Transaction transaction;
    transaction.preconditions.push_back(condition(by_value));
    transaction.tell(list("register"_sym, key_, n));
    report(reports_, {Report::Kind::called, static_cast<std::int32_t>(key_), n, put});
    const Result<Revision> told = co_await board_.transact(std::move(transaction));
    put.answered = nanoseconds();
    const bool refused = !told && told.error().symbol == "precondition-failed";
    if (!told && !refused) co_return;
    put.outcome = refused ? Operation::Outcome::refused : Operation::Outcome::done;
    // One that compares revisions may be refused by a board that cannot know.
    if (refused && !by_value) put.expected = Operation::nothing;
    report(reports_, {Report::Kind::answered, static_cast<std::int32_t>(key_), n, put});
  }

  Transaction::Precondition condition(bool by_value) const {
    Datum any = list("register"_sym, key_, "?"_sym);
    if (!by_value) return Transaction::Unchanged{std::move(any), revision_};
    if (value_ == 0) return Transaction::Absent{std::move(any)};
    return Transaction::Present{list("register"_sym, key_, value_)};
  }

  std::int64_t next() { return who_ * 1'000'000'000 + ++serial_; }

  Executor& executor_;
  Board& board_;
  const std::int64_t who_;
  const int reports_;
  std::int64_t& serial_;
  Random random_;
  std::int64_t key_ = 0;
  std::int64_t value_ = 0;
  Revision revision_ = 0;
};

// As many tokens as are told are taken.
Task<void> take_tokens(Executor& executor, Board& board, std::int64_t who, int reports) {
  co_await declare(board);
  for (std::int64_t n = 1;; ++n) {
    Datum token = list("token"_sym, who, n);
    (void)co_await board.tell(std::move(token));
    Datum any = list("token"_sym, "?who"_sym, "?n"_sym);
    const Result<std::optional<Fact>> taken = co_await board.take(std::move(any), 0);
    const Datum* got = taken && *taken ? &(*taken)->datum : nullptr;
    if (got != nullptr) {
      report(reports, {Report::Kind::got, static_cast<std::int32_t>((*got)[1].integer()), (*got)[2].integer()});
    }
    co_await sleep(executor, token_pause);
  }
}

}  // namespace

void compare_registers(const std::string& address, int who, int reports) {
  RealExecutor executor;
  const auto board = connect(executor, address, "comparer", who);
  std::int64_t serial = 0;
  std::vector<std::unique_ptr<Comparer>> comparers;
  std::vector<Job> jobs;
  for (int i = 0; i < comparers_at_once; ++i) {
    const auto seed = static_cast<std::uint64_t>(who * comparers_at_once + i);
    comparers.push_back(std::make_unique<Comparer>(executor, *board, who, reports, serial, seed));
    jobs.push_back(executor.spawn(comparers.back()->run()));
  }
  jobs.push_back(executor.spawn(take_tokens(executor, *board, who, reports)));
  executor.run_until([] { return false; });
}

}  // namespace pizarra::bench
