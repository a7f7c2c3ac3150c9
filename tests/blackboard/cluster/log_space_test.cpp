// A log stays within a part of what its store may take, and a store that was full takes new things again.

#include <gtest/gtest.h>
#include <set>

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/log_upkeep.hpp"
#include "blackboard/cluster/standby.hpp"
#include "lisp/reader.hpp"
#include "tests/blackboard/cluster/etcd_model.hpp"

namespace pizarra::cluster {
namespace {

const LogKeys small_cell("small");
constexpr std::uint64_t small = 16 << 20;

class LogSpaces : public testing::Test {
 protected:
  LogSpaces() {
    etcd_.trouble = 0;
    etcd_.space.most = small;
    etcd_.values[small_cell.epoch()] = text_of(epoch_);
    etcd_.values[small_cell.head()] = "0";
    (void)store_.declare({picture_});
    pending_.lines = journal::journal_line(0, Time(1s), "board", {picture_}) + '\n';
    store_.on_commit([this](const store::Commit& commit) { pending_.lines += journal::journal_line(commit) + '\n'; });
    upkeep_ = std::make_unique<LogUpkeep>(client_, small_cell, log_->space());
  }
  // A picture of that number, in place of the former one; as the board, nothing where there is no room.
  bool tell(std::int64_t n, std::size_t bytes) {
    if (log_->room().for_all < bytes) return false;
    Transaction telling;
    telling.tell(list("picture"_sym, n, to_datum(std::string(bytes, 'x')), count_++));
    (void)store_.transact("eyes", telling, etcd_.now);
    return write();
  }
  bool write() {
    const Result<void> written = log_->append(std::exchange(pending_, {}), true);
    EXPECT_TRUE(written) << describe(written.error());
    return written.has_value();
  }
  void keep_up() {
    etcd_.now += upkeep_every;
    const Result<void> kept = upkeep_->step(etcd_.now, ++nonce_);
    EXPECT_TRUE(kept) << describe(kept.error());
  }

