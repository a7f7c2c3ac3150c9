#include "blackboard/server/durability.hpp"

#include "blackboard/limits.hpp"
#include "blackboard/server/durable_requests.hpp"

namespace pizarra::server {

bool Durability::concerns(const store::Store& store, const Datum& body) const {
  return journal_ != nullptr && concerns_durable(store, body);
}

Durability::Position Durability::awaited(const store::Store& store, const Datum& body, bool durable) const {
  if (has_all()) return 0;
  if (durable || of_all_) return position();
  // A board whose journal cannot be written answers all the same.
  const bool is_under_way = last_change_ > journal_->kept() && !journal_->stuck();
  const bool shows_change = is_under_way && body.is_form("ask") && body.size() > 1;
  return shows_change && asks_durable(store, body[1]) ? last_change_ : 0;
}

Result<Durability::Before> Durability::begin(const store::Store& store, const Datum& body) const {
  const Before before{concerns(store, body), position()};
  const bool changes = body.is_form("take") || body.is_form("transact") || body.is_form("declare");
  const Result<void> room = changes ? check_room(body, before.durable, 0) : Result<void>();
  if (!room) return fail(room);
  return before;
}

Durability::After Durability::end(const store::Store& store, const Datum& body, const Before& before) {
  const bool changed = before.durable && position() > before.journal_end;
  if (changed) last_change_ = position();
  return {changed, awaited(store, body, before.durable)};
}

Result<void> Durability::check_room(const store::Store& store, const Datum& body,
                                    const Transaction& transaction) const {
  const std::size_t removals = journal_ == nullptr ? 0 : removed_at_most(store, transaction);
  // More than may be looked at is the board's to refuse.
  if (removals == 0 || removals > limits::examined) return {};
  return check_room(body, concerns(store, body), removals);
}

Result<void> Durability::check_room(const Datum& body, bool durable, std::size_t removals) const {
  if (journal_ == nullptr) return {};
  const Change change = change_of(body, durable);
  // Weighing takes its time, and there is room as a rule.
  const std::size_t named = removals * bytes_of_a_removal;
  const Result<void> room = journal_->check_room(change, limits::frame_bytes + said_beside + named);
  return room ? room : journal_->check_room(change, bytes_at_most(body) + named);
}

Durability::Change Durability::change_of(const Datum& body, bool durable) {
  if (!durable) return Change::passing;
  return only_removes(body) ? Change::removing : Change::lasting;
}

}  // namespace pizarra::server
