#pragma once

// What a page asks of agents: operations, and goals, which are answered twice: accepted, and then how they ended.
//
//   AgentRequests agents(board, voice, requests);
//   agents.request(form);                   // (request N AGENT OPERATION)
//   agents.goal(form);                      // (goal N "TEXT")
//
// What it is given outlives it.

#include "agents/console/numbered_requests.hpp"
#include "agents/console/page_board.hpp"

namespace pizarra::console {

class AgentRequests {
 public:
  AgentRequests(PageBoard& board, PageVoice& voice, NumberedRequests& requests)
      : board_(board), voice_(voice), requests_(requests) {}

  void request(const Datum& form);
  void goal(const Datum& form);

 private:
  Task<void> ask(std::int64_t number, std::string agent, Datum operation);
  Task<void> pursue(std::int64_t number, std::string text);
  Task<void> say_end_of_goal(std::int64_t number, Datum goal, std::string text);
  Task<bool> being_taught();

  PageBoard& board_;
  PageVoice& voice_;
  NumberedRequests& requests_;
};

}  // namespace pizarra::console
