#include "agents/console/page_instruments.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/console/change_text.hpp"
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

bool PageInstruments::may_see_truth() const {
  const bool own_machine = setup_.key.empty();
  return own_machine && setup_.truth != nullptr && setup_.truth->is_there();
}

void PageInstruments::show_truth(bool looks) {
  if (!looks) truth_.reset();
  if (!looks || !may_see_truth()) return;
  truth_ = setup_.truth->look([this](const Result<Datum>& truth) {
    if (voice_.is_behind()) return;
    voice_.say_fact(truth ? fmt::format("{{\"truth\":{}}}", json_string(write(*truth)))
                          : failed_text("truth", truth.error()));
  });
}

void PageInstruments::show_activity(bool looks) {
  activity_ = looks ? setup_.executor.spawn(sample_activity()) : Job();
}

Task<void> PageInstruments::sample_activity() {
  if (setup_.instruments == nullptr || !setup_.instruments->activity) co_return;
  const auto next = setup_.instruments->activity(setup_.board, setup_.name);
  while (true) {
    const Result<std::string> sample = co_await next();
    co_await voice_.room();
    if (!sample) {
      voice_.say_fact(failed_text("activity", sample.error()));
      co_return;
    }
    voice_.say_fact(fmt::format("{{\"activity\":{}}}", *sample));
    co_await sleep(setup_.executor, between_samples);
  }
}

Task<void> PageInstruments::tell_work(Request request) {
  if (setup_.kept != nullptr) {
    co_await setup_.kept->read();
    co_await say_kept("servo", KeptChanges::servo_pattern(), setup_.kept->servo());
    co_await say_kept("sightings", KeptChanges::sighting_pattern(), setup_.kept->sightings());
  }
  const Datum done;
  voice_.say(reply_text(request, done));
}

// Where the page's own session may read what was kept.
Task<void> PageInstruments::say_kept(std::string kind, Datum pattern, const std::deque<KeptChange>& kept) {
  const Result<std::vector<Fact>> may = co_await runtime::facts_if_declared(setup_.board, std::move(pattern));
  if (!may) co_return;
  const std::vector<KeptChange> changes(kept.begin(), kept.end());
  for (std::size_t first = 0; first < changes.size(); first += changes_at_once) {
    std::string items;
    for (std::size_t i = first; i < std::min(first + changes_at_once, changes.size()); ++i) {
      items += fmt::format("{}{{\"until\":{},\"answer\":{}}}", items.empty() ? "" : ",",
                           changes[i].until.time_since_epoch().count(), told_text(changes[i].fact));
    }
    co_await voice_.room();
    voice_.say_fact(fmt::format("{{\"work\":{},\"changes\":[{}]}}", json_string(kind), items));
  }
}

void PageInstruments::look_at_method(Request request, std::int64_t seconds) {
  if (setup_.instruments == nullptr || !setup_.instruments->method) {
    return voice_.refuse(request, "unknown-operation", "this console cannot look at the method");
  }
  if (!method_.done()) return voice_.refuse(request, "too-many", "this page looks already");
  method_ = setup_.executor.spawn(see_method(request, std::clamp<std::int64_t>(seconds, 1, longest_look_s) * 1s));
}

void PageInstruments::look_at_cells(Request request) {
  if (setup_.instruments == nullptr || !setup_.instruments->cells) {
    return voice_.refuse(request, "unknown-operation", "this console cannot look at other cells");
  }
  if (!cells_.done()) return voice_.refuse(request, "too-many", "this page looks already");
  cells_ = setup_.executor.spawn(see_cells(request));
}

Task<void> PageInstruments::see_cells(Request request) {
  const Result<std::string> seen = co_await setup_.instruments->cells(setup_.key);
  if (!seen) {
    voice_.say(refusal_text(request, seen.error()));
    co_return;
  }
  const Datum cells = list(*seen);
  voice_.say(reply_text(request, cells));
}

Task<void> PageInstruments::see_method(Request request, Duration length) {
  const std::string name = setup_.name + "-method";
  const Result<std::string> seen = co_await setup_.instruments->method(setup_.board, name, setup_.connect, length);
  if (!seen) {
    voice_.say(refusal_text(request, seen.error()));
    co_return;
  }
  const Datum report = list(*seen);
  voice_.say(reply_text(request, report));
}

}  // namespace pizarra::console
