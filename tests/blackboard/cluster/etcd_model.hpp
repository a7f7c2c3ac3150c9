#pragma once

// A model of etcd as a client meets it on a bad day: transactions that happened without an answer, that happen much
// later, or not at all. The same seed has the same bad day.
//
//   EtcdModel etcd(seed);
//   ModelClient client(etcd);
//   client.transact(...);               // takes some of etcd.now
//   etcd.trouble = 0;                   // a good day

#include <algorithm>
#include <limits>
#include <list>
#include <map>
#include <random>
#include <utility>

#include "blackboard/cluster/key_values.hpp"

namespace pizarra::cluster {

class EtcdModel {
 public:
  explicit EtcdModel(std::uint64_t seed) : random(seed) {}

  bool happens(double share) { return std::uniform_real_distribution<double>()(random) < share; }
  std::uint64_t below(std::uint64_t bound) {
    return std::uniform_int_distribution<std::uint64_t>(0, bound - 1)(random);
  }

  KeyValues::Reply apply(const KeyValues::Transaction& transaction) {
    KeyValues::Reply reply{true, {}};
    for (const KeyValues::Compare& compare : transaction.compares) {
      const auto found = values.find(compare.key);
      const bool same =
          compare.value ? found != values.end() && found->second == *compare.value : found == values.end();
      reply.succeeded = reply.succeeded && same;
      if (found != values.end()) reply.found.push_back({found->first, found->second});
    }
    if (!reply.succeeded) return reply;
    reply.found.clear();
    for (const KeyValues::Range& range : transaction.deletes) {
      if (range.from >= range.to) continue;
      const auto from = values.lower_bound(range.from);
      const auto to = values.lower_bound(range.to);
      std::size_t deleted = 0;
      for (auto at = from; at != to; ++at, ++deleted) former_bytes_ += at->second.size();
      most_deleted = std::max(most_deleted, deleted);
      values.erase(from, to);
    }
    for (const KeyValue& put : transaction.puts) {
      std::string& value = values[put.key];
      former_bytes_ += value.size();
      value = put.value;
      const std::uint64_t in_holes = std::min<std::uint64_t>(holes_, put.value.size());
      holes_ -= in_holes;
      space.taken += put.value.size() - in_holes;
    }
    return reply;
  }
  // Whether it puts none of that: from when it was full on, until that is ended. As etcd, it does not count holes.
  bool refuses(const KeyValues::Transaction& transaction) {
    std::uint64_t bytes = 0;
    for (const KeyValue& put : transaction.puts) bytes += put.value.size();
    space.refuses = space.refuses || space.taken + bytes > space.most;
    return space.refuses && bytes > 0;
  }
  void forget_former() {
    holes_ += std::exchange(former_bytes_, 0);
    ++forgotten;
  }
  void close_holes() { space.taken -= std::exchange(holes_, 0); }

  void let_late_ones_come() {
    for (auto late = late_.begin(); late != late_.end();) {
      if (!happens(0.2)) {
        ++late;
        continue;
      }
      if (!refuses(*late)) apply(*late);
      late = late_.erase(late);
    }
  }
  void be_late_with(const KeyValues::Transaction& transaction) { late_.push_back(transaction); }

  std::mt19937_64 random;
  std::map<std::string, std::string> values;
  Time now{};
  double trouble = 0.15;
  std::size_t bytes_in_time = std::numeric_limits<std::size_t>::max();  // of an answer, over its line
  KeyValues::Space space{.most = std::uint64_t{2} << 30};
  std::size_t walked = 0;        // over keys of ranges, those too that were more than asked for
  std::size_t most_deleted = 0;  // at once
  bool forgets = true;
  int forgotten = 0;  // how often

 private:
  std::uint64_t former_bytes_ = 0;
  std::uint64_t holes_ = 0;
  std::list<KeyValues::Transaction> late_;
};

class ModelClient : public KeyValues {
 public:
  explicit ModelClient(EtcdModel& etcd) : etcd_(etcd) {}

  Result<Reply> transact(const Transaction& transaction, Duration wait) override {
    etcd_.let_late_ones_come();
    if (cut) return lost(wait);
    if (etcd_.refuses(transaction)) return fail("unavailable", "no space", Datum::symbol(no_space));
    if (!etcd_.happens(etcd_.trouble)) {
      etcd_.now += Duration(500 + etcd_.below(4000));
      return etcd_.apply(transaction);
    }
    const std::uint64_t fate = etcd_.below(3);
    if (fate == 0) etcd_.apply(transaction);
    if (fate == 1) etcd_.be_late_with(transaction);
    return lost(wait);
  }
  Result<std::vector<KeyValue>> range(const Range& range, std::size_t most, Duration wait) override {
    etcd_.let_late_ones_come();
    if (cut || etcd_.happens(etcd_.trouble)) return lost(wait);
    etcd_.now += Duration(300 + etcd_.below(2000));
    std::size_t bytes = 0;
    std::vector<KeyValue> found;
    for (auto at = etcd_.values.lower_bound(range.from); at != etcd_.values.end() && at->first < range.to; ++at) {
      ++etcd_.walked;
      if (found.size() == most) continue;
      found.push_back({at->first, at->second});
      bytes += at->second.size();
    }
    if (bytes > etcd_.bytes_in_time) return lost(wait);
    return found;
  }
  Result<Space> space(Duration wait) override {
    if (cut || etcd_.happens(etcd_.trouble)) return lost(wait);
    return etcd_.space;
  }
  Result<void> forget_former(Duration wait) override {
    if (cut || !etcd_.forgets || etcd_.happens(etcd_.trouble)) return lost(wait);
    etcd_.forget_former();
    return {};
  }
  Result<void> close_holes(Duration wait) override {
    if (cut) return lost(wait);
    etcd_.close_holes();
    return {};
  }
  Result<void> end_refusing(Duration wait) override {
    if (cut) return lost(wait);
    etcd_.space.refuses = false;
    return {};
  }
  bool cut = false;

 private:
  std::unexpected<Failure> lost(Duration wait) {
    etcd_.now += wait;
    return fail("unavailable", "no answer");
  }
  EtcdModel& etcd_;
};

}  // namespace pizarra::cluster
