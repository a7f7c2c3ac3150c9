#pragma once

// Answers what was, from a board's journal, while the board goes on: one question after another, each from a board of
// its own that is played back to the moment asked about.
//
//   Past past(executor, writer);
//   past.ask(query, [&](const Result<Answers>& answers) { ... });       // a query with `at`
//
// Failures: too-large when too many questions wait, forgotten, not-yet, and those of reading a journal.

#include <deque>
#include <functional>

#include "blackboard/journal/journal_writer.hpp"

namespace pizarra {

class Past {
 public:
  using Done = std::function<void(const Result<Answers>&)>;
  static constexpr std::size_t max_waiting = 64;

  Past(Executor& executor, JournalWriter& journal);
  void ask(Query query, Done done);

 private:
  struct Question {
    Query query;
    Done done;
  };
  Task<void> answer_all();
  Task<Result<Answers>> answer(Query query);

  Executor& executor_;
  JournalWriter& journal_;
  std::deque<Question> waiting_;
  Event asked_;
  Job job_;
};

}  // namespace pizarra
