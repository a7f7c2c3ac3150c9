#pragma once

// Answers what was, from a board's journal, while the board goes on: one question after another, each from a board of
// its own that is played back to the moment asked about. The clients that wait are served in turn, a question each.
//
//   Past past(executor, writer, [&] { return board.store().revision(); });
//   past.ask("alice", query, [&](const Result<Answers>& answers) { ... });       // a query with `at`
//
// Failures: too-many when too many questions wait, the client's or all; forgotten, not-yet, gap (it asks about what is
// not durable, and that moment's journal is not there), and those of reading a journal.

#include <deque>
#include <functional>

#include "blackboard/journal/journal_writer.hpp"

namespace pizarra::journal {

// Where the log that was read into that store lacks what the query asks about, the failure says so.
Result<void> check_has(const std::optional<Failure>& lacks, const store::Store& store, const Query& query);

class Past {
 public:
  using Done = std::function<void(const Result<Answers>&)>;
  static constexpr std::size_t max_waiting = 64;
  static constexpr std::size_t max_waiting_of_a_client = 8;

  // `newest` says at which revision the board stands.
  Past(Executor& executor, JournalWriter& journal, std::function<Revision()> newest);
  void ask(const std::string& client, Query query, Done done);

 private:
  struct Question {
    Query query;
    Done done;
  };
  struct Client {
    std::string name;
    std::deque<Question> waiting = {};
  };
  void end_turn();
  Task<void> answer_all();
  Task<Result<Answers>> answer(Query query);

  Executor& executor_;
  JournalWriter& journal_;
  const std::function<Revision()> newest_;
  std::deque<Client> clients_;  // whose turn it is first; each has a question that waits
  std::size_t waiting_ = 0;     // of all of them
  Event asked_;
  Job job_;
};

}  // namespace pizarra::journal
