// A page's truth overlay and its measurements of the board, each for as long as the page looks; and what went on before
// it was opened.

#include <algorithm>
#include <fmt/format.h>

#include "agents/console/change_text.hpp"
#include "agents/console/session.hpp"
#include "agents/runtime/declared.hpp"
#include "lisp/json.hpp"
#include "lisp/writer.hpp"

namespace pizarra::console {

namespace {

constexpr Duration between_samples = 1s;
constexpr std::int64_t longest_look_s = 60;
constexpr std::size_t changes_at_once = 100;

std::string failed_text(const char* what, const Failure& failure) {
  return fmt::format("{{\"{}\":null,\"said\":{}}}", what, json_string(describe(failure)));
}

}  // namespace

bool Session::may_see_truth() const {
  const bool own_machine = setup_.key.empty();
  return own_machine && setup_.truth != nullptr && setup_.truth->is_there();
}

void Session::truth(const Datum&) {
  if (!may_see_truth()) return;
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

void Session::work(const Datum& form) { begin_request(form[1].integer(), show_work(form[1].integer())); }

Task<void> Session::show_work(Number number) {
  if (setup_.kept != nullptr) {
    co_await setup_.kept->read();
    co_await say_kept("servo", KeptChanges::servo_pattern(), setup_.kept->servo());
    co_await say_kept("sightings", KeptChanges::sighting_pattern(), setup_.kept->sightings());
  }
  const Datum done;
  say(reply_text(number, done));
}

// Where the page's own session may read what was kept.
Task<void> Session::say_kept(std::string kind, Datum pattern, const std::deque<KeptChange>& kept) {
  const Result<std::vector<Fact>> may = co_await runtime::facts_if_declared(context_.board, std::move(pattern));
  if (!may) co_return;
  const std::vector<KeptChange> changes(kept.begin(), kept.end());
  for (std::size_t first = 0; first < changes.size(); first += changes_at_once) {
    std::string items;
    for (std::size_t i = first; i < std::min(first + changes_at_once, changes.size()); ++i) {
      items += fmt::format("{}{{\"until\":{},\"answer\":{}}}", items.empty() ? "" : ",",
                           changes[i].until.time_since_epoch().count(), told_text(changes[i].fact));
    }
    co_await room();
    say_fact(fmt::format("{{\"work\":{},\"changes\":[{}]}}", json_string(kind), items));
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

void Session::cells(const Datum& form) {
  const Number number = form[1].integer();
  if (setup_.instruments == nullptr || !setup_.instruments->cells) {
    return refuse(number, "unknown-operation", "this console cannot look at other cells");
  }
  if (!cells_.done()) return refuse(number, "too-many", "this page looks already");
  cells_ = setup_.executor.spawn(look_at_cells(number));
}

Task<void> Session::look_at_cells(Number number) {
  const Result<std::string> seen = co_await setup_.instruments->cells(setup_.key);
  if (!seen) {
    say(refusal_text(number, seen.error()));
    co_return;
  }
  const Datum cells = list(*seen);
  say(reply_text(number, cells));
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
