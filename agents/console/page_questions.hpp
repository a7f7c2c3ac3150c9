#pragma once

// What a page asks the board: queries that it follows or watches (`max_watches`), those that it asks once, and those of
// the past. It is told never more than it takes in: changes that it does not take wait on the board. When too many do,
// the board tells the page anew all that holds.
//
//   PageQuestions questions(board, voice, requests, arms);
//   questions.follow(form);                 // (follow N QUERY), and so on: see session.hpp
//
// Destroying it ends the watches. What it is given outlives it.

#include <map>

#include "agents/console/numbered_requests.hpp"
#include "agents/console/page_arms.hpp"
#include "agents/console/page_board.hpp"

namespace pizarra::console {

class PageQuestions {
 public:
  static constexpr std::size_t max_watches = 64;

  PageQuestions(PageBoard& board, PageVoice& voice, NumberedRequests& requests, PageArms& arms)
      : board_(board), voice_(voice), requests_(requests), arms_(arms) {}

  void follow(const Datum& form);
  void watch(const Datum& form);
  void unwatch(const Datum& form);
  void ask(const Datum& form);
  void then(const Datum& form);

 private:
  void add_watch(std::int64_t number, Query query, bool when_declared);
  Task<void> start_watch(std::int64_t number, Query query, bool when_declared);
  Task<void> send_changes(std::int64_t number, std::unique_ptr<Watch> watch);
  Task<void> ask_now(std::int64_t number, Query query);
  Task<void> ask_then(std::int64_t number, Query query);

  PageBoard& board_;
  PageVoice& voice_;
  NumberedRequests& requests_;
  PageArms& arms_;
  std::map<std::int64_t, Job> watches_;
};

}  // namespace pizarra::console
