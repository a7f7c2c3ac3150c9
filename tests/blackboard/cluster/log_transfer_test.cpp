// A journal that goes from a file to a cluster and back is the same cell's.

#include "blackboard/cluster/log_transfer.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "blackboard/cluster/standby.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "blackboard/store/durable_facts.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/cluster/etcd_model.hpp"
#include "tests/scratch.hpp"

namespace pizarra::cluster {
namespace {

const LogKeys moved_cell("moved");

class Transfer : public testing::Test {
 protected:
  Transfer() {
    etcd_.trouble = 0;
    for (const std::string& path : {first_, second_}) journal::remove_journal(path);
  }
  // A board's life: durable facts that stand, are leased and taken, one that is gone, and one that is not durable.
  void live() {
    const auto file = journal::JournalFile::open(first_, {}).value();
    store::Store store;
    std::string lines;
    store.on_commit([&](const store::Commit& commit) { lines += journal::journal_line(commit) + '\n'; });
    std::vector<Relation> relations;
    for (const char* text :
         {"(relation goal ((n integer) (what datum)) (key n) (durable))", "(relation seen ((n integer)) (key n))"}) {
      relations.push_back(relation_from_datum(read_one(text).value()).value());
    }
    (void)store.declare(relations);
    lines += journal::journal_line(0, Time(1s), "board", relations) + '\n';
    const LeaseId lease = store.lease(60s, Time(1s)).value();
    Transaction telling;
    telling.tell(list("goal"_sym, 1, "a"_sym)).tell(list("goal"_sym, 2, "b"_sym), {1}, lease);
    telling.tell(list("goal"_sym, 3, "c"_sym)).tell(list("goal"_sym, 4, "d"_sym)).tell(list("seen"_sym, 1));
    (void)store.transact("alice", telling, Time(2s));
    (void)store.take("bob", read_one("(goal 3 ?)").value(), lease, Time(3s));
    (void)store.transact("alice", Transaction().retract(read_one("(goal 4 ?)").value()), Time(4s));
    journal::JournalGroup group{lines, {}, true};
    journal::ReplyLines().add(group.replies, {5, "alice", 41, "ok"_sym, ""});
    ASSERT_TRUE(file->append(group).has_value());
  }
  // Everything durable that a journal has, as text, and what is remembered.
  static std::string all_of(const std::string& path) {
    const auto file = journal::JournalFile::open(path, {}).value();
    store::Store store;
    const auto replies = file->recover(store).value();
    std::string all = std::to_string(store.revision()) + " next " + std::to_string(store.next_fact()) + "\n";
    for (const auto& [fact, as] : store::durable_facts(store)) {
      all += std::to_string(static_cast<int>(as)) + " " + write(wire::fact_to_datum(fact)) + "\n";
    }
    for (const journal::RememberedReply& reply : replies) all += "replied " + std::to_string(reply.request) + "\n";
    return all;
  }

