// An agent of one's own: it counts how often a barrier was blocked, tells the count, and may be asked for it.
//
//   counter ipc:///tmp/b        on the board that listens there, until Ctrl-C

#include <cstdio>

#include "agents/runtime/follow.hpp"
#include "agents/runtime/program.hpp"
#include "agents/runtime/service.hpp"

using namespace pizarra;

// What it offers, posts and reads: others find it on the board as (contract counter ...).
constexpr const char* contract = R"((contract counter
  (offers (count))
  (posts (relation passed ((count integer)) (key)))
  (reads (relation barrier ((name symbol) (state symbol)) (key name)))))";

class Counter : public runtime::Agent {
 public:
  explicit Counter(runtime::AgentContext context)
      : context_(std::move(context)), service_(context_, runtime::contract_from_text(contract).value()) {}

  Task<Result<void>> run() override {
    const Result<void> started = co_await service_.start();
    if (!started) co_return started;
    const Datum blocked = list("barrier"_sym, "?name"_sym, "blocked"_sym);
    const auto counted = [this](Change change) { return count(std::move(change)); };
    const Job counting = context_.executor.spawn(runtime::follow(context_, blocked, counted));
    runtime::Handler answer = [this](Datum) { return tell_count(); };
    co_return co_await service_.serve(std::move(answer));
  }

 private:
  Task<Result<Datum>> tell_count() { co_return list(count_); }

  Task<void> count(Change change) {
    for (const Answer& answer : change.added) {
      Transaction telling;
      telling.tell(list("passed"_sym, ++count_), {answer.facts.front().id}, service_.presence());
      const Result<Revision> told = co_await context_.board.transact(std::move(telling));
      if (!told) std::fprintf(stderr, "%s\n", describe(told.error()).c_str());
    }
  }

  runtime::AgentContext context_;
  runtime::Service service_;
  int count_ = 0;
};

int main(int argc, char** argv) { return runtime::agent_main<Counter>("counter", argc, argv); }
