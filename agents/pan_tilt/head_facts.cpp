#include "agents/pan_tilt/head_facts.hpp"

#include <cmath>

#include "lisp/numbers.hpp"

namespace pizarra::pan_tilt {

namespace {

// A thousandth of a degree is less than any unit's step.
double told_deg(double deg) { return rounded(deg, 1000); }

Datum range_to_datum(const ptu::PanTiltAxisRange& axis) {
  return list(told_deg(axis.low_deg), told_deg(axis.high_deg), axis.resolution_deg, told_deg(axis.top_speed_deg_s));
}

// What retracts a fact, whatever it says.
Datum any_like(const Datum& fact) {
  std::vector<Datum> items(fact.size(), "?"_sym);
  items.front() = fact[0];
  return Datum::list(std::move(items));
}

}  // namespace

void HeadFacts::set_state(std::string_view name, const std::string& trouble) {
  facts_[state].now = list("pan-tilt"_sym, Datum::symbol(name), trouble);
}

void HeadFacts::set_unit(const ptu::PanTiltRange& range) {
  facts_[unit].now = list("pan-tilt-unit"_sym, range_to_datum(range.pan), range_to_datum(range.tilt));
}

void HeadFacts::set_pose(const ptu::PanTiltReading& reading, bool moving) {
  const Datum moves = moving ? "moving"_sym : "still"_sym;
  facts_[pose].now = list("head"_sym, told_deg(reading.pan_deg), told_deg(reading.tilt_deg), moves);
}

void HeadFacts::set_target(const std::optional<std::string>& name) {
  facts_[target].now.reset();
  if (name) facts_[target].now = list("looking-at"_sym, Datum::symbol(*name));
}

Task<Result<void>> HeadFacts::tell() {
  const LeaseId presence = service_.presence();
  if (presence != told_under_) {
    // A board that began anew, or let the presence lapse, knows nothing of what was told before.
    for (Told& fact : facts_) fact.told.reset();
  }
  const std::array<Told, kinds> sent = facts_;
  Transaction changes;
  for (const Told& fact : sent) {
    if (fact.now == fact.told) continue;
    if (fact.now) changes.tell(*fact.now, {}, presence);
    if (!fact.now) changes.retract(any_like(*fact.told));
  }
  if (changes.steps.empty()) co_return Result<void>();
  const Result<Revision> told = co_await context_.board.transact(std::move(changes));
  if (!told) co_return fail(told);
  told_under_ = presence;
  for (std::size_t kind = 0; kind < kinds; ++kind) facts_[kind].told = sent[kind].now;
  co_return Result<void>();
}

}  // namespace pizarra::pan_tilt