  const std::string first_ = scratch_folder() + "first.journal";
  const std::string second_ = scratch_folder() + "second.journal";
  EtcdModel etcd_{1};
  ModelClient client_{etcd_};
  const Pause nobody_leads_ = [](Duration) {};
};

TEST_F(Transfer, FromAFileToAClusterAndBackKeepsFactsCountersAndReplies) {
  live();
  const Result<Transferred> there = file_to_cluster(first_, client_, moved_cell, 7);
  ASSERT_TRUE(there.has_value()) << describe(there.error());
  EXPECT_EQ(there->facts, 3u);
  const Result<Transferred> back = cluster_to_file(client_, moved_cell, second_, nobody_leads_);
  ASSERT_TRUE(back.has_value()) << describe(back.error());
  EXPECT_EQ(back->facts, 3u);
  EXPECT_EQ(back->revision, there->revision);
  const std::string all = all_of(second_);
  EXPECT_EQ(all, all_of(first_));
  EXPECT_TRUE(all.contains("replied 41")) << all;
}

TEST_F(Transfer, IsFollowedByABoardThatLeadsBehindTheFormerCounters) {
  live();
  const Result<Transferred> there = file_to_cluster(first_, client_, moved_cell, 7);
  ASSERT_TRUE(there.has_value());
  Standby standby(client_, moved_cell, "board-pc", 9, etcd_.now);
  const Result<bool> leads = standby.step([this] { return etcd_.now; });
  ASSERT_TRUE(leads.has_value() && *leads);
  EXPECT_EQ(standby.must_wait(etcd_.now), Duration::zero());
  EXPECT_EQ(store::durable_facts(standby.followed().store()).size(), 3u);
  const WonEpoch won = standby.take_epoch();
  EXPECT_GE(won.first_revision(), there->revision);
  EXPECT_GE(won.first_fact(), standby.followed().store().next_fact());
}

TEST_F(Transfer, BackFromAClusterBeginsBehindAllThatItsBoardsGaveOutAlsoWhatIsNotInTheLog) {
  live();
  ASSERT_TRUE(file_to_cluster(first_, client_, moved_cell, 7).has_value());
  Standby standby(client_, moved_cell, "board-pc", 9, etcd_.now);
  ASSERT_TRUE(standby.step([this] { return etcd_.now; }).value_or(false));
  WonEpoch won = standby.take_epoch();
  // Facts that are not durable are not in the log: it has only the counters that the leader says.
  store::Store& led = standby.followed().store();
  led.restore_counters(won.first_revision(), won.first_fact());
  ASSERT_TRUE(led.transact("alice", Transaction().tell(list("seen"_sym, 2)), etcd_.now).has_value());
  const Time last_answer = etcd_.now + 60s;
  ASSERT_TRUE(won.confirm(client_, last_answer, led.revision(), led.next_fact()).has_value());
  const Result<Transferred> back = cluster_to_file(client_, moved_cell, second_, nobody_leads_);
  ASSERT_TRUE(back.has_value()) << describe(back.error());
  const auto file = journal::JournalFile::open(second_, {}).value();
  store::Store store;
  ASSERT_TRUE(file->recover(store).has_value());
  EXPECT_GE(store.revision(), led.revision());
  EXPECT_GE(store.next_fact(), led.next_fact());
  EXPECT_EQ(back->revision, store.revision());
  EXPECT_GE(journal::end_of_journal(second_).value().when, last_answer);
}

TEST_F(Transfer, GoesOverNothingThatIsThere) {
  live();
  ASSERT_TRUE(file_to_cluster(first_, client_, moved_cell, 7).has_value());
  const std::map<std::string, std::string> before = etcd_.values;
  EXPECT_EQ(file_to_cluster(first_, client_, moved_cell, 8).error().symbol, "exists");
  EXPECT_EQ(etcd_.values, before);
  EXPECT_EQ(cluster_to_file(client_, moved_cell, first_, nobody_leads_).error().symbol, "exists");
}

TEST_F(Transfer, FromNothingMakesNothing) {
  EXPECT_EQ(file_to_cluster(first_, client_, moved_cell, 7).error().symbol, "journal-file");
  EXPECT_EQ(cluster_to_file(client_, moved_cell, second_, nobody_leads_).error().symbol, "bad-journal");
  std::ofstream(first_) << "not a journal";
  EXPECT_EQ(file_to_cluster(first_, client_, moved_cell, 7).error().symbol, "bad-journal");
  EXPECT_TRUE(etcd_.values.empty());
  EXPECT_FALSE(std::filesystem::exists(second_));
}

TEST_F(Transfer, LeavesALogThatABoardLeadsAlone) {
  live();
  ASSERT_TRUE(file_to_cluster(first_, client_, moved_cell, 7).has_value());
  Standby standby(client_, moved_cell, "board-pc", 9, etcd_.now);
  ASSERT_TRUE(standby.step([this] { return etcd_.now; }).value_or(false));
  WonEpoch won = standby.take_epoch();
  const Pause it_leads_on = [&](Duration length) {
    etcd_.now += length;
    EXPECT_TRUE(won.confirm(client_, etcd_.now, 1, 1).has_value());
  };
  const Result<Transferred> refused = cluster_to_file(client_, moved_cell, second_, it_leads_on);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().symbol, "in-use");
  EXPECT_TRUE(refused.error().sentence.contains("board-pc")) << refused.error().sentence;
  EXPECT_FALSE(std::filesystem::exists(second_));
  // It has gone without a word.
  EXPECT_TRUE(cluster_to_file(client_, moved_cell, second_, nobody_leads_).has_value());
}

TEST_F(Transfer, LeavesAJournalThatABoardHasAlone) {
  live();
  const auto board = journal::JournalFile::open(first_, {}).value();
  EXPECT_EQ(file_to_cluster(first_, client_, moved_cell, 7).error().symbol, "journal-file");
  EXPECT_TRUE(etcd_.values.empty());
}

}  // namespace
}  // namespace pizarra::cluster
