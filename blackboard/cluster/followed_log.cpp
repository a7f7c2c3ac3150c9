#include "blackboard/cluster/followed_log.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "blackboard/cluster/log_format.hpp"
#include "blackboard/cluster/snapshot.hpp"
#include "blackboard/journal/checksum.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "lisp/reader.hpp"

namespace pizarra::cluster {

namespace {

constexpr std::size_t most_replies = 100'000;
constexpr ReadLimits line_limits = {
    .bytes = 2 * limits::frame_bytes, .depth = limits::frame_depth, .elements = 2 * limits::frame_elements};

std::unexpected<Failure> damaged(const std::string& what) {
  return fail("bad-journal", "the log in the cluster is damaged: " + what);
}

}  // namespace

// What another version wrote may look damaged.
Result<std::size_t> FollowedLog::follow() {
  const Result<std::size_t> came = follow_some();
  const bool looks_damaged = !came && came.error().symbol == "bad-journal";
  const Result<void> readable = looks_damaged ? check_format(key_values_, keys_) : Result<void>();
  return readable ? came : fail(readable);
}

Result<std::size_t> FollowedLog::follow_some() {
  while (true) {
    const Result<void> begun = store_ == nullptr ? begin() : Result<void>();
    if (!begun) return fail(begun);
    const std::size_t asked = at_once_;
    const Result<std::vector<KeyValue>> came = next_entries();
    if (!came) return fail(came);
    const Result<std::size_t> entries = take(*came);
    if (!entries) return fail(entries);
    if (store_ == nullptr) continue;
    is_behind_ = is_behind_ || *entries >= asked;
    return entries;
  }
}

// How many entries came. It has no store after a gap that a newer snapshot filled.
Result<std::size_t> FollowedLog::take(const std::vector<KeyValue>& values) {
  std::size_t entries = 0;
  for (const KeyValue& value : values) {
    if (value.key == keys_.alive()) {
      const Result<void> understood = heard(value.value);
      if (!understood) return fail(understood);
      continue;
    }
    const Result<Entry> entry = entry_from(value.value);
    if (!entry) return fail(entry);
    if (entry->number != number_ + 1) {
      const Result<void> filled = check_gap();
      if (!filled) return fail(filled);
      store_ = nullptr;
      return 0;
    }
    const Result<void> applied = apply(*entry);
    if (!applied) return fail(applied);
    ++weight_.entries;
    weight_.bytes += value.value.size();
    ++entries;
  }
  return entries;
}

// A newer snapshot stands in place of the entries between. Entries are deleted only after it counts.
Result<void> FollowedLog::check_gap() {
  const Result<std::optional<std::string>> pointer = get(key_values_, keys_.snapshot());
  if (!pointer) return fail(pointer);
  if (*pointer == begun_from_) return damaged(fmt::format("entry {} is missing", number_ + 1));
  return {};
}

// Another leader may write another format.
Result<void> FollowedLog::heard(const std::string& text) {
  const Result<Alive> alive = alive_from(text);
  if (!alive) return fail(alive);
  const bool is_of_another = !alive_ || alive_->epoch != alive->epoch;
  const Result<void> readable = is_of_another ? check_format(key_values_, keys_) : Result<void>();
  if (readable) alive_ = *alive;
  return readable;
}

// Etcd walks over every key of a range, however few it is asked for. So a range has an end where many may come.
Result<std::vector<KeyValue>> FollowedLog::next_entries() {
  const std::uint64_t next = number_ + 1;
  if (!is_behind_) return some_of(keys_.entries_and_alive(next));
  const std::size_t asked = at_once_;
  Result<std::vector<KeyValue>> came = some_of(keys_.entries(next, next + asked));
  const bool may_be_more = !came || came->size() == asked;
  if (may_be_more) return came;
  const Result<std::vector<KeyValue>> rest = some_of(keys_.entries_and_alive(next + came->size()));
  if (!rest) return fail(rest);
  is_behind_ = false;
  came->insert(came->end(), rest->begin(), rest->end());
  return came;
}

Result<std::vector<KeyValue>> FollowedLog::some_of(const KeyValues::Range& range) {
  Result<std::vector<KeyValue>> came = key_values_.range(range, at_once_, patience);
  at_once_ = came ? std::min(at_once_ + 1, most_at_once) : std::max(at_once_ / 2, least_at_once);
  return came;
}

Result<void> FollowedLog::follow_to(std::uint64_t number) {
  while (store_ == nullptr || number_ < number) {
    const std::size_t asked = at_once_;
    const Result<std::size_t> came = follow();
    const bool asks_for_fewer = !came && at_once_ < asked;
    if (asks_for_fewer) continue;
    if (!came) return fail(came);
    if (*came == 0 && number_ < number) return damaged(fmt::format("entry {} is missing", number_ + 1));
  }
  return {};
}

Result<void> FollowedLog::begin() {
  if (into_ != nullptr && begun_ > 0) return fail("unavailable", "a snapshot took the log's place while it was read");
  own_ = into_ == nullptr ? std::make_unique<store::Store>() : nullptr;
  store_ = into_ == nullptr ? own_.get() : into_;
  number_ = 0;
  is_behind_ = true;
  end_ = {};
  later_.clear();
  replies_.clear();
  weight_ = {};
  const Result<void> readable = check_format(key_values_, keys_);
  const Result<void> restored = readable ? restore_snapshot() : readable;
  if (!restored) store_ = nullptr;
  // A read that was not answered has changed nothing in the store.
  if (restored || restored.error().symbol != "unavailable") ++begun_;
  return restored;
}

Result<void> FollowedLog::restore_snapshot() {
  const Result<std::optional<std::string>> pointer = get(key_values_, keys_.snapshot());
  if (!pointer) return fail(pointer);
  begun_from_ = *pointer;
  if (!*pointer) return {};
  const Result<SnapshotValue> snapshot = snapshot_from(**pointer);
  if (!snapshot) return fail(snapshot);
  std::string text;
  for (std::size_t part = 0; part < snapshot->parts; ++part) {
    const Result<std::optional<std::string>> value = get(key_values_, keys_.snapshot_part(snapshot->name, part));
    if (!value) return fail(value);
    if (!*value) return part_is_missing(**pointer);
    text += **value;
  }
  if (journal::Checksum().add_words(text).value() != snapshot->sum)
    return damaged("a snapshot's checksum does not fit");
  number_ = snapshot->number;
  weight_.snapshot_bytes = text.size();
  return restore(text);
}

// Another snapshot took its place meanwhile, which the next attempt finds.
Result<void> FollowedLog::part_is_missing(const std::string& snapshot) {
  const Result<std::optional<std::string>> pointer = get(key_values_, keys_.snapshot());
  if (!pointer) return fail(pointer);
  if (*pointer == snapshot) return damaged("a part of the snapshot is missing");
  return fail("unavailable", "the snapshot went while it was read");
}

Result<void> FollowedLog::restore(const std::string& text) {
  std::string_view rest = text;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    const Result<Datum> line = read_one(rest.substr(0, end), line_limits, "snapshot");
    if (!line) return fail(line);
    const Result<void> restored = restore_line(*line);
    if (!restored) return restored;
    rest.remove_prefix(end + 1);
  }
  return {};
}

