#include "lisp/guile/scheme.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <fmt/format.h>
#include <libguile.h>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "lisp/guile/convert.hpp"
#include "lisp/guile/module_errors.hpp"
#include "lisp/shipped.hpp"

#ifdef __SANITIZE_ADDRESS__
// What Guile allocates once and keeps where the leak sanitizer does not look is no leak of ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libguile-3.0\n"; }
#endif

namespace pizarra::guile {

namespace {

using guile::Builder;

// The data of one call, kept in a frame that no non-local exit skips.
struct Call {
  const std::string& module;
  const std::string& procedure;
  const std::vector<Datum>& arguments;
  SCM function = SCM_UNDEFINED;
  SCM error_key = SCM_UNDEFINED;
  SCM error_values = SCM_UNDEFINED;
  bool raised = false;
  Builder result = {};
};

SCM on_error(void* data, SCM key, SCM values) {
  Call& call = *static_cast<Call*>(data);
  call.error_key = key;
  call.error_values = values;
  call.raised = true;
  return SCM_UNDEFINED;
}

// Runs a body under a catch of everything; whether it came to its end.
bool run(Call& call, scm_t_catch_body body) {
  call.raised = false;
  scm_internal_catch(SCM_BOOL_T, body, &call, on_error, &call);
  return !call.raised;
}

SCM find_body(void* data) {
  Call& call = *static_cast<Call*>(data);
  const SCM name = scm_list_2(scm_from_utf8_symbol("pizarra"), scm_from_utf8_symbol(call.module.c_str()));
  const SCM variable = scm_public_variable(name, scm_from_utf8_symbol(call.procedure.c_str()));
  call.function = scm_variable_ref(variable);
  return SCM_UNSPECIFIED;
}

SCM apply_body(void* data) {
  Call& call = *static_cast<Call*>(data);
  SCM arguments = SCM_EOL;
  for (std::size_t i = call.arguments.size(); i > 0; --i) {
    arguments = scm_cons(guile::to_scheme(call.arguments[i - 1]), arguments);
  }
  call.result.take(scm_apply_0(call.function, arguments));
  return SCM_UNSPECIFIED;
}

// Guile's own words for an error.
SCM explain_body(void* data) {
  Call& call = *static_cast<Call*>(data);
  const SCM port = scm_open_output_string();
  scm_print_exception(port, SCM_BOOL_F, call.error_key, call.error_values);
  call.result.take(scm_get_output_string(port));
  return SCM_UNSPECIFIED;
}

Failure explain(Call& call) {
  Call explanation{call.module, call.procedure, call.arguments};
  explanation.error_key = call.error_key;
  explanation.error_values = call.error_values;
  const bool explained = run(explanation, explain_body) && !explanation.result.problem();
  const Datum text = explained ? explanation.result.result() : Datum::string("it cannot be shown");
  return {"scheme-error",
          fmt::format("(pizarra {}) {} raised an error: {}", call.module, call.procedure, text.text()),
          {},
          {}};
}

SCM from_text(const std::string& text) { return scm_from_utf8_stringn(text.data(), text.size()); }

SCM start_body(void*) {
  const SCM load_path = scm_c_public_variable("guile", "%load-path");
  const SCM compiled_path = scm_c_public_variable("guile", "%load-compiled-path");
  scm_variable_set_x(load_path, scm_cons(from_text(shipped_file("lisp/modules")), scm_variable_ref(load_path)));
  scm_variable_set_x(compiled_path, scm_cons(from_text(compiled_modules()), scm_variable_ref(compiled_path)));
  return SCM_UNSPECIFIED;
}

// Starts Guile on the calling thread, whose whole stack its collector then searches.
class Interpreter {
 public:
  static Interpreter& instance() {
    static Interpreter interpreter;
    return interpreter;
  }

  Result<Datum> call(Call& call) {
    assert(std::this_thread::get_id() == thread_);
    if (const auto found = functions_.find({call.module, call.procedure}); found != functions_.end()) {
      call.function = found->second;
    } else {
      if (!run(call, find_body)) return fail(explain(call));
      functions_.emplace(std::pair(call.module, call.procedure), scm_gc_protect_object(call.function));
    }
    if (!run(call, apply_body)) return fail(explain(call));
    if (call.result.problem()) return fail("scheme-error", call.result.problem());
    return call.result.result();
  }

 private:
  Interpreter() : thread_(std::this_thread::get_id()) {
    setenv("GUILE_AUTO_COMPILE", "0", 1);
    // What we keep is small: collecting it with more threads costs more than it saves.
    setenv("GC_MARKERS", "1", 0);
    scm_init_guile();
    // No finalizer of ours exists, and the thread that would run them would outlive a fork badly.
    scm_set_automatic_finalization_enabled(0);
    static const std::string none;
    static const std::vector<Datum> no_arguments;
    Call call{none, none, no_arguments};
    [[maybe_unused]] const bool started = run(call, start_body);
    assert(started);
  }

  std::thread::id thread_;
  // Few: our own procedures that C++ calls. Guile's collector does not look here, so each is protected.
  std::map<std::pair<std::string, std::string>, SCM> functions_;
};

// What the module answers: (ok VALUE) or (errors ERROR ...).
Result<Datum> outcome_of(const std::vector<Datum>& data, const std::string& module, const std::vector<Datum>& more,
                         const std::string& procedure) {
  std::vector<Datum> arguments{Datum::list(data)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Result<Datum> outcome = call_scheme(module, procedure, arguments);
  if (!outcome) return outcome;
  const bool ok = outcome->is_form("ok") && outcome->size() == 2;
  const auto errors = outcome->items().subspan(std::min<std::size_t>(outcome->size(), 1));
  const bool refused = outcome->is_form("errors") && !errors.empty() && std::ranges::all_of(errors, is_module_error);
  if (ok || refused) return outcome;
  return fail("scheme-error", fmt::format("(pizarra {}) {} returned no outcome", module, procedure), *outcome);
}

std::unexpected<std::vector<Failure>> alone(Failure failure) {
  return std::unexpected(std::vector<Failure>{std::move(failure)});
}

}  // namespace

Result<Datum> call_scheme(const std::string& module, const std::string& procedure,
                          const std::vector<Datum>& arguments) {
  Call call{module, procedure, arguments};
  return Interpreter::instance().call(call);
}

std::expected<Datum, std::vector<Failure>> interpret_apart(const Source& source, const std::string& module,
                                                           const std::vector<Datum>& more,
                                                           const std::string& procedure) {
  const Result<Datum> outcome = outcome_of(source.data(), module, more, procedure);
  if (!outcome) return alone(outcome.error());
  if (outcome->is_form("errors")) return std::unexpected(failures_of(source, outcome->items().subspan(1)));
  if (!source.errors().empty()) return std::unexpected(failures_of(source, {}));
  return (*outcome)[1];
}

Result<Datum> interpret_data(const std::vector<Datum>& data, const std::string& module,
                             const std::vector<Datum>& more) {
  const Result<Datum> outcome = outcome_of(data, module, more, "interpret");
  if (!outcome) return fail(outcome);
  if (outcome->is_form("ok")) return (*outcome)[1];
  return std::unexpected(failure_of(data, (*outcome)[1]));
}

Result<Datum> interpret(const Source& source, const std::string& module, const std::vector<Datum>& more,
                        const std::string& procedure) {
  std::expected<Datum, std::vector<Failure>> read = interpret_apart(source, module, more, procedure);
  if (!read) return fail(one_report(read.error()));
  return std::move(*read);
}

}  // namespace pizarra::guile
