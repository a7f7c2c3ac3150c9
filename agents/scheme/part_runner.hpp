#pragma once

// Runs the parts of a loaded program, its rules, loops and operations, each run from its beginning to its end.
// A run's facts go to the board as one transaction, with what made the run happen as their reason, and its questions
// are answered from there.
//
//   auto runner = std::make_shared<PartRunner>(context, caller, program, lease, allowance, log);
//   Result<Performed> performed = co_await PartRunner::perform(runner, "stop-belt", bindings, {fact.id});
//
// A program's facts stand under the runner's lease, unless the relation is one of its own and durable. A run that
// breaks a limit switches its part off for as long as the runner lives.

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "agents/runtime/caller.hpp"
#include "lisp/forms/agent_program.hpp"

namespace pizarra::scheme {

using Log = std::function<void(const std::string&)>;

struct Performed {
  Datum value;              // of an operation
  std::vector<Datum> told;  // facts
};

// How many messages a second somebody may send: at once as many as a second allows, then no faster.
class Allowance {
 public:
  explicit Allowance(double per_second) : each_us_(1e6 / per_second) {}

  // Takes so many, and answers how long to wait before they are sent.
  Duration take(std::size_t messages, Time now) {
    const Duration cost(static_cast<Duration::rep>(each_us_ * static_cast<double>(messages)));
    spent_until_ = std::max(spent_until_, now) + cost;
    return std::max(Duration(0), spent_until_ - now - Duration(std::chrono::seconds(1)));
  }

 private:
  double each_us_;
  Time spent_until_{};
};

class PartRunner {
 public:
  PartRunner(runtime::AgentContext& context, runtime::Caller& caller,
             std::shared_ptr<const forms::AgentProgram> program, LeaseId lease, Allowance& allowance, Log log);

  // Runs a part to its end. It may outlive the running program: the runner then stays until it has ended. Failures:
  // those of the program, `off`, and those of the board that do not pass; each is told as a program-fault, unless the
  // program raised it by itself to answer an operation.
  static Task<Result<Performed>> perform(std::shared_ptr<PartRunner> runner, std::string part, Datum bindings,
                                         std::vector<FactId> because);
  // Tells the facts that the file wants told once it is loaded, and its rules.
  Task<Result<void>> introduce();

  // Retracts the program-fault of a part that works now.
  Task<void> take_back_fault(std::string part);
  // Facts that a conclusion holds: each stands while somebody holds it.
  void hold(const std::vector<Datum>& facts);
  Task<Result<void>> let_go(std::vector<Datum> facts);

  const forms::AgentProgram* program() const { return program_.get(); }
  // The fact that shows the rule; 0 before it was introduced.
  FactId rule_fact(const std::string& rule) const;
  // The program keeps more than it may, and cannot go on.
  const std::optional<Failure>& broken() const { return broken_; }

 private:
  static Task<Result<Performed>> carry_through(std::shared_ptr<PartRunner> runner, std::string part, Datum bindings,
                                               std::vector<FactId> because);
  Task<Result<void>> carry_out(forms::ProgramEffects effects, std::vector<FactId> because);
  Task<Datum> answer_to(Datum question);
  Task<Result<Datum>> find_answers(Datum question);
  Task<Result<Datum>> ask_agent(Datum question);
  Task<Result<Revision>> commit(Transaction transaction);
  Task<void> tell_fault(std::string part, Failure failure);
  LeaseId lease_of(const Datum& fact) const;
  std::int64_t now_ms() const;

  runtime::AgentContext& context_;
  runtime::Caller& caller_;
  std::shared_ptr<const forms::AgentProgram> program_;
  LeaseId lease_;
  Allowance& allowance_;
  Log log_;
  std::set<std::string, std::less<>> durable_;
  std::set<std::string> off_;
  std::map<std::string, std::string> faults_;  // by part, as told last
  std::map<std::string, FactId> rule_facts_;
  std::map<Datum, int> held_;
  std::optional<Failure> broken_;
};

}  // namespace pizarra::scheme
