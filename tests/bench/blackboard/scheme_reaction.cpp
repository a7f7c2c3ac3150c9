// From telling a fact until the fact that a Scheme agent's rule tells of it is there: teller, board and agent each a
// process.

#include <fmt/format.h>
#include <fstream>

#include "lisp/reader.hpp"
#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int told = 1000;

constexpr const char* rule = R"((posts (relation ping ((n integer)) (key)) (relation pong ((n integer)) (key)))
(rule answer (ping ?n) (tell (pong ?n))))";

Task<Result<void>> react(Board& board, std::vector<double>& took_us) {
  const Query pongs = query_for(list("pong"_sym, "?n"_sym));
  const Result<std::unique_ptr<Watch>> watch = co_await board.watch(pongs);
  if (!watch) co_return fail(watch);
  const Result<Change> nothing = co_await (*watch)->next();
  if (!nothing) co_return fail(nothing);
  for (int i = 0; i < told; ++i) {
    const double begun = now_us();
    const Datum ping = list("ping"_sym, i);
    const Result<Revision> sent = co_await board.tell(ping);
    if (!sent) co_return fail(sent);
    const Result<Change> pong = co_await (*watch)->next();
    if (!pong) co_return fail(pong);
    took_us.push_back(now_us() - begun);
  }
  co_return {};
}

}  // namespace

void scheme_reaction(Figures& figures) {
  const BoardProcess board;
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/answer.scm";
  std::ofstream(file) << rule;
  // Facts are told at the pace of their answers, faster than an agent may by default.
  const Child agent = Child::program(
      {program_beside("pizarra-scheme"), "scheme", file, "--board", board.address(), "--rate", "100000"});
  Client client(board.address(), "teller");
  std::vector<Relation> relations;
  for (const char* form : {"(relation rule ((agent symbol) (name symbol) (condition string)) (key agent name))",
                           "(relation ping ((n integer)) (key))", "(relation pong ((n integer)) (key))"}) {
    relations.push_back(relation_from_datum(read_one(form).value()).value());
  }
  client.run(client.board().declare(relations));
  const Query loaded = query_for(list("rule"_sym, "answer"_sym, "?"_sym, "?"_sym));
  client.run(await_answer(client.board(), loaded, client.executor().now() + 20s, client.executor()));
  std::vector<double> took_us;
  client.run(react(client.board(), took_us));
  figures.say({"a rule's reaction, median", percentile(took_us, 0.5), "us", {}});
  figures.say({"a rule's reaction, 99 %", percentile(took_us, 0.99), "us", {}});
}

}  // namespace pizarra::bench
