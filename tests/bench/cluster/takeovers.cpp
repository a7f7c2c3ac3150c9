#include "tests/bench/cluster/takeovers.hpp"

#include "lisp/reader.hpp"
#include "tests/run_task.hpp"

namespace pizarra::bench {

namespace {

constexpr Duration between_rounds = 1500ms;  // both boards know of each other again

double seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

std::unique_ptr<client::RemoteBoard> client_of(RealExecutor& executor, const ClusterCell& cell, const char* name) {
  return client::RemoteBoard::connect(executor, cell.boards(), name).value();
}

}  // namespace

Takeovers::Takeovers(RealExecutor& executor, ClusterCell& cell)
    : executor_(executor),
      cell_(cell),
      teller_(client_of(executor, cell, "teller")),
      asker_(client_of(executor, cell, "asker")),
      looker_(client_of(executor, cell, "looker")),
      agents_(client_of(executor, cell, "idle")),
      agent_{"idle", "bench", executor, *agents_, Random(1)},
      service_(agent_, runtime::contract_from_text("(contract idle)").value()) {
  const Relation mark =
      relation_from_datum(read_one("(relation mark ((n integer)) (key n) (durable))").value()).value();
  const std::vector<Relation> relations = {mark};
  while (!pizarra::run(executor_, teller_->declare(relations))) continue;
  while (!pizarra::run(executor_, asker_->declare(relations))) continue;
  while (!pizarra::run(executor_, service_.start())) continue;
}

Task<void> Takeovers::until_told(Time begun, double* took) {
  while (*took == 0) {
    const std::int64_t mark = ++told_;
    const Result<Revision> told = co_await teller_->tell(list("mark"_sym, mark));
    if (!told) continue;
    acknowledged_.push_back(mark);
    *took = seconds(executor_.now() - begun);
  }
}

Task<void> Takeovers::until_asked(Time begun, double* took) {
  const Datum first_mark = list("mark"_sym, 1);
  while (*took == 0) {
    const Result<std::vector<Fact>> facts = co_await asker_->facts(first_mark);
    if (facts) *took = seconds(executor_.now() - begun);
  }
}

Task<void> Takeovers::until_present(Time begun, double* took) {
  const Datum idle = list("agent"_sym, "idle"_sym, "?"_sym, "?"_sym);
  while (*took == 0) {
    const Result<std::vector<Fact>> facts = co_await looker_->facts(idle);
    if (facts && !facts->empty()) *took = seconds(executor_.now() - begun);
  }
}

Waits Takeovers::of(const std::function<void()>& kill, int rounds) {
  Waits waits;
  for (int round = 0; round < rounds; ++round) {
    wait_until_whole();
    kill();
    const Time begun = executor_.now();
    double tell = 0;
    double ask = 0;
    double present = 0;
    {
      const Job telling = executor_.spawn(until_told(begun, &tell));
      const Job asking = executor_.spawn(until_asked(begun, &ask));
      const Job looking = executor_.spawn(until_present(begun, &present));
      executor_.run_until([&] { return tell > 0 && ask > 0 && present > 0; });
    }
    waits.tell_s.push_back(tell);
    waits.ask_s.push_back(ask);
    waits.present_s.push_back(present);
  }
  wait_until_whole();
  for (const std::int64_t mark : acknowledged_) {
    Result<std::vector<Fact>> facts = fail("unavailable", "not asked yet");
    while (!facts) facts = pizarra::run(executor_, asker_->facts(list("mark"_sym, mark)));
    if (facts->size() != 1) ++waits.lost;
  }
  return waits;
}

void Takeovers::wait_until_whole() {
  cell_.start_what_was_killed();
  bool rested = false;
  executor_.call_at(executor_.now() + between_rounds, [&] { rested = true; });
  executor_.run_until([&] { return rested; });
  double told = 0;
  const Job telling = executor_.spawn(until_told(executor_.now(), &told));
  executor_.run_until([&] { return told > 0; });
}

}  // namespace pizarra::bench
