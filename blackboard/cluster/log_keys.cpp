#include "blackboard/cluster/log_keys.hpp"

#include <charconv>
#include <fmt/format.h>

#include "blackboard/journal/checksum.hpp"
#include "blackboard/wire/wire.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::cluster {

namespace {

std::unexpected<Failure> damaged(const char* what) {
  return fail("bad-journal", fmt::format("{} of the log in the cluster is not what a board writes", what));
}

std::int64_t sum_of(std::uint64_t number, std::string_view lines, std::string_view replies) {
  return journal::Checksum().add(number).add(lines.size()).add_words(lines).add_words(replies).value();
}

std::optional<Datum> form_of(std::string_view text, const char* name, std::size_t size) {
  Result<Datum> read = read_one(text);
  if (!read || !read->is_form(name) || read->size() != size) return std::nullopt;
  return std::move(*read);
}

}  // namespace

std::string LogKeys::entry(std::uint64_t number) const { return fmt::format("{}log/{:020}", base_, number); }

std::string LogKeys::snapshot_part(const std::string& name, std::size_t part) const {
  return fmt::format("{}snapshots/{}/{:06}", base_, name, part);
}

KeyValues::Range LogKeys::parts_of(const std::string& name) const {
  return {base_ + "snapshots/" + name + "/", base_ + "snapshots/" + name + "0"};
}

std::vector<KeyValues::Range> LogKeys::snapshots_but(const std::string& name) const {
  const KeyValues::Range kept = parts_of(name);
  return {{base_ + "snapshots/", kept.from}, {kept.to, base_ + "snapshots0"}};
}

std::string text_of(const EpochValue& epoch) {
  return write(list("epoch"_sym, epoch.number, to_datum(epoch.board), epoch.nonce));
}

Result<EpochValue> epoch_from(const std::string& text) {
  const std::optional<Datum> form = form_of(text, "epoch", 4);
  const auto number = form ? wire::count_at(*form, 1) : std::nullopt;
  const auto nonce = form ? wire::count_at(*form, 3) : std::nullopt;
  if (!number || !nonce || !(*form)[2].is_string()) return damaged("the epoch");
  return EpochValue{*number, std::string((*form)[2].text()), *nonce};
}

std::string text_of(const Alive& alive) {
  return write(list("alive"_sym, alive.epoch, alive.count, alive.when.time_since_epoch().count(), alive.revision,
                    alive.fact, alive.leaves ? "yes"_sym : "no"_sym));
}

Result<Alive> alive_from(const std::string& text) {
  const std::optional<Datum> form = form_of(text, "alive", 7);
  if (!form) return damaged("the leader's sign of life");
  std::array<std::uint64_t, 5> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = wire::count_at(*form, i + 1);
    if (!number) return damaged("the leader's sign of life");
    numbers[i] = *number;
  }
  const Time when{Duration(static_cast<Duration::rep>(numbers[2]))};
  return Alive{numbers[0], numbers[1], when, numbers[3], numbers[4], (*form)[6].is_symbol("yes")};
}

Result<std::optional<std::uint64_t>> head_of(KeyValues& key_values, const LogKeys& keys) {
  const Result<std::optional<std::string>> text = get(key_values, keys.head());
  if (!text) return fail(text);
  if (!*text) return std::optional<std::uint64_t>();
  std::uint64_t head = 0;
  const char* const end = (*text)->data() + (*text)->size();
  const auto read = std::from_chars((*text)->data(), end, head);
  if (read.ec != std::errc() || read.ptr != end) return damaged("the head");
  return std::optional(head);
}

std::string text_of(std::uint64_t number, std::uint64_t epoch, const journal::JournalGroup& group) {
  const std::int64_t sum = sum_of(number, group.lines, group.replies);
  return fmt::format("(entry {} {} {} {})\n{}{}", number, epoch, sum, group.lines.size(), group.lines, group.replies);
}

Result<Entry> entry_from(const std::string& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string::npos) return damaged("an entry");
  const std::optional<Datum> form = form_of(std::string_view(text).substr(0, end), "entry", 5);
  if (!form) return damaged("an entry");
  const std::uint64_t number = wire::count_at(*form, 1).value_or(0);
  const std::uint64_t size = wire::count_at(*form, 4).value_or(text.size());
  if (number == 0 || size > text.size() - end - 1) return damaged("an entry");
  Entry entry{
      number, wire::count_at(*form, 2).value_or(0), {text.substr(end + 1, size), text.substr(end + 1 + size), true}};
  if (sum_of(number, entry.group.lines, entry.group.replies) != (*form)[3].integer()) return damaged("an entry");
  return entry;
}

}  // namespace pizarra::cluster
