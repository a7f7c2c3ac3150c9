// A million durable facts, told, and the board killed: until it is there again and answers.

#include <csignal>
#include <fmt/format.h>

#include "tests/bench/blackboard/kept_facts.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int facts = 1'000'000;
constexpr int batch = 500;
constexpr int in_flight = 8;

Transaction batch_of_facts(int number) {
  Transaction transaction;
  for (int i = number * batch; i < (number + 1) * batch; ++i) transaction.tell(kept_fact(i, i));
  return transaction;
}

}  // namespace

void recovery(Figures& figures) {
  const JournalFolder folder;
  {
    const BoardProcess server(folder.board_options());
    Client teller(server.address(), "teller");
    const std::vector<Relation> relations = {kept_relation()};
    teller.run(teller.board().declare(relations));
    tell_all(teller, facts / batch, in_flight, batch_of_facts);
    server.process().signal(SIGKILL);
  }
  const double megabytes = folder.megabytes();
  const double seconds = seconds_of([&] {
    const BoardProcess server(folder.board_options());
    Client asker(server.address(), "asker");
    const Query last = query_for(kept_fact(facts - 1, facts - 1));
    if (asker.run(asker.board().ask(last)).answers.size() != 1) throw std::runtime_error("a fact was lost");
  });
  figures.say(
      {"recovery of 1,000,000 durable facts", seconds, "s", at_most(5), {}, fmt::format("{:.0f} MB", megabytes)});
}

}  // namespace pizarra::bench