Result<void> FollowedLog::restore_line(const Datum& line) {
  if (line.is_form("relation") && line.size() == 2) {
    Result<Relation> relation = relation_from_datum(line[1]);
    if (!relation) return fail(relation);
    const auto declared = store_->declare({std::move(*relation)});
    return declared ? Result<void>() : fail(declared);
  }
  if (line.is_form("fact") && line.size() == 3 && line[1].is_integer()) {
    Result<Fact> fact = wire::fact_from_datum(line[2]);
    if (!fact) return fail(fact);
    return store_->restore(std::move(*fact), static_cast<store::Restored>(line[1].integer()));
  }
  if (line.is_form("replied") && line.size() == 3 && line[1].is_integer()) {
    auto replies = journal::replies_from(std::string(line[2].text()));
    if (!replies) return damaged("a remembered reply");
    remember(Time(Duration(line[1].integer())), std::move(*replies));
    return {};
  }
  if (!line.is_form("end") || line.size() != 4) return damaged("a line of a snapshot");
  end_ = {wire::count_at(line, 1).value_or(0), Time(Duration(line[2].integer()))};
  store_->restore_counters(end_.revision, wire::count_at(line, 3).value_or(1));
  if (journal::is_beyond(end_, until_)) {
    return fail("forgotten", fmt::format("the log goes back to revision {} only", end_.revision),
                to_datum(end_.revision));
  }
  return {};
}

Result<void> FollowedLog::apply(const Entry& entry) {
  number_ = entry.number;
  if (!later_.empty()) {
    later_ += entry.group.lines;
    return {};
  }
  const Result<std::string_view> rest = journal::replay(entry.group.lines, *store_, until_);
  if (!rest) return damaged(fmt::format("entry {}: {}", entry.number, rest.error().sentence));
  later_ = *rest;
  const std::string_view played =
      std::string_view(entry.group.lines).substr(0, entry.group.lines.size() - rest->size());
  if (!played.empty()) end_ = journal::start_of_last_line(played);
  auto replies = journal::replies_from(entry.group.replies);
  if (!replies) return damaged(fmt::format("entry {}: a remembered reply", entry.number));
  remember(end_.when, std::move(*replies));
  return {};
}

void FollowedLog::remember(Time when, std::vector<journal::RememberedReply> replies) {
  for (journal::RememberedReply& reply : replies) replies_.emplace_back(when, std::move(reply));
  while (!replies_.empty() &&
         (replies_.front().first < when - journal::replies_kept || replies_.size() > most_replies)) {
    replies_.pop_front();
  }
}

std::vector<journal::RememberedReply> FollowedLog::replies() const {
  std::vector<journal::RememberedReply> replies;
  for (const auto& [when, reply] : replies_) replies.push_back(reply);
  return replies;
}

std::string FollowedLog::text() const { return snapshot_text(*store_, end_, replies_); }

}  // namespace pizarra::cluster