  EtcdModel etcd_{1};
  const EpochValue epoch_{1, "a", 1};
  const Relation picture_ =
      relation_from_datum(
          read_one("(relation picture ((n integer) (bytes string) (count integer)) (key n) (durable))").value())
          .value();
  std::shared_ptr<ModelClient> client_ = std::make_shared<ModelClient>(etcd_);
  std::shared_ptr<ClusterLog> log_ =
      std::make_shared<ClusterLog>(client_, client_, small_cell, epoch_, 0, "etcd://model/small");
  std::unique_ptr<LogUpkeep> upkeep_;
  store::Store store_;
  journal::JournalGroup pending_{{}, {}, true};
  std::int64_t count_ = 0;
  std::uint64_t nonce_ = 0;
};

TEST_F(LogSpaces, AreEnoughForLargeFactsThatTakeEachOthersPlace) {
  keep_up();
  for (int n = 0; n < 200; ++n) {
    EXPECT_TRUE(tell(1, 900'000)) << n << ": " << log_->room().lacking;
    keep_up();
  }
  EXPECT_FALSE(etcd_.space.refuses);
  EXPECT_LT(etcd_.space.taken, small / 4 * 3);
  FollowedLog followed(*client_, small_cell);
  EXPECT_TRUE(followed.follow_to(log_->head()));
  EXPECT_LT(followed.weight().all(), small / 4);
}

TEST_F(LogSpaces, AreRefusedInWordsWhereFactsTakeTooMuchAndThereAgainWhenTheyAreGone) {
  keep_up();
  std::int64_t told = 0;
  while (told < 100 && tell(told, 900'000)) {
    ++told;
    keep_up();
  }
  EXPECT_GE(told, 3);
  EXPECT_LE(told, 4);
  EXPECT_TRUE(log_->room().is_scarce);
  EXPECT_TRUE(log_->room().lacking.contains("a quarter of etcd's quota")) << log_->room().lacking;
  EXPECT_GT(log_->room().for_removals, 500'000u);
  (void)store_.transact("eyes", Transaction().retract(read_one("(picture ? ? ?)").value()), etcd_.now);
  EXPECT_TRUE(write());
  keep_up();
  EXPECT_TRUE(tell(7, 900'000)) << log_->room().lacking;
  EXPECT_FALSE(etcd_.space.refuses);
}

TEST_F(LogSpaces, ThatOthersFilledAreFreedOfWhatNobodyNeeds) {
  keep_up();
  EXPECT_TRUE(tell(1, 1000));
  KeyValues::Transaction junk{.compares = {}, .puts = {{"junk", std::string(1 << 20, 'x')}}};
  while (client_->transact(junk, patience)) continue;
  EXPECT_TRUE(etcd_.space.refuses);
  etcd_.now += LogUpkeep::looks_for_space_every;
  keep_up();
  EXPECT_FALSE(etcd_.space.refuses);
  EXPECT_TRUE(tell(1, 1000));
}

TEST_F(LogSpaces, ThatOthersNeedAreSaidToBeFull) {
  keep_up();
  KeyValues::Transaction junk{.compares = {}, .puts = {{"junk", std::string(1 << 20, 'x')}}};
  for (int n = 0; client_->transact(junk, patience); ++n) junk.puts.front().key = "junk" + std::to_string(n);
  const Result<void> made = make_space(*client_);
  ASSERT_FALSE(made);
  EXPECT_TRUE(lacks_space(made.error()));
  EXPECT_TRUE(made.error().sentence.contains("alarm NOSPACE")) << made.error().sentence;
  EXPECT_TRUE(etcd_.space.refuses);
}

TEST_F(LogSpaces, ThatTheirOwnSnapshotFillsAreNotWrittenAnewForEachRetraction) {
  keep_up();
  std::int64_t told = 0;
  for (; tell(told, 20'000); ++told) keep_up();
  ASSERT_GT(told, 50);
  etcd_.space.most = small / 2;
  etcd_.now += LogUpkeep::looks_for_space_every;
  keep_up();
  std::set<std::string> snapshots;
  for (std::int64_t n = 0; n < 40; ++n) {
    (void)store_.transact("eyes", Transaction().retract(list("picture"_sym, n, "?"_sym, "?"_sym)), etcd_.now);
    EXPECT_TRUE(write());
    keep_up();
    snapshots.insert(etcd_.values.at(small_cell.snapshot()));
  }
  EXPECT_LE(snapshots.size(), 5u) << "in 4 s";
  etcd_.now += LogUpkeep::longest_pause;
  keep_up();
  EXPECT_FALSE(snapshots.contains(etcd_.values.at(small_cell.snapshot())));
}

TEST_F(LogSpaces, GrowWithTheQuota) {
  keep_up();
  for (std::int64_t n = 0; tell(n, 900'000); ++n) keep_up();
  ASSERT_EQ(log_->room().for_all, 0u);
  etcd_.space.most = 4 * small;
  etcd_.now += LogUpkeep::looks_for_space_every;
  keep_up();
  EXPECT_GT(log_->room().for_all, 0u);
}

TEST_F(LogSpaces, AreForgottenLaterWhereTheStoreDoesNotForgetAtOnce) {
  keep_up();
  EXPECT_TRUE(tell(1, 900'000));
  EXPECT_TRUE(tell(1, 900'000));
  etcd_.forgets = false;
  etcd_.now += upkeep_every;
  EXPECT_FALSE(upkeep_->step(etcd_.now, ++nonce_));
  EXPECT_EQ(etcd_.forgotten, 0);
  etcd_.forgets = true;
  keep_up();
  EXPECT_EQ(etcd_.forgotten, 1);
  keep_up();
  EXPECT_EQ(etcd_.forgotten, 1);
}

TEST_F(LogSpaces, ThatOthersNeedAreSeenToSeldomByWhoStandsBy) {
  KeyValues::Transaction junk{.compares = {}, .puts = {{"junk", std::string(1 << 20, 'x')}}};
  for (int n = 0; client_->transact(junk, patience); ++n) junk.puts.front().key = "junk" + std::to_string(n);
  const LogKeys other("other");
  Standby standby(*client_, other, "b", 7, etcd_.now);
  const auto now = [this] { return etcd_.now; };
  const Time begun = etcd_.now;
  int steps = 0;
  for (; etcd_.now < begun + 3 * sees_to_space_every; ++steps, etcd_.now += looks_every)
    EXPECT_FALSE(standby.step(now));
  EXPECT_GT(steps, 100);
  EXPECT_EQ(etcd_.forgotten, 3);
}

TEST_F(LogSpaces, AreFreedByWhoStandsByWhereNobodyLeads) {
  KeyValues::Transaction junk{.compares = {}, .puts = {{"junk", std::string(1 << 20, 'x')}}};
  while (client_->transact(junk, patience)) continue;
  const LogKeys other("other");
  Standby standby(*client_, other, "b", 7, etcd_.now);
  const auto now = [this] { return etcd_.now; };
  EXPECT_FALSE(standby.step(now));
  EXPECT_TRUE(standby.step(now).value_or(false));
}

}  // namespace
}  // namespace pizarra::cluster
