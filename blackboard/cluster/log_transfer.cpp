#include "blackboard/cluster/log_transfer.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "blackboard/cluster/followed_log.hpp"
#include "blackboard/cluster/log_format.hpp"
#include "blackboard/cluster/won_epoch.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "blackboard/store/durable_facts.hpp"

namespace pizarra::cluster {

namespace {

// The board that leads, or nothing. A leader writes to `alive` all the time, so one that stands still has gone.
Result<std::optional<std::string>> who_leads(KeyValues& key_values, const LogKeys& keys, const Pause& pause) {
  const Result<std::optional<std::string>> before = get(key_values, keys.alive());
  if (!before) return fail(before);
  if (!*before) return std::optional<std::string>();
  pause(2 * suspects_after);
  const Result<std::optional<std::string>> after = get(key_values, keys.alive());
  if (!after) return fail(after);
  if (*after == *before) return std::optional<std::string>();
  const Result<std::optional<std::string>> epoch_text = get(key_values, keys.epoch());
  if (!epoch_text) return fail(epoch_text);
  const Result<EpochValue> epoch = epoch_from(epoch_text->value_or(""));
  if (!epoch) return fail(epoch);
  return std::optional(epoch->board);
}

// The log as a leader that has left would leave it: the next leader goes on from its counters.
std::vector<KeyValue> begun_log(const LogKeys& keys, const SnapshotValue& snapshot, const store::Store& store,
                                const journal::LineStart& end, std::uint64_t nonce) {
  const EpochValue epoch{1, "copied from a file", nonce};
  const Alive alive{
      .epoch = epoch.number, .when = end.when, .revision = end.revision, .fact = store.next_fact(), .leaves = true};
  return {format_of_this_build(keys),
          {keys.epoch(), text_of(epoch)},
          {keys.alive(), text_of(alive)},
          {keys.head(), std::to_string(snapshot.number)},
          {keys.snapshot(), text_of(snapshot)}};
}

// A group needs at least one line. Declaring relations once more changes nothing.
journal::JournalGroup remembered(FollowedLog& followed, const journal::LineStart& begin) {
  std::vector<Relation> relations;
  for (const auto& [name, table] : followed.store().tables()) relations.push_back(table.relation());
  journal::JournalGroup group;
  group.lines = journal::journal_line(begin.revision, begin.when, "board", relations) + '\n';
  journal::ReplyLines lines;
  for (const journal::RememberedReply& reply : followed.replies()) lines.add(group.replies, reply);
  group.durable = true;
  return group;
}

// Behind all that a board gave out, as the next leader: of what is not durable the log has only the counters.
Result<journal::LineStart> beginning_behind(KeyValues& key_values, const LogKeys& keys, FollowedLog& followed) {
  const Result<std::optional<std::string>> said = get(key_values, keys.alive());
  if (!said) return fail(said);
  if (!*said) return followed.end();
  const Result<Alive> alive = alive_from(**said);
  if (!alive) return fail(alive);
  followed.store().restore_counters(std::max(followed.end().revision, alive->revision), alive->fact);
  return journal::LineStart{followed.store().revision(), std::max(followed.end().when, time_behind(*alive))};
}

Result<void> write_file(const std::string& path, FollowedLog& followed, const journal::LineStart& begin) {
  const Result<std::shared_ptr<journal::JournalFile>> file = journal::JournalFile::open(path, {});
  if (!file) return fail(file);
  const Result<void> begun = (*file)->begin_with(followed.store(), begin);
  return begun ? (*file)->append(remembered(followed, begin)) : begun;
}

}  // namespace

Result<Transferred> file_to_cluster(const std::string& path, KeyValues& key_values, const LogKeys& keys,
                                    std::uint64_t nonce) {
  if (!journal::this_disk().status(path)) return fail("journal-file", "there is no journal " + path);
  const Result<std::optional<std::uint64_t>> head = head_of(key_values, keys);
  if (!head) return fail(head);
  if (*head) return fail("exists", "the cluster has a log of this cell already");
  const Result<std::shared_ptr<journal::JournalFile>> file = journal::JournalFile::open(path, {});
  if (!file) return fail(file);
  store::Store store;
  Result<std::vector<journal::RememberedReply>> replies = (*file)->recover(store);
  if (!replies) return fail(replies);
  const Result<journal::LineStart> end = journal::end_of_journal(path);
  if (!end) return fail(end);
  DatedReplies dated;
  for (journal::RememberedReply& reply : *replies) dated.emplace_back(end->when, std::move(reply));
  constexpr std::uint64_t first = 1;
  const Result<SnapshotValue> snapshot =
      put_snapshot(key_values, keys, first, fmt::format("{}-{}", first, nonce), snapshot_text(store, *end, dated));
  if (!snapshot) return fail(snapshot);
  const Result<KeyValues::Reply> turned =
      key_values.transact({.compares = {{keys.head(), std::nullopt}, {keys.epoch(), std::nullopt}},
                           .puts = begun_log(keys, *snapshot, store, *end, nonce)},
                          5 * patience);
  if (!turned) return fail(turned);
  if (!turned->succeeded) return fail("exists", "a board began a log of this cell meanwhile");
  return Transferred{store::durable_facts(store).size(), end->revision};
}

Result<Transferred> cluster_to_file(KeyValues& key_values, const LogKeys& keys, const std::string& path,
                                    const Pause& pause) {
  if (journal::this_disk().status(path)) return fail("exists", path + " is there already");
  const Result<std::optional<std::uint64_t>> head = head_of(key_values, keys);
  if (!head) return fail(head);
  if (!*head) return fail("bad-journal", "the cluster has no log of this cell");
  const Result<std::optional<std::string>> leader = who_leads(key_values, keys, pause);
  if (!leader) return fail(leader);
  if (*leader) return fail("in-use", "the board " + **leader + " leads this cell: end its boards first");
  FollowedLog followed(key_values, keys);
  const Result<void> whole = followed.follow_to(**head);
  if (!whole) return fail(whole);
  const Result<journal::LineStart> begin = beginning_behind(key_values, keys, followed);
  if (!begin) return fail(begin);
  const Result<void> written = write_file(path, followed, *begin);
  // Half a journal would be taken for a whole one.
  if (!written) journal::remove_journal(path);
  if (!written) return fail(written);
  return Transferred{store::durable_facts(followed.store()).size(), begin->revision};
}

}  // namespace pizarra::cluster
