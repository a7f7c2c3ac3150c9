#include "blackboard/store/lapsing.hpp"

#include <algorithm>

#include "blackboard/store/transaction_change.hpp"

namespace pizarra::store {

namespace {

// As one lapses under which nothing stands, or forgets what came under another since.
constexpr std::size_t looks_a_lapse = 8;

void spend(std::size_t& left, std::size_t looks) { left -= std::min(left, looks); }

}  // namespace

Result<void> Lapsing::release(LeaseId lease, Time now, std::size_t& examined) {
  if (kept_.leases().find(lease) == nullptr) return unknown_lease(lease);
  Leases::Lease under_it = kept_.leases().remove(lease);
  std::size_t left = lapsing_at_once;
  lapse_some(lease, under_it, left, now);
  examined += lapsing_at_once - left;
  keep_lapsing(lease, std::move(under_it));
  return {};
}

std::optional<Time> Lapsing::next_expiry() const {
  std::optional<Time> next;
  if (!lapsing_.empty()) return Time::min();
  if (const auto lease = kept_.leases().first()) next = lease->first;
  if (!kept_.expiries().empty() && (!next || kept_.expiries().begin()->first < *next))
    next = kept_.expiries().begin()->first;
  return next;
}

// All that are due end before any has its part; leases and leased facts have half of it each, and what others leave.
void Lapsing::expire(Time due, Time now, std::size_t& left) {
  for (auto lease = kept_.leases().first(); left > 0 && lease && lease->first <= due; lease = kept_.leases().first()) {
    keep_lapsing(lease->second, kept_.leases().remove(lease->second));
    spend(left, looks_a_lapse);
  }
  std::size_t of_facts = left / 2;
  left -= of_facts;
  lapse_facts(due, of_facts, now);
  left += of_facts;
  while (left > 0 && !lapsing_.empty()) {
    auto least = lapsing_.extract(lapsing_.begin());
    kept_.set_lapsing(!lapsing_.empty());
    auto& [lease, under_it] = least.mapped();
    lapse_some(lease, under_it, left, now);
    keep_lapsing(lease, std::move(under_it));
  }
  lapse_facts(due, left, now);
}

void Lapsing::keep_lapsing(LeaseId lease, Leases::Lease under_it) {
  const std::size_t to_go = under_it.facts.size() + under_it.held.size();
  if (to_go > 0) lapsing_.emplace(to_go, std::pair(lease, std::move(under_it)));
  kept_.set_lapsing(!lapsing_.empty());
}

// A fact that has come under another lease since, or under none, stays; and so does what was settled.
void Lapsing::lapse_some(LeaseId lease, Leases::Lease& under_it, std::size_t& left, Time now) {
  TransactionChange change(kept_, "board", now);
  while (left > 0 && !under_it.facts.empty()) {
    const FactId fact = under_it.facts.extract(under_it.facts.begin()).value();
    const bool goes = kept_.lease_of(fact) == lease;
    spend(left, goes ? kept_.find(fact)->table->looks_to_remove() : looks_a_lapse);
    if (goes) change.retract(fact);
  }
  while (left > 0 && !under_it.held.empty()) {
    const FactId taken = under_it.held.extract(under_it.held.begin()).value();
    const bool comes_back = kept_.holder_of(taken) == lease;
    const auto back_to =
        kept_.tables().find(comes_back ? kept_.held().at(taken).fact.datum.head() : std::string_view());
    spend(left, comes_back ? back_to->second.looks_to_remove() : looks_a_lapse);
    if (comes_back) change.put_back(taken);
  }
  change.finish();
}

void Lapsing::lapse_facts(Time due, std::size_t& left, Time now) {
  TransactionChange change(kept_, "board", now);
  while (left > 0 && !kept_.expiries().empty() && kept_.expiries().begin()->first <= due) {
    const FactId fact = kept_.expiries().begin()->second;
    spend(left, kept_.find(fact)->table->looks_to_remove());
    change.retract(fact);
  }
  change.finish();
}

}  // namespace pizarra::store
