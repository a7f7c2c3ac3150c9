#pragma once

// The Board: where agents meet. One object is one teller's view of it. It has three walls: in this process
// (MemoryBoard's views), over ZeroMQ (RemoteBoard), and a journal played back; agents cannot tell which.
//
// Lifecycle: a view is made for a teller by name; relations are declared (again is harmless, differently is refused);
// facts are told, asked, watched and taken; the view is destroyed after its last watch.
//
//   auto revision = co_await board.tell(list("on"_sym, "circle"_sym, "triangle"_sym));
//   Result<Answers> towers = co_await board.ask(query);
//   Result<std::unique_ptr<Watch>> watch = co_await board.watch(query);
//   Result<Change> first = co_await (*watch)->next();      // what holds now, then every change, in order
//
// Failures: undeclared-relation (names the nearest), wrong-shape, bad-query, precondition-failed, unknown-lease,
// unreachable, too-large, too-costly, journal-full, not-durable (it stands, but may not last: the subject is what would
// have been answered), and, from a journal played back, read-only.

#include <memory>
#include <variant>

#include "blackboard/query.hpp"
#include "blackboard/relation.hpp"
#include "blackboard/time/task.hpp"

namespace pizarra {

// A transaction's changes, and the conditions under which they are made: all or nothing.
struct Transaction {
  struct Tell {
    Datum fact;
    std::vector<FactId> because = {};
    LeaseId lease = 0;  // the fact goes when this lease lapses
  };
  struct Retract {
    Datum pattern;  // every fact that fits; none is fine
  };
  struct Present {
    Datum pattern;  // some fact must fit
  };
  struct Absent {
    Datum pattern;  // no fact may fit
  };
  // No fact that fits was told, replaced or retracted after `revision`.
  struct Unchanged {
    Datum pattern;
    Revision revision;
  };
  // A taken fact's work is done: it is not put back any more. A precondition too: it must still be held.
  struct Settle {
    FactId taken;
  };
  using Precondition = std::variant<Present, Absent, Unchanged>;
  using Step = std::variant<Tell, Retract, Settle>;

  std::vector<Precondition> preconditions;
  std::vector<Step> steps;  // in this order

  Transaction& tell(Datum fact, std::vector<FactId> because = {}, LeaseId lease = 0) {
    steps.emplace_back(Tell{std::move(fact), std::move(because), lease});
    return *this;
  }
  Transaction& retract(Datum pattern) {
    steps.emplace_back(Retract{std::move(pattern)});
    return *this;
  }
  Transaction& settle(FactId taken) {
    steps.emplace_back(Settle{taken});
    return *this;
  }
  Transaction& require(Precondition precondition) {
    preconditions.push_back(std::move(precondition));
    return *this;
  }
};

// The answers of a watched query that began and ceased to hold at one revision.
struct Change {
  Revision revision = 0;
  // The watcher lagged behind its bound, or the board was away: `added` is all that holds now, `removed` is empty, and
  // whatever it knew before is void. The first change of a watch is one of these.
  bool resynchronised = false;
  std::vector<Answer> added;
  std::vector<Answer> removed;
};

// Destroying it ends the watch.
class Watch {
 public:
  virtual ~Watch() = default;
  // The next change, waiting for it. At most one caller at a time.
  virtual Task<Result<Change>> next() = 0;
};

class Board {
 public:
  virtual ~Board() = default;

  virtual Task<Result<void>> declare(std::vector<Relation> relations) = 0;
  // The revision it committed at; a transaction that changes nothing answers the current one. Telling a fact that
  // stands already, with the same key and value, changes nothing (its lease is set anew).
  virtual Task<Result<Revision>> transact(Transaction transaction) = 0;
  virtual Task<Result<Answers>> ask(Query query) = 0;
  virtual Task<Result<std::unique_ptr<Watch>>> watch(Query query) = 0;
  // Removes one fact that fits (the lowest id) and answers it, or nothing. Until settled it is held under `holder`:
  // when that lease lapses, the board puts the fact back, under a new id, unless another with its key was told
  // meanwhile. With holder 0 it is gone for good.
  virtual Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) = 0;

  // A lease lapses `length` after it was made or last renewed, or when released.
  virtual Task<Result<LeaseId>> lease(Duration length) = 0;
  virtual Task<Result<void>> renew(LeaseId lease) = 0;
  virtual Task<Result<void>> release(LeaseId lease) = 0;

  Task<Result<Revision>> tell(Datum fact, std::vector<FactId> because = {});
  Task<Result<Revision>> retract(Datum pattern);
  // Every fact that fits one pattern.
  Task<Result<std::vector<Fact>>> facts(Datum pattern);
};

class Executor;

// How long a caller waits before it asks a board again that was away.
inline constexpr Duration retry_pause = 200ms;

// For a transaction that need not be durable: `not-durable` counts as done, at the revision that the failure names.
Result<Revision> if_it_stands(Result<Revision> told);

// The first answer of a query that holds now or comes to hold before `deadline`; failure `timeout` otherwise.
Task<Result<Answer>> await_answer(Board& board, Query query, Time deadline, Executor& executor);

}  // namespace pizarra
