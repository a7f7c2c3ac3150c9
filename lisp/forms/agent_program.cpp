#include "lisp/forms/agent_program.hpp"

#include <sys/time.h>

#include "lisp/guile/scheme.hpp"

namespace pizarra::forms {

namespace {

constexpr const char* program_module = "agent-program";

// Has the process killed when the interpreter does not come back within so much of the processor's time.
class LastResort {
 public:
  explicit LastResort(const ProgramLimits& limits) : armed_(limits.own_process) {
    if (armed_) set(4 * limits.time);
  }
  LastResort(const LastResort&) = delete;
  LastResort& operator=(const LastResort&) = delete;
  ~LastResort() {
    if (armed_) set(std::chrono::milliseconds(0));
  }

 private:
  static void set(std::chrono::milliseconds time) {
    const itimerval timer{{}, {time.count() / 1000, (time.count() % 1000) * 1000}};
    setitimer(ITIMER_PROF, &timer, nullptr);
  }
  bool armed_;
};

Result<Datum> call(const ProgramLimits& limits, const char* procedure, const std::vector<Datum>& arguments) {
  const LastResort last_resort(limits);
  Result<Datum> outcome = guile::call_scheme(program_module, procedure, arguments);
  if (!outcome || !outcome->is_form("error")) return outcome;
  return fail(std::string((*outcome)[1].text()), std::string((*outcome)[2].text()));
}

std::vector<Datum> data_of(const Datum& list) { return {list.items().begin(), list.items().end()}; }

ProgramEffects effects_of(const Datum& datum) {
  ProgramEffects effects{data_of(datum[0]), {}};
  for (const Datum& line : datum[1].items()) effects.said.emplace_back(line.text());
  return effects;
}

ProgramPart part_of(const Datum& datum) {
  using enum ProgramPart::Sort;
  ProgramPart part{rule, std::string(datum[1].text()), datum[2], {}, std::chrono::milliseconds(datum[4].integer())};
  if (datum[0].is_symbol("conclude")) part.sort = conclusion;
  if (datum[0].is_symbol("loop")) part.sort = loop;
  if (datum[0].is_symbol("operation")) part.sort = operation;
  for (const Datum& variable : datum[3].items()) part.variables.emplace_back(variable.text());
  return part;
}

}  // namespace

AgentProgram::AgentProgram(const Datum& loaded, const ProgramLimits& limits)
    : limits_(limits),
      id_(loaded[1].integer()),
      kind_(loaded[2].text()),
      posts_(data_of(loaded[3])),
      reads_(data_of(loaded[4])),
      effects_(effects_of(loaded[6])) {
  for (const Datum& part : loaded[5].items()) parts_.push_back(part_of(part));
}

AgentProgram::~AgentProgram() {
  // It answers (ok) whatever is forgotten.
  [[maybe_unused]] const Result<Datum> forgotten = call({}, "forget-program", {Datum::integer(id_)});
}

Result<std::unique_ptr<AgentProgram>> AgentProgram::load(const std::string& agent, const std::string& text,
                                                         const std::string& file, const ProgramLimits& limits) {
  if (!is_string_text(text)) return fail("bad-program", file + ": this is no UTF-8 text");
  const Result<Datum> loaded = call(
      limits, "load-program",
      {Datum::symbol(agent), Datum::string(text), Datum::string(file), list(limits.time.count(), limits.memory_mb)});
  if (!loaded) return fail(loaded);
  return std::unique_ptr<AgentProgram>(new AgentProgram(*loaded, limits));
}

ProgramOutcome AgentProgram::outcome_of(const char* procedure, const std::vector<Datum>& arguments) const {
  const Result<Datum> outcome = call(limits_, procedure, arguments);
  if (!outcome) return {fail(outcome), {}, {}, 0};
  ProgramOutcome out{effects_of((*outcome)[1]), {}, {}, 0};
  if (outcome->is_form("done")) {
    out.value = (*outcome)[2];
  } else {
    out.waiting = (*outcome)[2].integer();
    out.question = (*outcome)[3];
  }
  return out;
}

ProgramOutcome AgentProgram::run(const std::string& part, Datum bindings, std::int64_t now_ms) const {
  return outcome_of("run-part",
                    {Datum::integer(id_), Datum::symbol(part), std::move(bindings), Datum::integer(now_ms)});
}

ProgramOutcome AgentProgram::resume(std::int64_t waiting, Datum answer, std::int64_t now_ms) const {
  return outcome_of("resume-run",
                    {Datum::integer(id_), Datum::integer(waiting), std::move(answer), Datum::integer(now_ms)});
}

void AgentProgram::abandon(std::int64_t waiting) const {
  [[maybe_unused]] const Result<Datum> gone = call({}, "abandon-run", {Datum::integer(id_), Datum::integer(waiting)});
}

}  // namespace pizarra::forms
