#include "blackboard/cluster/snapshot.hpp"

#include "blackboard/journal/checksum.hpp"
#include "blackboard/store/durable_facts.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "blackboard/wire/wire.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::cluster {

namespace {

constexpr std::size_t part_bytes = 512 << 10;

}  // namespace

Result<SnapshotValue> snapshot_from(const std::string& text) {
  const Result<Datum> form = read_one(text);
  const bool formed = form && form->is_form("snapshot") && form->size() == 5 && (*form)[2].is_string();
  const auto number = formed ? wire::count_at(*form, 1) : std::nullopt;
  const auto parts = formed ? wire::count_at(*form, 3) : std::nullopt;
  if (!number || !parts) {
    return fail("bad-journal", "the log in the cluster is damaged: it does not say which snapshot counts");
  }
  return SnapshotValue{*number, std::string((*form)[2].text()), *parts, (*form)[4].integer()};
}

std::string text_of(const SnapshotValue& snapshot) {
  return write(list("snapshot"_sym, snapshot.number, to_datum(snapshot.name), static_cast<std::int64_t>(snapshot.parts),
                    snapshot.sum));
}

std::string snapshot_text(const store::Store& store, const journal::LineStart& end, const DatedReplies& replies) {
  std::string text;
  const auto add = [&](const Datum& line) {
    write_to(text, line);
    text += '\n';
  };
  for (const auto& [name, table] : store.tables()) add(list("relation"_sym, relation_to_datum(table.relation())));
  for (const auto& [fact, as] : store::durable_facts(store)) {
    add(list("fact"_sym, static_cast<std::int64_t>(as), wire::fact_to_datum(fact)));
  }
  for (const auto& [when, reply] : replies) {
    std::string line;
    journal::ReplyLines().add(line, reply);
    add(list("replied"_sym, when.time_since_epoch().count(), to_datum(line)));
  }
  add(list("end"_sym, end.revision, end.when.time_since_epoch().count(), store.next_fact()));
  return text;
}

Result<SnapshotValue> put_snapshot(KeyValues& key_values, const LogKeys& keys, std::uint64_t number,
                                   const std::string& name, const std::string& text) {
  SnapshotValue snapshot{number, name, 0, journal::Checksum().add_words(text).value()};
  for (std::size_t at = 0; at < text.size(); at += part_bytes) {
    const KeyValue part{keys.snapshot_part(name, snapshot.parts++), text.substr(at, part_bytes)};
    const Result<KeyValues::Reply> put = key_values.transact({.compares = {}, .puts = {part}}, 5 * patience);
    if (!put) return fail(put);
  }
  return snapshot;
}

}  // namespace pizarra::cluster
