#pragma once

// An agent that is a Scheme file (docs/scheme-agents.md): rules that fire on facts and tell facts, loops, operations,
// and what it remembers. The file is loaded again whenever it is saved; one that does not load is refused and says why
// as (program NAME kept WHY), and the one before goes on.
//
//   SchemeAgent agent(context, {.file = "conveyor.scm"});
//   Job job = executor.spawn(agent.run());
//
// Lifecycle: as every agent. Until a file loads it is present without operations, as (program NAME broken WHY). Facts
// of a replaced program go within two seconds, unless the new one tells them too. It ends, with too-much-kept, when
// what its program keeps takes more memory than it may.

#include <optional>

#include "agents/scheme/program_file.hpp"
#include "agents/scheme/running_program.hpp"

namespace pizarra::scheme {

struct SchemeOptions {
  std::string file;
  forms::ProgramLimits limits;
  double messages_per_s = 1000;  // facts told and retracted, and questions
  Log log;                       // of what the program says, and of what is wrong; none: nowhere
};

class SchemeAgent : public runtime::Agent {
 public:
  SchemeAgent(runtime::AgentContext context, SchemeOptions options);
  Task<Result<void>> run() override;

 private:
  struct Loaded {
    std::shared_ptr<const forms::AgentProgram> program;  // none: no file has loaded yet
    runtime::Contract contract;
  };
  // The program on the board, under one presence.
  struct Life;

  Result<Loaded> load(const std::string& text) const;
  Loaded without_program() const;
  std::optional<Loaded> look_for_another();
  Task<Result<std::optional<Loaded>>> live(Loaded loaded);
  Task<Result<void>> begin(Life& life, const Loaded& loaded);
  Task<Result<void>> say_state(LeaseId lease);
  Task<Result<void>> keep_lease(Life& life, const Loaded& loaded);

  runtime::AgentContext context_;
  SchemeOptions options_;
  ProgramFile file_;
  Allowance allowance_;
  bool has_program_ = false;
  std::string refused_;  // why the newest file does not load; empty: it runs
};

}  // namespace pizarra::scheme
