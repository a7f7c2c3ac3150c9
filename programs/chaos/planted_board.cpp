#include "programs/chaos/planted_board.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pizarra::chaos {

namespace {

constexpr std::uint64_t one_request_in = 20;
constexpr std::uint64_t one_reply_in = 10;
constexpr std::size_t old_looks = 10;
constexpr double holds_mm = 60;
constexpr Duration listening_pause = 10ms;

// Looks come as they were some looks ago, under the newest frame's number.
class OldLooks : public Watch {
 public:
  explicit OldLooks(std::unique_ptr<Watch> watch) : watch_(std::move(watch)) {}

  Task<Result<Change>> next() override {
    Result<Change> change = co_await watch_->next();
    if (!change) co_return change;
    for (Answer& answer : change->added) {
      for (Fact& fact : answer.facts) fact.datum = aged(fact.datum);
    }
    co_return change;
  }

 private:
  Datum aged(const Datum& look) {
    if (!look.is_form("look") || look.size() < 5) return look;
    looks_.push_back(look);
    if (looks_.size() > old_looks) looks_.pop_front();
    std::vector<Datum> items(looks_.front().items().begin(), looks_.front().items().end());
    items[2] = look[2];
    return Datum::list(std::move(items));
  }

  std::unique_ptr<Watch> watch_;
  std::deque<Datum> looks_;
};

// Changes come when nothing moves.
class HeardAtRest : public Watch {
 public:
  HeardAtRest(std::unique_ptr<Watch> watch, Executor& executor, const bool& moves)
      : watch_(std::move(watch)), executor_(executor), moves_(moves) {}

  Task<Result<Change>> next() override {
    Result<Change> change = co_await watch_->next();
    while (moves_) co_await sleep(executor_, listening_pause);
    co_return change;
  }

 private:
  std::unique_ptr<Watch> watch_;
  Executor& executor_;
  const bool& moves_;
};

// A TRACK reply that says of the object that it failed.
std::string text_without(std::string text, std::string_view object) {
  const std::string named = fmt::format("(\"{}\" ", object);
  const std::size_t from = text.find(named);
  if (from == std::string::npos || text.compare(from + named.size(), 2, "OK") != 0) return text;
  const std::size_t to = text.find("))", from);
  if (to == std::string::npos) return text;
  return text.replace(from, to + 2 - from, named + "FAIL)");
}

// A look in which the object is lost, also from its text.
Datum without(const Datum& look, std::string_view object) {
  std::vector<Datum> seen;
  for (const Datum& entry : look[4].items()) {
    const bool hidden = entry.size() > 1 && entry[0].text() == object;
    seen.push_back(hidden ? list(entry[0], "lost"_sym) : entry);
  }
  const std::string text = text_without(std::string(look[3].text()), object);
  return list(look[0], look[1], look[2], text, Datum::list(std::move(seen)));
}

}  // namespace

Task<Result<void>> PlantedBoard::declare(std::vector<Relation> relations) {
  return board_.declare(std::move(relations));
}

bool PlantedBoard::is_dropped(const Datum& fact) {
  if (has("planner", "plan-not-kept")) return fact.is_form("plan") || fact.is_form("plan-needs");
  if (has("coordinator", "goal-not-kept")) return fact.is_form("goal");
  if (has("coordinator", "places-kept") && fact.is_form("place")) return !placed_.insert(fact[1]).second;
  if (has("robot", "motion-not-kept")) return fact.is_form("robot-motion");
  if (has("vision", "replies-lost") && fact.is_form("reply")) return ++counted_ % one_reply_in == 0;
  return false;
}

