#pragma once

// An agent that is a Scheme file: loaded into a module of its own in the embedded Guile, with no files, network,
// processes or other modules at hand, and bounded in time and memory. docs/scheme-agents.md has the language.
//
//   Result<std::unique_ptr<AgentProgram>> program = AgentProgram::load("conveyor", text, "conveyor.scm", {});
//   ProgramOutcome outcome = (*program)->run("stop-belt", bindings, now);
//   while (outcome.question) outcome = (*program)->resume(outcome.waiting, answer_to(*outcome.question), now);
//
// Lifecycle: load() evaluates the file; what it wants told at once is in effects(). run() begins one of its parts,
// which runs to its end or to the next question for the board; a run that asks is kept until it is resumed or
// abandoned. Destroying the program forgets all of it. As all calls of Guile, from one thread (lisp/guile/scheme.hpp).
//
// Failures of load(): bad-program (file:line and what is wrong), too-slow, too-much-memory. A run's failures:
// scheme-error, too-slow, too-much-memory, too-much-kept (what it keeps from run to run), too-many, and what the
// program raised by (fail SYMBOL SENTENCE).

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::forms {

struct ProgramLimits {
  std::chrono::milliseconds time{1000};  // of loading, and of each run until it asks the board or ends
  int memory_mb = 64;                    // allocated by one run; and kept from run to run
  // The process is this program's alone: it is killed where a procedure of the interpreter's own, such as a power with
  // millions of digits, cannot be interrupted for four times as long.
  bool own_process = false;
};

struct ProgramPart {
  enum class Sort : std::uint8_t { rule, conclusion, loop, operation };
  Sort sort;
  std::string name;
  Datum head;                          // a rule's condition, or the operation as a contract offers it
  std::vector<std::string> variables;  // that the condition binds
  std::chrono::milliseconds period{0};
};

struct ProgramEffects {
  std::vector<Datum> steps;       // (tell FACT) or (retract PATTERN)
  std::vector<std::string> said;  // lines for its log
};

struct ProgramOutcome {
  Result<ProgramEffects> effects;
  Datum value;                    // of an operation that has ended: what it answers
  std::optional<Datum> question;  // (ask QUERY (VARIABLE ...)), (call AGENT OPERATION MS) or (pause MS)
  std::int64_t waiting = 0;       // whom resume() goes on with
};

class AgentProgram {
 public:
  static Result<std::unique_ptr<AgentProgram>> load(const std::string& agent, const std::string& text,
                                                    const std::string& file, const ProgramLimits& limits);
  AgentProgram(const AgentProgram&) = delete;
  AgentProgram& operator=(const AgentProgram&) = delete;
  ~AgentProgram();

  const std::string& kind() const { return kind_; }
  const std::vector<Datum>& posts() const { return posts_; }
  const std::vector<Datum>& reads() const { return reads_; }  // the relations that it declares without telling them
  const std::vector<ProgramPart>& parts() const { return parts_; }
  const ProgramEffects& effects() const { return effects_; }

  // `bindings`: ((VARIABLE VALUE) ...) of a rule, ((ARGUMENT VALUE) ...) of an operation, in its order.
  ProgramOutcome run(const std::string& part, Datum bindings, std::int64_t now_ms) const;
  // `answer`: (ok VALUE) or (fail SYMBOL "sentence").
  ProgramOutcome resume(std::int64_t waiting, Datum answer, std::int64_t now_ms) const;
  void abandon(std::int64_t waiting) const;

 private:
  AgentProgram(const Datum& loaded, const ProgramLimits& limits);
  ProgramOutcome outcome_of(const char* procedure, const std::vector<Datum>& arguments) const;

  ProgramLimits limits_;
  std::int64_t id_;
  std::string kind_;
  std::vector<Datum> posts_;
  std::vector<Datum> reads_;
  std::vector<ProgramPart> parts_;
  ProgramEffects effects_;
};

}  // namespace pizarra::forms
