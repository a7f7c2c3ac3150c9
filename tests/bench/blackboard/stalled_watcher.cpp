// The cost of one stopped watcher to the others, and to the server's memory: facts of 20 KB are told, and a watcher
// measures how long they take, while another runs, and while it is stopped.

#include <csignal>
#include <fmt/format.h>

#include "lisp/reader.hpp"
#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int tells = 600;  // in a round
constexpr int last = 16;    // the number of a round's last frame
constexpr std::size_t heavy = 20'000;

Relation frame_relation() {
  return relation_from_datum(read_one("(relation frame ((n integer) (sent number) (data string)) (key n))").value())
      .value();
}

Task<void> watch_frames(Board& board, Pipe& parent) {
  const std::vector<Relation> relations = {frame_relation()};
  co_await board.declare(relations);
  Query query = query_from_datum(read_one("(frame ?n ?sent ?data)").value()).value();
  Result<std::unique_ptr<Watch>> watch = co_await board.watch(query);
  if (!watch) throw std::runtime_error(describe(watch.error()));
  co_await (*watch)->next();
  parent.say(0);
  std::vector<double> took_us;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) throw std::runtime_error(describe(change.error()));
    for (const Answer& answer : change->added) {
      const Datum& frame = answer.facts[0].datum;
      took_us.push_back(now_us() - frame[2].number());
      if (frame[1].integer() != last) continue;
      parent.say(percentile(took_us, 0.99));
      took_us.clear();
    }
  }
}

Task<void> tell_frames(Board& board) {
  const Datum data = to_datum(std::string(heavy, 'x'));
  for (int i = 0; i < tells; ++i) {
    Datum fact = list("frame"_sym, i + 1 == tells ? last : i % last, now_us(), data);
    const Result<Revision> told = co_await board.tell(fact);
    if (!told) throw std::runtime_error(describe(told.error()));
  }
}

Child watcher_of(const std::string& address, const std::string& name) {
  Child child = Child::running([&](Pipe& parent) {
    Client client(address, name);
    client.run(watch_frames(client.board(), parent));
  });
  child.pipe().hear();
  return child;
}

}  // namespace

void stalled_watcher(Figures& figures) {
  const BoardProcess server;
  Child steady = watcher_of(server.address(), "steady");
  Child stalled = watcher_of(server.address(), "stalled");
  Client teller(server.address(), "teller");
  double before_mb = 0;
  double stalled_mb = 0;
  const auto round_beside = [&](int signal) {
    stalled.signal(signal);
    teller.run(tell_frames(teller.board()));
    const double p99 = steady.pipe().hear();
    if (signal == SIGSTOP) stalled_mb = std::max(stalled_mb, server.process().memory_mb("VmRSS"));
    if (before_mb == 0) before_mb = server.process().memory_mb("VmRSS");
    return p99;
  };
  const std::vector<double> us =
      medians_of_rounds(rounds, {[&] { return round_beside(SIGCONT); }, [&] { return round_beside(SIGSTOP); }});
  figures.say({"tell to watcher, p99, another stalled",
               us[1],
               "us",
               at_most(1.2 * us[0], "<= 1.2 x with it running"),
               {{"running", us[0]}}});
  figures.say({"server's memory for a stalled watcher", stalled_mb - before_mb, "MB", at_most(20)});
}

}  // namespace pizarra::bench