std::optional<Transaction::Tell> PlantedBoard::changed(Transaction::Tell tell) {
  const Datum fact = tell.fact;
  if (is_dropped(fact)) return std::nullopt;
  if (has("vision", "presence-for-ever") && fact.is_form("agent")) tell.lease = 0;
  if (has("robot", "always-holds") && fact.is_form("gripper")) tell.fact = list(fact[0], fact[1], holds_mm);
  if (has("vision", "one-unseen") && fact.is_form("look")) tell.fact = without(fact, "triangle");
  const bool ends = fact.is_form("goal-state") && !fact[2].is_symbol("running");
  const bool reached = ends && fact[2].is_symbol("reached");
  if (reached && has("coordinator", "refused-for-nothing")) {
    const Failure failure{"no-plan", "planted", {}, {}};
    tell.fact = list(fact[0], fact[1], "refused"_sym, failure_to_datum(failure));
  }
  if (ends && !reached && has("coordinator", "reached-for-refused")) {
    tell.fact = list(fact[0], fact[1], "reached"_sym, Datum());
  }
  return tell;
}

Task<Result<Revision>> PlantedBoard::transact(Transaction transaction) {
  std::vector<Transaction::Step> steps;
  for (Transaction::Step& step : transaction.steps) {
    auto* tell = std::get_if<Transaction::Tell>(&step);
    if (tell == nullptr) {
      const auto* retract = std::get_if<Transaction::Retract>(&step);
      const bool keeps =
          retract != nullptr && retract->pattern.is_form("believed") && has("coordinator", "beliefs-kept");
      if (!keeps) steps.push_back(std::move(step));
      continue;
    }
    const Datum fact = tell->fact;
    if (fact.is_form("goal-state")) goal_state_ = fact;
    if (fact.is_form("robot-motion")) moves_ = fact[3] == Datum();
    if (std::optional<Transaction::Tell> told = changed(std::move(*tell))) steps.emplace_back(std::move(*told));
    const bool ends = has("coordinator", "reached-too-soon") && fact.is_form("operation") &&
                      fact[3].is_symbol("done") && goal_state_.is_form("goal-state");
    if (!ends) continue;
    steps.emplace_back(
        Transaction::Tell{.fact = list(goal_state_[0], goal_state_[1], "reached"_sym, Datum()), .because = {}});
  }
  transaction.steps = std::move(steps);
  return board_.transact(std::move(transaction));
}

Task<Result<Answers>> PlantedBoard::ask(Query query) {
  const bool unheard =
      has("robot", "stop-unheard") && !query.clauses.empty() && query.clauses.front().form.is_form("stop");
  if (unheard) co_return Answers{};
  co_return co_await board_.ask(std::move(query));
}

Task<Result<std::unique_ptr<Watch>>> PlantedBoard::watch(Query query) {
  const bool is_stop = !query.clauses.empty() && query.clauses.front().form.is_form("stop");
  const bool is_look = !query.clauses.empty() && query.clauses.front().form.is_form("look");
  // Nobody is called so.
  const bool unheard = is_stop && has("robot", "stop-unheard");
  if (unheard) query = query_for(list("stop"_sym, "nobody-at-all"_sym, "?"_sym));
  const bool is_commander = !query.clauses.empty() && query.clauses.front().form.is_form("commander");
  const bool disregarded = is_commander && has("robot", "commander-unheard");
  if (disregarded) query = query_for(list("commander"_sym, "nobody-at-all"_sym, "?"_sym));
  Result<std::unique_ptr<Watch>> watch = co_await board_.watch(std::move(query));
  const bool old = watch && is_look && has("coordinator", "looks-old");
  if (old) co_return std::make_unique<OldLooks>(std::move(*watch));
  const bool late = watch && is_commander && has("robot", "commander-heard-at-rest");
  if (late) co_return std::make_unique<HeardAtRest>(std::move(*watch), executor_, moves_);
  co_return watch;
}

Task<Result<std::optional<Fact>>> PlantedBoard::take(Datum pattern, LeaseId holder) {
  const bool loses = has("robot", "requests-lost") && ++counted_ % one_request_in == 0;
  if (!loses) co_return co_await board_.take(std::move(pattern), holder);
  const Result<std::optional<Fact>> gone = co_await board_.take(std::move(pattern), 0);
  if (!gone) co_return fail(gone);
  co_return std::optional<Fact>();
}

Task<Result<void>> PlantedBoard::renew(LeaseId lease) {
  const bool forgets = has("planner", "lease-not-renewed");
  if (forgets) co_return Result<void>();
  co_return co_await board_.renew(lease);
}

}  // namespace pizarra::chaos
