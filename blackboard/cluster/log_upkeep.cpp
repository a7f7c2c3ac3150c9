#include "blackboard/cluster/log_upkeep.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "blackboard/cluster/take_snapshot.hpp"

namespace pizarra::cluster {

namespace {

constexpr Duration long_patience = 30 * patience;

bool is_roomy(const KeyValues::Space& space) { return space.taken < space.most / 4 * 3; }

}  // namespace

Result<void> make_space(KeyValues& key_values) {
  Result<KeyValues::Space> space = key_values.space(patience);
  if (!space) return fail(space);
  if (!space->refuses) return {};
  const Result<void> forgotten = key_values.forget_former(long_patience);
  if (!forgotten) return fail(forgotten);
  // A member that gives nothing back now shows that by the space taken.
  if (!is_roomy(*space)) (void)key_values.close_holes(long_patience);
  space = key_values.space(patience);
  if (!space) return fail(space);
  if (is_roomy(*space)) return key_values.end_refusing(patience);
  return fail("unavailable",
              fmt::format("etcd is full and takes nothing (alarm NOSPACE): {} of {} bytes are in use{}, also after "
                          "compaction. Delete what is not this cell's, or give every member a larger "
                          "--quota-backend-bytes",
                          space->taken, space->most, space->member.empty() ? "" : " at the member " + space->member),
              Datum::symbol(no_space));
}

Result<void> LogUpkeep::look_for_space(Time now) {
  const Result<KeyValues::Space> space = key_values_->space(patience);
  if (!space) return fail(space);
  space_->set_most(space->most);
  looks_at_ = now + looks_for_space_every;
  return space->refuses ? make_space(*key_values_) : Result<void>();
}

// Where the store does not forget, the next step tries again.
Result<void> LogUpkeep::forget() {
  const Result<void> forgotten = key_values_->forget_former(long_patience);
  owes_forgetting_ = !forgotten;
  return forgotten;
}

Result<void> LogUpkeep::step(Time now, std::uint64_t nonce) {
  if (now >= looks_at_) {
    const Result<void> looked = look_for_space(now);
    if (!looked) return looked;
  }
  if (owes_forgetting_) return forget();
  const bool is_due = space_->is_snapshot_due() && now >= snapshots_at_;
  if (!is_due) return {};
  const LogWeight before = space_->weight();
  const Result<std::size_t> bytes = take_snapshot(*key_values_, keys_, nonce);
  if (!bytes) return fail(bytes);
  if (*bytes == 0) return {};
  space_->snapshot_taken(before, *bytes);
  pause_where_full(now);
  return forget();
}

// The next one would be as large, and may make no room either.
void LogUpkeep::pause_where_full(Time now) {
  const bool in_vain = std::exchange(was_full_, space_->is_full()) && was_full_;
  pause_ = in_vain ? std::clamp(2 * pause_, first_pause, longest_pause) : Duration::zero();
  snapshots_at_ = now + pause_;
}

}  // namespace pizarra::cluster
