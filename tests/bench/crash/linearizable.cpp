#include "tests/bench/crash/linearizable.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <list>
#include <optional>
#include <set>
#include <utility>

namespace pizarra::bench {

namespace {

struct Event {
  std::int64_t when;
  bool answer;
  std::size_t operation;
};

// The register after the operation; nothing where the operation could not have been answered so.
std::optional<std::int64_t> after(const Operation& operation, std::int64_t value) {
  const bool same = value == (operation.kind == Operation::Kind::read ? operation.value : operation.expected);
  if (operation.outcome == Operation::Outcome::refused) return same ? std::nullopt : std::optional(value);
  if (!same) return std::nullopt;
  return operation.value;
}

// Depth first: the operation that is said to come next is one that was called before any other was answered. One that
// fits and leaves the value as it is comes at once, because it is in nobody's way then. Of the others, a set that was
// tried in vain with the value that it leaves is not tried again.
class Search {
 public:
  explicit Search(const std::vector<Operation>& history) : history_(history), taken_(history.size(), false) {
    std::vector<Event> events;
    for (std::size_t i = 0; i < history.size(); ++i) {
      events.push_back({history[i].called, false, i});
      if (history[i].outcome == Operation::Outcome::unknown) continue;
      events.push_back({history[i].answered, true, i});
      ++answers_left_;
    }
    // What happened at the same time may have overlapped.
    std::ranges::stable_sort(events, {}, [](const Event& event) { return std::pair(event.when, event.answer); });
    events_.assign(events.begin(), events.end());
  }

  bool run() {
    auto at = events_.begin();
    while (answers_left_ > 0) {
      // An answer that comes before anything else can: one of those taken was wrong.
      const bool stuck = at == events_.end() || at->answer;
      if (stuck) {
        while (!steps_.empty() && !steps_.back().changes) take_back();
        if (steps_.empty()) return false;
        at = take_back();
      } else {
        at = take(at) ? events_.begin() : std::next(at);
      }
    }
    return true;
  }

 private:
  using Events = std::list<Event>;
  struct Step {
    Events call;
    Events answer;
    Events::iterator behind_call;
    Events::iterator behind_answer;
    std::size_t operation;
    std::int64_t before;
    bool changes;
  };

  bool take(Events::iterator call) {
    const std::size_t operation = call->operation;
    const std::optional<std::int64_t> value = after(history_[operation], value_);
    if (!value) return false;
    const bool changes = *value != value_;
    taken_[operation] = true;
    if (changes && !tried_.emplace(taken_, *value).second) {
      taken_[operation] = false;
      return false;
    }
    Step step{{}, {}, std::next(call), events_.end(), operation, value_, changes};
    const auto answer = std::find_if(call, events_.end(),
                                     [&](const Event& event) { return event.answer && event.operation == operation; });
    if (answer != events_.end()) {
      step.behind_answer = std::next(answer);
      step.answer.splice(step.answer.end(), events_, answer);
      if (step.behind_call == step.answer.begin()) step.behind_call = step.behind_answer;
      --answers_left_;
    }
    step.call.splice(step.call.end(), events_, call);
    value_ = *value;
    steps_.push_back(std::move(step));
    return true;
  }

  // The event behind the call that is put back is tried next.
  Events::iterator take_back() {
    Step step = std::move(steps_.back());
    steps_.pop_back();
    taken_[step.operation] = false;
    value_ = step.before;
    const auto call = step.call.begin();
    events_.splice(step.behind_call, step.call);
    if (!step.answer.empty()) ++answers_left_;
    events_.splice(step.behind_answer, step.answer);
    return std::next(call);
  }

  const std::vector<Operation>& history_;
  Events events_;
  std::vector<Step> steps_;
  std::vector<bool> taken_;
  std::set<std::pair<std::vector<bool>, std::int64_t>> tried_;
  std::size_t answers_left_ = 0;
  std::int64_t value_ = 0;
};

}  // namespace

bool is_linearizable(const std::vector<Operation>& history) { return Search(history).run(); }

std::string describe(std::vector<Operation> history) {
  using Outcome = Operation::Outcome;
  std::ranges::sort(history, {}, &Operation::called);
  std::string lines;
  for (const Operation& operation : history) {
    const auto ms = [&](std::int64_t when) { return 1e-6 * static_cast<double>(when - history.front().called); };
    const bool reads = operation.kind == Operation::Kind::read;
    const std::string what = reads ? fmt::format("read {}", operation.value)
                                   : fmt::format("put {} for {}", operation.value, operation.expected);
    const bool never = operation.answered == Operation::never;
    const std::string end = never ? "never answered" : fmt::format("answered at {:.3f}", ms(operation.answered));
    const char* refused = operation.outcome == Outcome::refused ? ", refused" : "";
    lines += fmt::format("  at {:.3f}: {}, {}{}\n", ms(operation.called), what, end, refused);
  }
  return lines;
}

}  // namespace pizarra::bench
