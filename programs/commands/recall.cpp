#include "programs/commands/recall.hpp"

#include <fmt/format.h>

#include "agents/repl/answer_text.hpp"
#include "blackboard/client/keyed_board.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra::programs {

namespace {

using Recalled = client::RemoteBoard::Recalled;

Task<void> recall(client::RemoteBoard& board, Query query, Result<Recalled>* recalled) {
  *recalled = co_await board.recall(std::move(query));
}

double seconds_of(Duration age) { return std::chrono::duration<double>(age).count(); }

void print(const Recalled& recalled, repl::Style style) {
  const auto& [answers, age, settled] = recalled;
  if (style == repl::Style::json) {
    fmt::print("{{\"revision\":{},\"age\":{:.3f},\"settled\":{},\"answers\":{}}}\n", answers.revision, seconds_of(age),
               settled, repl::json_answers(answers.answers));
    return;
  }
  for (const Answer& answer : answers.answers) fmt::print("{}\n", lines_of_bytes(repl::bindings_text(answer)));
  if (answers.answers.empty()) fmt::print("no\n");
  if (age == Duration::zero()) return;
  fmt::print("as of {:.1f} s ago: no quorum{}\n", seconds_of(age), settled ? "" : "; some of it may be undone");
}

}  // namespace

int print_recalled(const Destination& to, const Query& query, repl::Style style) {
  RealExecutor executor;
  const auto board = client::keyed_board(executor, to.address, to.key, prompt_name());
  if (!board) return complain_as(style, board.error(), exit_usage);
  Result<Recalled> recalled = fail("unreachable", "the board does not answer");
  const Job asking = executor.spawn(recall(**board, query, &recalled));
  executor.run_until([&] { return asking.done(); });
  if (!recalled) return complain_of_board(style, recalled.error());
  print(*recalled, style);
  return exit_reached;
}

}  // namespace pizarra::programs
