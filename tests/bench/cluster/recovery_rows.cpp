#include "tests/bench/cluster/recovery_rows.hpp"

#include <fmt/format.h>

#include "blackboard/cluster/etcd_client.hpp"
#include "blackboard/cluster/followed_log.hpp"
#include "blackboard/cluster/take_snapshot.hpp"
#include "blackboard/journal/journal.hpp"
#include "lisp/reader.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/stopping.hpp"

namespace pizarra::bench {

namespace {

constexpr std::int64_t facts = 100'000;
constexpr std::uint64_t at_once = 100;  // entries in a transaction of etcd's, of 128 operations at most

// A tell an entry, as where one client tells; each fact is told in place of its former self.
class Entries {
 public:
  explicit Entries(const cluster::LogKeys& keys) : keys_(keys) {
    const std::vector<Relation> relations = {
        relation_from_datum(
            read_one("(relation tally ((n integer) (text string) (count integer)) (key n) (durable))").value())
            .value()};
    (void)store_.declare(relations);
    lines_ = journal::journal_line(0, Time(std::chrono::seconds(1)), "board", relations) + '\n';
    store_.on_commit([this](const store::Commit& commit) { lines_ += journal::journal_line(commit) + '\n'; });
  }
  cluster::KeyValue next() {
    const std::uint64_t number = ++number_;
    const auto count = static_cast<std::int64_t>(number);
    Transaction telling;
    telling.tell(list("tally"_sym, count % facts, "some text of a usual length", count));
    (void)store_.transact("bench", telling, Time(std::chrono::seconds(2)));
    return {keys_.entry(number), cluster::text_of(number, 1, {std::exchange(lines_, {}), {}, true})};
  }
  std::uint64_t number() const { return number_; }

 private:
  const cluster::LogKeys& keys_;
  store::Store store_;
  std::string lines_;
  std::uint64_t number_ = 0;
};

void write_log(cluster::KeyValues& etcd, const cluster::LogKeys& keys, std::uint64_t count) {
  Entries entries(keys);
  while (entries.number() < count) {
    throw_if_stopped();
    cluster::KeyValues::Transaction some;
    while (some.puts.size() < at_once && entries.number() < count) some.puts.push_back(entries.next());
    some.puts.push_back({keys.head(), std::to_string(entries.number())});
    while (!etcd.transact(some, std::chrono::seconds(5))) throw_if_stopped();
  }
}

// As a board does, which asks again where nothing answered in time.
template <class Ask>
auto until_it_answers(Ask ask) {
  constexpr int most_times = 10;
  auto answer = ask();
  for (int times = 1; !answer && times < most_times; ++times) {
    throw_if_stopped();
    answer = ask();
  }
  return answer;
}

std::optional<double> seconds_to_follow(cluster::KeyValues& etcd, const cluster::LogKeys& keys, std::uint64_t count) {
  cluster::FollowedLog followed(etcd, keys);
  Result<void> whole;
  const double seconds = seconds_of([&] { whole = until_it_answers([&] { return followed.follow_to(count); }); });
  return whole ? std::optional(seconds) : std::nullopt;
}

}  // namespace

void say_recovery(Figures& figures, const ClusterCell& cell, std::uint64_t entries) {
  const cluster::LogAddress address = cluster::LogAddress::from(cell.log(), "", true).value();
  const auto etcd = cluster::EtcdClient::open(address).value();
  const cluster::LogKeys keys("recovery");
  write_log(*etcd, keys, entries);
  const std::string note = fmt::format("{} entries, {} facts", entries, std::min<std::uint64_t>(entries, facts));
  figures.say({"recovery without a snapshot", seconds_to_follow(*etcd, keys, entries), "s", {}, {}, note});
  Result<std::size_t> bytes = 0;
  const double taking = seconds_of([&] {
    bytes = until_it_answers([&, nonce = 0]() mutable { return cluster::take_snapshot(*etcd, keys, ++nonce); });
  });
  const bool taken = bytes && *bytes > 0;
  figures.say({"taking a snapshot of it", taken ? std::optional(taking) : std::nullopt, "s", {}, {}, note});
  figures.say({"recovery from the snapshot", seconds_to_follow(*etcd, keys, entries), "s", {}, {}, note});
  (void)etcd->forget_former(std::chrono::seconds(60));
}

}  // namespace pizarra::bench
