#pragma once

// The expected content of a Store, kept the slow and obvious way: a list of facts that every operation looks through.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "blackboard/board.hpp"
#include "lisp/pattern.hpp"

namespace pizarra {

class StoreModel {
 public:
  struct Entry {
    Datum datum;
    std::string teller;
    LeaseId lease = 0;
  };
  struct Held {
    Entry fact;
    LeaseId holder = 0;
  };

  explicit StoreModel(std::vector<Relation> relations) : relations_(std::move(relations)) {}

  // Whether it happened.
  bool transact(const std::string& teller, const Transaction& transaction) {
    for (const auto& precondition : transaction.preconditions) {
      const Datum& pattern = std::visit([](const auto& p) -> const Datum& { return p.pattern; }, precondition);
      const bool wanted = std::holds_alternative<Transaction::Present>(precondition);
      if (std::ranges::any_of(facts_, [&](const Entry& e) { return fits(pattern, e.datum); }) != wanted) return false;
    }
    for (const Transaction::Step& step : transaction.steps) {
      const auto* tell = std::get_if<Transaction::Tell>(&step);
      if (tell != nullptr && tell->lease != 0 && !leases_.contains(tell->lease)) return false;
    }
    for (const Transaction::Step& step : transaction.steps) {
      if (const auto* tell = std::get_if<Transaction::Tell>(&step)) this->tell(teller, *tell);
      if (const auto* retract = std::get_if<Transaction::Retract>(&step)) {
        std::erase_if(facts_, [&](const Entry& e) { return fits(retract->pattern, e.datum); });
      }
    }
    return true;
  }

  void lease(LeaseId id, Time expiry) { leases_[id] = expiry; }
  bool has_lease(LeaseId id) const { return leases_.contains(id); }

  // A fact that is taken, under the id that the store gave it.
  std::optional<Datum> take(const Datum& pattern, LeaseId holder, FactId id) {
    const auto found = std::ranges::find_if(facts_, [&](const Entry& e) { return fits(pattern, e.datum); });
    if (found == facts_.end()) return std::nullopt;
    held_[id] = {*found, holder};
    facts_.erase(found);
    return held_[id].fact.datum;
  }
  bool settle(FactId id) { return held_.erase(id) == 1; }

  void lapse(LeaseId id) {
    leases_.erase(id);
    std::erase_if(facts_, [&](const Entry& e) { return e.lease == id; });
    std::vector<FactId> back;
    for (const auto& [taken, held] : held_) {
      if (held.holder == id) back.push_back(taken);
    }
    for (const FactId taken : back) {
      const Entry entry = held_.at(taken).fact;
      held_.erase(taken);
      if (entry.lease != 0 && !leases_.contains(entry.lease)) continue;
      if (std::ranges::none_of(facts_, [&](const Entry& e) { return key(e.datum) == key(entry.datum); })) {
        facts_.push_back(entry);
      }
    }
  }
  void pass_to(Time now) {
    while (true) {
      std::optional<std::pair<Time, LeaseId>> due;
      for (const auto& [id, expiry] : leases_) {
        if (expiry <= now && (!due || std::pair(expiry, id) < *due)) due = {expiry, id};
      }
      if (!due) return;
      lapse(due->second);
    }
  }
  void renew(LeaseId id, Time expiry) { leases_.at(id) = expiry; }

  const std::vector<Entry>& facts() const { return facts_; }

  // Every way to satisfy the clauses, by trying every fact for every pattern.
  std::vector<Bindings> answers(const Query& query) const {
    std::vector<Bindings> found = {{}};
    for (const Query::Clause& clause : query.clauses) {
      std::vector<Bindings> extended;
      for (const Bindings& bindings : found) {
        bool any = false;
        for (const Entry& entry : facts_) {
          Bindings both = bindings;
          if (!match(clause.form, entry.datum, both)) continue;
          any = true;
          if (clause.kind == Query::Clause::Kind::fact) extended.push_back(both);
        }
        if (clause.kind == Query::Clause::Kind::absent && !any) extended.push_back(bindings);
      }
      found = std::move(extended);
    }
    return found;
  }

 private:
  static bool fits(const Datum& pattern, const Datum& datum) {
    Bindings bindings;
    return match(pattern, datum, bindings);
  }
  Datum key(const Datum& datum) const {
    const auto relation = std::ranges::find_if(relations_, [&](const Relation& r) { return r.name == datum.head(); });
    return key_of(*relation, datum);
  }
  void tell(const std::string& teller, const Transaction::Tell& tell) {
    for (Entry& entry : facts_) {
      if (entry.datum != tell.fact) continue;
      entry.lease = tell.lease;
      return;
    }
    std::erase_if(facts_, [&](const Entry& e) { return key(e.datum) == key(tell.fact); });
    facts_.push_back({tell.fact, teller, tell.lease});
  }

  std::vector<Relation> relations_;
  std::vector<Entry> facts_;
  std::map<LeaseId, Time> leases_;
  std::map<FactId, Held> held_;
};

}  // namespace pizarra
