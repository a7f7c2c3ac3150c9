#pragma once

// A page's own session with the board, under a name of its own: the page may do what that name may. Facts that the page
// tells under its presence go when the page does.
//
//   PageBoard board(executor, "console-3", std::move(session));
//   const Result<void> present = co_await board.start();
//   const Result<Datum> answer = co_await board.call("robot", operation);
//   co_await board.leave();                                                 // the name is free at once

#include <memory>
#include <string>

#include "agents/runtime/caller.hpp"

namespace pizarra::console {

class PageBoard {
 public:
  PageBoard(Executor& executor, std::string name, std::unique_ptr<Board> board);

  Task<Result<void>> start();
  // Its presence, and what stands under it, goes at once; where the board is away, its lease lapses.
  Task<void> leave();
  // What an agent answers. Failures: absent, timeout, and those of the agent.
  Task<Result<Datum>> call(std::string agent, Datum operation);

  Executor& executor() { return context_.executor; }
  Board& facts() { return *board_; }
  runtime::AgentContext& context() { return context_; }
  LeaseId presence() const { return service_.presence(); }
  const std::string& name() const { return context_.name; }
  // As it stands in facts.
  Datum client() const { return Datum::symbol(context_.name); }

 private:
  const std::unique_ptr<Board> board_;
  runtime::AgentContext context_;
  runtime::Service service_;
  runtime::Caller caller_;
};

}  // namespace pizarra::console
