#pragma once

// Who has an arm in hand: one operator at a time, (commander ROBOT CLIENT). Others ask for it, (commander-wanted ROBOT
// CLIENT), or take it over. All of it goes with the page's presence. The board holds the rules, as preconditions.
//
//   ArmClaims claims(board, requests);
//   co_await claims.declare();              // before anybody follows who wants an arm
//   claims.command(form);                   // (command N ROBOT), and so on: see session.hpp
//
// What it is given outlives it.

#include "agents/console/numbered_requests.hpp"
#include "agents/console/page_board.hpp"

namespace pizarra::console {

class ArmClaims {
 public:
  ArmClaims(PageBoard& board, NumberedRequests& requests) : board_(board), requests_(requests) {}

  // A page that may not tell these facts is refused when it does.
  Task<void> declare();

  void command(const Datum& form);
  void take_over(const Datum& form);
  void let_go(const Datum& form);
  void ask_for(const Datum& form);
  void ask_no_more(const Datum& form);
  // Takes every stop back. Only who has an arm in hand may set arms free.
  void clear_stops(const Datum& form);

 private:
  void change_board(const Datum& form, Transaction transaction, Failure unmet = {});

  PageBoard& board_;
  NumberedRequests& requests_;
};

}  // namespace pizarra::console
