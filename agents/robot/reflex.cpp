#include "agents/robot/reflex.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "agents/runtime/follow.hpp"
#include "agents/runtime/stop_fact.hpp"
#include "blackboard/away.hpp"

namespace pizarra::robot {

namespace {

Failure stopped(std::string sentence, Datum subject) {
  return {"stopped", std::move(sentence), std::move(subject), {}};
}

Failure stopped_by(const Datum& stop) { return stopped(runtime::stop_in_words(stop), stop); }

bool among(const std::map<FactId, std::string>& names, const std::string& name) {
  return std::ranges::any_of(names, [&](const auto& entry) { return entry.second == name; });
}

}  // namespace

void Reflex::begin() {
  const Datum robot = Datum::symbol(context_.name);
  for (Datum pattern : {list("stop"_sym, "?who"_sym, "?reason"_sym), list("commander"_sym, robot, "?client"_sym),
                        list("agent"_sym, "?name"_sym, "?kind"_sym, "?host"_sym)}) {
    const std::string relation(pattern.head());
    following_.push_back(context_.executor.spawn(runtime::follow(
        context_, std::move(pattern), [this, relation](Change change) { return take(relation, std::move(change)); })));
  }
}

Task<void> Reflex::known() {
  while (heard_.size() < following_.size()) {
    const Time deadline = context_.executor.now() + retry_pause;
    co_await more_heard_.wait(deadline);
  }
}

Task<void> Reflex::take(std::string relation, Change change) {
  see(relation, change);
  if (heard_.insert(relation).second) more_heard_.wake_all();
  co_return;
}

void Reflex::see(const std::string& relation, const Change& change) {
  if (change.resynchronised) {
    const bool commanded = client_ && among(commanders_, *client_);
    forget(relation);
    for (const Answer& answer : change.added) add(answer.facts.front());
    const bool absent = client_ && leased_ && !among(present_, *client_);
    const bool lost = absent || (commanded && !among(commanders_, *client_));
    if (lost) gone(*client_);
  } else {
    for (const Answer& answer : change.added) add(answer.facts.front());
    for (const Answer& answer : change.removed) remove(answer.facts.front());
  }
  hand_over();
}

// One that is not present may have died without a word, and its fact may stand for ever.
const std::string* Reflex::commander() const {
  const auto first =
      std::ranges::find_if(commanders_, [&](const auto& entry) { return among(present_, entry.second); });
  return first == commanders_.end() ? nullptr : &first->second;
}

// Ends the motion in hand where another than its client commands now.
void Reflex::hand_over() {
  const std::string* now = commander();
  if (!client_ || now == nullptr || *now == *client_) return;
  control_.stop_at_once(stopped(fmt::format("{} commands the arm now", *now), Datum::symbol(*now)));
}

void Reflex::forget(const std::string& relation) {
  if (relation == "stop") stops_.clear();
  if (relation == "commander") commanders_.clear();
  if (relation == "agent") present_.clear();
}

void Reflex::add(const Fact& fact) {
  if (fact.datum.is_form("stop")) {
    stops_.insert_or_assign(fact.id, fact.datum);
    control_.stop_at_once(stopped_by(fact.datum));
  } else if (fact.datum.is_form("agent")) {
    present_.insert_or_assign(fact.id, fact.datum[1].text());
  } else if (fact.datum[2].is_symbol(fact.teller)) {
    // Who commands says so itself.
    commanders_.insert_or_assign(fact.id, fact.teller);
  }
}

void Reflex::remove(const Fact& fact) {
  stops_.erase(fact.id);
  const auto commander = commanders_.find(fact.id);
  if (commander != commanders_.end()) {
    const std::string client = commander->second;
    commanders_.erase(commander);
    if (!among(commanders_, client)) gone(client);
  }
  const auto agent = present_.find(fact.id);
  if (agent == present_.end()) return;
  const std::string name = agent->second;
  present_.erase(agent);
  if (leased_ && !among(present_, name)) gone(name);
}

void Reflex::gone(const std::string& client) {
  if (client != client_) return;
  control_.stop_at_once(stopped(fmt::format("{}, who commanded this, is gone", client), Datum::symbol(client)));
}

Result<void> Reflex::allows(const std::string& client) const {
  if (!stops_.empty()) {
    const Datum& stop = stops_.begin()->second;
    return fail("halted", runtime::stop_in_words(stop), stop);
  }
  const std::string* now = commander();
  if (now != nullptr && *now != client) {
    return fail("not-commander", fmt::format("{} commands the arm", *now), Datum::symbol(*now));
  }
  if (now != nullptr || !among(commanders_, client)) return {};
  return fail("not-present",
              fmt::format("{0} says that it commands the arm and is not present: there is no (agent {0} ...)", client),
              Datum::symbol(client));
}

Reflex::Watching::Watching(Reflex& reflex, std::string client, LeaseId lease) : reflex_(reflex) {
  reflex_.leased_ = among(reflex_.present_, client);
  reflex_.client_ = std::move(client);
  reflex_.silence_ = 0;
  beating_ = reflex_.context_.executor.spawn(reflex_.beat_on(lease));
}

Task<void> Reflex::beat_on(LeaseId lease) {
  // A question that is lost on the way is sent again late, sooner where others come after it: one goes out each beat,
  // whether or not those before are answered.
  std::array<Job, silent_beats> asking;
  for (std::size_t beats = 0;; ++beats) {
    Job& next = asking[beats % asking.size()];
    if (beats < asking.size() || next.done()) next = context_.executor.spawn(ask_board(lease));
    co_await sleep(context_.executor, beat);
    if (++silence_ < silent_beats) continue;
    silence_ = 0;
    const Duration silent = silent_beats * beat;
    control_.stop_at_once(stopped(fmt::format("the board has not answered for {} ms", silent.count() / 1000),
                                  list("silent"_sym, "board"_sym)));
  }
}

Task<void> Reflex::ask_board(LeaseId lease) {
  const Result<void> answered = co_await context_.board.renew(lease);
  // One that has forgotten the lease is there all the same.
  const bool there = answered || !is_away(answered.error());
  if (there) silence_ = 0;
}

}  // namespace pizarra::robot
