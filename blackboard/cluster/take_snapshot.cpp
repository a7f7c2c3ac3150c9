#include "blackboard/cluster/take_snapshot.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "blackboard/cluster/followed_log.hpp"
#include "blackboard/cluster/snapshot.hpp"

namespace pizarra::cluster {

namespace {

// Etcd does nothing else while it deletes. Some may be left from when this failed.
Result<void> delete_entries(KeyValues& key_values, const LogKeys& keys, std::uint64_t from, std::uint64_t to) {
  constexpr std::uint64_t at_once = 1000;
  for (std::uint64_t first = 0; first < to;) {
    const std::uint64_t end = std::min(std::max(first, from) + at_once, to);
    const Result<KeyValues::Reply> gone =
        key_values.transact({.compares = {}, .deletes = {keys.entries(first, end)}}, 5 * patience);
    if (!gone) return fail(gone);
    first = end;
  }
  return {};
}

}  // namespace

Result<std::size_t> take_snapshot(KeyValues& key_values, const LogKeys& keys, std::uint64_t nonce) {
  const Result<std::optional<std::string>> former = get(key_values, keys.snapshot());
  if (!former) return fail(former);
  const Result<std::optional<std::uint64_t>> head = head_of(key_values, keys);
  if (!head) return fail(head);
  std::uint64_t before = 0;
  if (*former) {
    const Result<SnapshotValue> snapshot = snapshot_from(**former);
    if (!snapshot) return fail(snapshot);
    before = snapshot->number;
  }
  const std::uint64_t newest = head->value_or(0);
  if (newest == before) return 0;
  FollowedLog followed(key_values, keys);
  const Result<void> whole = followed.follow_to(newest);
  if (!whole) return fail(whole);
  const std::string text = followed.text();
  const std::string name = fmt::format("{}-{}", followed.number(), nonce);
  const Result<SnapshotValue> put = put_snapshot(key_values, keys, followed.number(), name, text);
  if (!put) return fail(put);
  const Result<KeyValues::Reply> turned = key_values.transact({.compares = {{keys.snapshot(), *former}},
                                                               .puts = {{keys.snapshot(), text_of(*put)}},
                                                               .deletes = keys.snapshots_but(name)},
                                                              5 * patience);
  if (!turned) return fail(turned);
  if (!turned->succeeded) return 0;
  // The newest entry stays, so that who has fewer sees the gap before it.
  const Result<void> deleted = delete_entries(key_values, keys, before, followed.number());
  if (!deleted) return fail(deleted);
  return text.size();
}

}  // namespace pizarra::cluster
