#include "agents/repl/prompt.hpp"

#include <fmt/format.h>

#include "blackboard/away.hpp"
#include "lisp/json.hpp"

namespace pizarra::repl {

Evaluation Prompt::show(const Failure& failure, Evaluation outcome) const {
  say(describe(failure), json_error(failure));
  return outcome;
}

Evaluation Prompt::show(const Failure& failure) const {
  return show(failure, is_away(failure) ? Evaluation::unavailable : Evaluation::failed);
}

Evaluation Prompt::misused(const Typed& typed) const {
  const std::string sentence = fmt::format("{0} is {1}; (help {0}) says more", typed.form.head(), typed.usage);
  return show({"malformed", sentence, {}, {}}, Evaluation::malformed);
}

}  // namespace pizarra::repl
