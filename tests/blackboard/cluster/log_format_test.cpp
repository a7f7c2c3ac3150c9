// Logs of the version before are read and taken over. Boards of an older version end where a newer one leads.

#include "blackboard/cluster/log_format.hpp"

#include <gtest/gtest.h>

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/log_transfer.hpp"
#include "blackboard/cluster/standby.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "tests/blackboard/cluster/etcd_model.hpp"
#include "tests/scratch.hpp"

namespace pizarra::cluster {
namespace {

class LogFormats : public testing::Test {
 protected:
  LogFormats() {
    etcd_.trouble = 0;
    leads({1, "a", 1});
    etcd_.values[keys_.head()] = "0";
  }
  void leads(const EpochValue& epoch) {
    etcd_.values[keys_.epoch()] = text_of(epoch);
    etcd_.values[keys_.alive()] = text_of(Alive{.epoch = epoch.number});
  }
  void write_entry() {
    ClusterLog log(client_, client_, keys_, {1, "a", 1}, 0, "etcd://model/cell");
    ASSERT_TRUE(log.append({"(0 1 \"b\" (declare))\n", "", true}, true));
  }
  // Whether one that stands by leads once nobody else seems to.
  Result<bool> take_over(Standby& standby) {
    const auto now = [this] { return etcd_.now; };
    const Result<bool> followed = standby.step(now);
    etcd_.now += suspects_after;
    return followed ? standby.step(now) : followed;
  }
  Result<bool> take_over() {
    Standby standby(*client_, keys_, "b", 7, etcd_.now);
    return take_over(standby);
  }

  const LogKeys keys_{"cell"};
  const std::string own_ = std::to_string(log_format);
  const std::string one_newer_ = std::to_string(log_format + 1);
  EtcdModel etcd_{1};
  std::shared_ptr<ModelClient> client_ = std::make_shared<ModelClient>(etcd_);
};

TEST_F(LogFormats, OfTheVersionBeforeAreReadAndThenWrittenInTheOwn) {
  write_entry();
  for (const char* former : {"", "1"}) {
    leads({1, "a", 1});
    etcd_.values.erase(keys_.format());
    if (*former != '\0') etcd_.values[keys_.format()] = former;
    EXPECT_TRUE(take_over().value()) << "format " << former;
    EXPECT_EQ(etcd_.values[keys_.format()], own_);
    FollowedLog followed(*client_, keys_);
    EXPECT_TRUE(followed.follow_to(1));
  }
}

TEST_F(LogFormats, OfOtherVersionsAreRefusedWithASentenceAndLeftAsTheyAre) {
  static_assert(log_format == 2, "a log that does not say its format is of the first, which is no neighbour any more");
  for (const std::string& other : {one_newer_, std::string("0"), std::string("x")}) {
    etcd_.values[keys_.format()] = other;
    const auto before = etcd_.values;
    const Result<bool> leads = take_over();
    ASSERT_FALSE(leads);
    EXPECT_EQ(leads.error().symbol, "other-format");
    EXPECT_EQ(leads.error().sentence, "the log in the cluster is of format " + other +
                                          ", and this build reads formats 1 and 2: bring this host to the version that "
                                          "wrote the log");
    const std::string file = scratch_folder() + "other-format.journal";
    EXPECT_EQ(cluster_to_file(*client_, keys_, file, [](Duration) {}).error().symbol, "other-format");
    EXPECT_EQ(etcd_.values, before);
  }
}

TEST_F(LogFormats, MayBecomeNewerWhileABoardFollows) {
  etcd_.values[keys_.format()] = own_;
  Standby standby(*client_, keys_, "b", 7, etcd_.now);
  const auto now = [this] { return etcd_.now; };
  EXPECT_FALSE(standby.step(now).value());
  leads({2, "newer", 2});
  etcd_.values[keys_.format()] = one_newer_;
  EXPECT_EQ(take_over(standby).error().symbol, "other-format") << "before it could take the lead";
  EXPECT_EQ(epoch_from(etcd_.values[keys_.epoch()])->board, "newer");
}

TEST_F(LogFormats, ThatAreNewerAreNotCalledDamaged) {
  write_entry();
  etcd_.values[keys_.format()] = own_;
  FollowedLog followed(*client_, keys_);
  ASSERT_TRUE(followed.follow_to(1));
  etcd_.values[keys_.entry(2)] = "as nobody can write it yet";
  EXPECT_EQ(followed.follow().error().symbol, "bad-journal");
  etcd_.values[keys_.format()] = one_newer_;
  EXPECT_EQ(followed.follow().error().symbol, "other-format");
}

TEST_F(LogFormats, AreSaidByALogThatWasCopiedFromAFile) {
  const std::string file = scratch_folder() + "to-copy.journal";
  journal::remove_journal(file);
  store::Store store;
  ASSERT_TRUE(journal::JournalFile::open(file, {}).value()->begin_with(store, {1, Time(1s)}));
  const LogKeys other("other");
  const Result<Transferred> copied = file_to_cluster(file, *client_, other, 1);
  ASSERT_TRUE(copied) << describe(copied.error());
  EXPECT_EQ(etcd_.values[other.format()], own_);
}

}  // namespace
}  // namespace pizarra::cluster
