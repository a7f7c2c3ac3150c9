#include "blackboard/cluster/won_epoch.hpp"

#include <algorithm>

#include "blackboard/cluster/log_format.hpp"

namespace pizarra::cluster {

namespace {

std::unexpected<Failure> deposed(const std::string& by) {
  return fail("deposed", "another board leads the cell now: " + by);
}

}  // namespace

Time time_behind(const Alive& said) { return said.leaves ? said.when : said.when + answers_for; }

Result<std::optional<WonEpoch>> WonEpoch::campaign(KeyValues& key_values, const LogKeys& keys,
                                                   const std::optional<Alive>& seen, const std::string& board,
                                                   std::uint64_t nonce) {
  const Result<std::optional<std::string>> standing = get(key_values, keys.epoch());
  if (!standing) return fail(standing);
  EpochValue mine{1, board, nonce};
  if (*standing) {
    const Result<EpochValue> former = epoch_from(**standing);
    if (!former) return fail(former);
    // The transaction of which the answer was lost has happened.
    if (former->nonce == nonce) return found(key_values, keys, nonce);
    if (!seen || seen->epoch != former->number) return std::optional<WonEpoch>();
    mine.number = former->number + 1;
  }
  Alive alive{.epoch = mine.number};
  if (seen) alive = {mine.number, 0, seen->when, seen->revision, seen->fact};
  alive.revision += reserve;
  alive.fact += reserve;
  KeyValues::Transaction taking{
      .compares = {{keys.epoch(), *standing}, {keys.alive(), seen ? std::optional(text_of(*seen)) : std::nullopt}},
      .puts = {{keys.epoch(), text_of(mine)}, {keys.alive(), text_of(alive)}, format_of_this_build(keys)}};
  if (!*standing) taking.puts.push_back({keys.head(), "0"});
  const Result<KeyValues::Reply> taken = key_values.transact(taking, patience);
  if (!taken) return fail(taken);
  if (!taken->succeeded) return std::optional<WonEpoch>();
  return std::optional(WonEpoch(keys, mine, alive));
}

Result<std::optional<WonEpoch>> WonEpoch::found(KeyValues& key_values, const LogKeys& keys, std::uint64_t nonce) {
  const Result<std::optional<std::string>> epoch_text = get(key_values, keys.epoch());
  if (!epoch_text) return fail(epoch_text);
  const Result<std::optional<std::string>> alive_text = get(key_values, keys.alive());
  if (!alive_text) return fail(alive_text);
  if (!*epoch_text || !*alive_text) return std::optional<WonEpoch>();
  const Result<EpochValue> epoch = epoch_from(**epoch_text);
  if (!epoch) return fail(epoch);
  const Result<Alive> alive = alive_from(**alive_text);
  if (!alive) return fail(alive);
  if (epoch->nonce != nonce || alive->epoch != epoch->number) return std::optional<WonEpoch>();
  return std::optional(WonEpoch(keys, *epoch, *alive));
}

Result<Revision> WonEpoch::confirm(KeyValues& key_values, Time now, Revision revision, FactId fact, Duration wait) {
  const Alive alive{.epoch = epoch_.number,
                    .count = alive_.count + 1,
                    .when = now,
                    .revision = std::max(alive_.revision, revision + reserve),
                    .fact = std::max(alive_.fact, fact + reserve)};
  const Result<void> said = say(key_values, alive, wait);
  if (!said) return fail(said);
  return alive_.revision;
}

Result<void> WonEpoch::resign(KeyValues& key_values, Time now) {
  Alive alive = alive_;
  ++alive.count;
  alive.when = now;
  alive.leaves = true;
  return say(key_values, alive, patience);
}

// Compared with what it said before, so that one that comes late does not take back what came after it.
Result<void> WonEpoch::say(KeyValues& key_values, const Alive& alive, Duration wait) {
  const Result<KeyValues::Reply> said =
      key_values.transact({.compares = {{keys_.epoch(), text_of(epoch_)}, {keys_.alive(), text_of(alive_)}},
                           .puts = {{keys_.alive(), text_of(alive)}}},
                          wait);
  if (!said) return fail(said);
  if (said->succeeded) {
    alive_ = alive;
    return {};
  }
  for (const KeyValue& value : said->found) {
    if (value.key == keys_.epoch() && value.value != text_of(epoch_)) return deposed(value.value);
    const Result<Alive> own = value.key == keys_.alive() ? alive_from(value.value) : fail("none", "");
    if (own && own->epoch == epoch_.number) alive_ = *own;
  }
  return fail("unavailable", "a sign of life that had seemed lost was written after all");
}

}  // namespace pizarra::cluster
