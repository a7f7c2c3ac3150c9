#pragma once

// The console as a client of roles: which robot, eyes and coordinator its pages speak with. All pages are one client,
// `console`, so that `(wire console eyes vision-2)` has every page look at those.
//
//   Wiring wiring(executor, std::move(board));    // a session with the board of its own
//
// It tells (holder console ROLE SERVER STATE), and (console-address console ADDRESS) where there is one, under a
// presence of its own, for as long as it lives. Of several consoles on one board the first does. Where its key does not
// let it, the usual agents serve.

#include <memory>
#include <string>

#include "agents/runtime/roles.hpp"

namespace pizarra::console {

class Wiring {
 public:
  static constexpr const char* client = "console";

  // `address`: of a console that other machines reach; empty: of none.
  Wiring(Executor& executor, std::unique_ptr<Board> board, std::string address);
  // Frees the name at once.
  Task<void> leave();

 private:
  Task<void> tell(std::string address);

  std::unique_ptr<Board> board_;
  runtime::AgentContext context_;
  runtime::Service service_;
  runtime::Roles roles_;
  Job telling_;
};

}  // namespace pizarra::console
