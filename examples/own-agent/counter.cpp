// An agent of one's own: it counts how often a barrier was blocked, tells the count, and may be asked for it.
//
//   counter ipc:///tmp/b        on the board that listens there, until Ctrl-C

#include <cstdio>

#include "agents/runtime/service.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"

using namespace pizarra;

// What it offers, posts and reads: others find it on the board as (contract counter ...).
constexpr const char* contract = R"((contract counter
  (offers (count))
  (posts (relation barrier ((name symbol) (state symbol)) (key name))
         (relation passed ((count integer)) (key)))
  (reads barrier)))";

class Counter : public runtime::Agent {
 public:
  explicit Counter(runtime::AgentContext context)
      : context_(std::move(context)), service_(context_, runtime::contract_from_text(contract).value()) {}

  Task<Result<void>> run() override {
    const Result<void> started = co_await service_.start();
    if (!started) co_return started;
    const Job counting = context_.executor.spawn(count_blocked());
    runtime::Handler answer = [this](Datum) { return tell_count(); };
    co_return co_await service_.serve(std::move(answer));
  }

 private:
  Task<Result<Datum>> tell_count() { co_return list(count_); }

  Task<void> count_blocked() {
    const Query blocked = query_for(list("barrier"_sym, "?name"_sym, "blocked"_sym));
    const Result<std::unique_ptr<Watch>> watch = co_await context_.board.watch(blocked);
    while (watch) {
      const Result<Change> change = co_await (*watch)->next();
      if (!change) co_return;
      for (const Answer& answer : change->added) {
        Transaction telling;
        telling.tell(list("passed"_sym, ++count_), {answer.facts.front().id}, service_.presence());
        const Result<Revision> told = co_await context_.board.transact(std::move(telling));
        if (!told) std::fprintf(stderr, "%s\n", describe(told.error()).c_str());
      }
    }
  }

  runtime::AgentContext context_;
  runtime::Service service_;
  int count_ = 0;
};

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: %s BOARD-ADDRESS\n", argv[0]), 2;
  RealExecutor executor;
  const StopSignals signals(executor);
  const auto board = client::RemoteBoard::connect(executor, argv[1], "counter");
  if (!board) return std::fprintf(stderr, "%s\n", describe(board.error()).c_str()), 4;
  Counter agent({"counter", "localhost", executor, **board, Random(1)});
  std::optional<Result<void>> ended;
  const Job job = executor.spawn([](Counter& running, std::optional<Result<void>>& end) -> Task<void> {
    end = co_await running.run();
  }(agent, ended));
  executor.run_until([&ended] { return ended.has_value(); });
  if (!ended || *ended) return 0;
  return std::fprintf(stderr, "%s\n", describe(ended->error()).c_str()), 1;
}
