// A page's truth overlay and its measurements of the board, each for as long as the page looks.

#include <algorithm>
#include <fmt/format.h>

#include "agents/console/change_text.hpp"
#include "agents/console/session.hpp"
#include "lisp/json.hpp"
#include "lisp/writer.hpp"

namespace pizarra::console {

namespace {

constexpr Duration between_samples = 1s;
constexpr std::int64_t longest_look_s = 60;

std::string failed_text(const char* what, const Failure& failure) {
  return fmt::format("{{\"{}\":null,\"said\":{}}}", what, json_string(describe(failure)));
}

}  // namespace

void Session::truth(const Datum&) {
  if (setup_.truth == nullptr || !setup_.truth->is_there()) return;
  truth_ = setup_.truth->look([this](const Result<Datum>& truth) {
    if (unheard_bytes_ >= max_unheard_bytes) return;
    say_fact(truth ? fmt::format("{{\"truth\":{}}}", json_string(write(*truth))) : failed_text("truth", truth.error()));
  });
}

void Session::truth_no_more(const Datum&) { truth_.reset(); }

void Session::activity(const Datum&) { activity_ = setup_.executor.spawn(sample_activity()); }

void Session::activity_no_more(const Datum&) { activity_ = Job(); }

Task<void> Session::sample_activity() {
  if (setup_.instruments == nullptr || !setup_.instruments->activity) co_return;
  const auto next = setup_.instruments->activity(context_.board, setup_.name);
  while (true) {
    const Result<std::string> sample = co_await next();
    co_await room();
    if (!sample) {
      say_fact(failed_text("activity", sample.error()));
      co_return;
    }
    say_fact(fmt::format("{{\"activity\":{}}}", *sample));
    co_await sleep(setup_.executor, between_samples);
  }
}

void Session::method(const Datum& form) {
  const Number number = form[1].integer();
  if (setup_.instruments == nullptr || !setup_.instruments->method) {
    return refuse(number, "unknown-operation", "this console cannot look at the method");
  }
  const std::int64_t seconds = std::clamp<std::int64_t>(form[2].integer(), 1, longest_look_s);
  if (!method_.done()) return refuse(number, "too-many", "this page looks already");
  method_ = setup_.executor.spawn(look_at_method(number, seconds * 1s));
}

Task<void> Session::look_at_method(Number number, Duration length) {
  const std::string name = setup_.name + "-method";
  const Result<std::string> seen = co_await setup_.instruments->method(context_.board, name, setup_.connect, length);
  if (!seen) {
    say(refusal_text(number, seen.error()));
    co_return;
  }
  const Datum report = list(*seen);
  say(reply_text(number, report));
}

}  // namespace pizarra::console
