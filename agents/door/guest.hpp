#pragma once

// One device at the door: it says forms, one a line, and each of them is answered by one line, in their order.
//
//   (hello NAME "TOKEN")              (welcome NAME): its session begins, or begins anew
//   (declare RELATION ...)            (ok)
//   (tell FACT ...)                   (ok REVISION); all of them or none
//   (tell-leased FACT ...)            the same, and they go when the session's lease lapses
//
//   (retract PATTERN ...)             (ok REVISION)
//   (ask QUERY)                       (ok ANSWER ...)
//   (watch N QUERY), (unwatch N)      (ok)
//
//   (lease MS)                        (ok new), or (ok kept) where it renewed the one that there is
//   (release)                         (ok); what was told under the lease goes
//
// A refused request is answered by (fail SYMBOL "SENTENCE"). A line that is not understood is answered by (closed
// SYMBOL "SENTENCE"), and ends the session. An ANSWER of a query with one pattern is a fact, of any other a list of
// facts. The changes of watch N come between the answers, an answer a line:
//
//   (anew N)                          all that was said of it is void: first of all, and where the board lost us
//   (went N ANSWER), (came N ANSWER)
//   (now N REVISION)                  that was one change, whole
//   (lost N SYMBOL "SENTENCE")        the watch has ended
//
// A lease outlives the session: whoever comes back in time and tells the same facts again changes nothing for others.

#include <functional>
#include <map>
#include <memory>
#include <span>

#include "agents/door/lines.hpp"
#include "agents/door/pass.hpp"
#include "blackboard/board.hpp"

namespace pizarra::door {

// `(closed SYMBOL "SENTENCE")`, `(fail ...)`.
std::string failure_line(std::string_view word, const Failure& failure);

class Guest {
 public:
  static constexpr std::size_t most_watches = 8;
  static constexpr Duration longest_lease = std::chrono::hours(1);

  struct Admitted {
    Pass pass;
    std::unique_ptr<Board> board;
  };
  // Failure not-permitted and others that end the session.
  using Admit = std::function<Result<Admitted>(const std::string& name, const std::string& token)>;

  // The lines outlive it.
  Guest(Executor& executor, Lines& lines, Admit admit) : executor_(executor), lines_(lines), admit_(std::move(admit)) {}

  // Until the line or the session ends, which is said. A session must begin before `deadline`.
  Task<void> run(std::optional<Time> deadline);

 private:
  struct Verb;
  using Number = std::int64_t;

  Task<Result<void>> converse(std::optional<Time> deadline);
  Result<void> greet(const Datum& hello);
  Task<Result<void>> answer(const Verb& verb, const Datum& form);
  Task<Result<Datum>> declare(const Datum& form);
  Task<Result<Datum>> tell(const Datum& form);
  Task<Result<Datum>> tell_leased(const Datum& form);
  Task<Result<Datum>> tell_under(const Datum& form, LeaseId lease);
  Task<Result<Datum>> retract(const Datum& form);
  Task<Result<Datum>> ask(const Datum& form);
  Task<Result<Datum>> watch(const Datum& form);
  Task<Result<Datum>> unwatch(const Datum& form);
  Task<Result<Datum>> lease(const Datum& form);
  Task<Result<Datum>> release(const Datum& form);
  Task<void> say_changes(Number number);
  Task<bool> say_answers(std::string_view word, Number number, const std::vector<Answer>& answers);
  Task<bool> say_in_turn(std::string line);

  struct Watched {
    Query query;
    std::unique_ptr<Watch> watch;
    Job saying;
  };

  Executor& executor_;
  Lines& lines_;
  Admit admit_;
  std::optional<Admitted> session_;
  LeaseId lease_ = 0;
  Duration lease_length_{};
  std::map<Number, Watched> watches_;
};

}  // namespace pizarra::door
