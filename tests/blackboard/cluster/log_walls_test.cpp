// The walls where a journal is kept, an SQLite file and a log in a cluster: one set of promises for both.

#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <unistd.h>

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/log_transfer.hpp"
#include "blackboard/cluster/standby.hpp"
#include "blackboard/cluster/take_snapshot.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/cluster/etcd_model.hpp"
#include "tests/scratch.hpp"

namespace pizarra::cluster {
namespace {

const LogKeys keys("cell");

// Lives of a log, one after another.
class Wall {
 public:
  virtual ~Wall() = default;
  virtual std::shared_ptr<journal::Log> open() = 0;
  // What compaction does beside a running board.
  virtual void compact() = 0;
};

class FileWall : public Wall {
 public:
  FileWall() { journal::remove_journal(path_); }
  std::shared_ptr<journal::Log> open() override { return journal::JournalFile::open(path_, {.revisions = 0}).value(); }
  void compact() override {
    const auto file = open();
    store::Store store;
    (void)file->recover(store);
    while (file->compact(Time(std::chrono::hours(1))).value_or(0) > 0) {
    }
  }

 private:
  const std::string path_ = scratch_folder() + "wall.journal";
};

class ClusterWall : public Wall {
 public:
  std::shared_ptr<journal::Log> open() override {
    FollowedLog followed(*client_, keys);
    while (followed.follow().value() > 0) {
    }
    epoch_.nonce++;
    epoch_.number++;
    etcd_.values[keys.epoch()] = text_of(epoch_);
    etcd_.values.try_emplace(keys.head(), "0");
    return std::make_shared<ClusterLog>(client_, client_, keys, epoch_, followed.number(), "etcd://model/cell");
  }
  void compact() override { EXPECT_GT(take_snapshot(*client_, keys, ++snapshots_).value(), 0u); }
  EtcdModel& etcd() { return etcd_; }

 private:
  EtcdModel etcd_{1};
  std::shared_ptr<ModelClient> client_ = [this] {
    etcd_.trouble = 0;
    return std::make_shared<ModelClient>(etcd_);
  }();
  EpochValue epoch_{0, "board", 0};
  std::uint64_t snapshots_ = 0;
};

class LogWalls : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (GetParam()) {
      wall_ = std::make_unique<ClusterWall>();
    } else {
      wall_ = std::make_unique<FileWall>();
    }
    begin();
  }
  // Another life of the board.
  void begin() {
    log_.reset();
    log_ = wall_->open();
    store_ = std::make_unique<store::Store>();
    Result<std::vector<journal::RememberedReply>> replies = log_->recover(*store_);
    ASSERT_TRUE(replies.has_value()) << describe(replies.error());
    replies_ = std::move(*replies);
    store_->on_commit([this](const store::Commit& commit) { lines_ += journal::journal_line(commit) + '\n'; });
  }
  void declare() {
    const Relation goal =
        relation_from_datum(read_one("(relation goal ((n integer) (what datum)) (key n) (durable))").value()).value();
    ASSERT_TRUE(store_->declare({goal}).has_value());
    lines_ += journal::journal_line(0, now_, "board", {goal}) + '\n';
  }
  void tell(const std::string& fact, std::uint64_t request = 0) {
    Transaction telling;
    telling.tell(read_one(fact).value());
    now_ += 1ms;
    ASSERT_TRUE(store_->transact("alice", telling, now_).has_value());
    journal::JournalGroup group{std::exchange(lines_, {}), {}, true};
    if (request != 0) journal::ReplyLines().add(group.replies, {5, "alice", request, "ok"_sym, ""});
    const Result<void> written = log_->append(group, true);
    EXPECT_TRUE(written.has_value()) << describe(written.error());
  }
  std::string facts(const store::Store& store) const {
    std::string all;
    const Answers answers = store.ask(query_for(read_one("(goal ?n ?what)").value())).value();
    for (const Answer& answer : answers.answers) {
      const Fact& fact = answer.facts.front();
      all += std::to_string(fact.id) + "@" + std::to_string(fact.revision) + " " + write(fact.datum[2]) + " ";
    }
    return all;
  }

  std::unique_ptr<Wall> wall_;
  std::shared_ptr<journal::Log> log_;
  std::unique_ptr<store::Store> store_;
  std::vector<journal::RememberedReply> replies_;
  std::string lines_;
  Time now_ = Time(1s);
};

TEST_P(LogWalls, HaveWhatWasWrittenInTheNextLifeWithIdsRevisionsAndReplies) {
  declare();
  tell("(goal 1 a)", 41);
  tell("(goal 2 b)", 42);
  tell("(goal 1 c)", 43);
  const std::string before = facts(*store_);
  begin();
  EXPECT_EQ(facts(*store_), before);
  std::vector<std::uint64_t> requests;
  for (const journal::RememberedReply& reply : replies_) requests.push_back(reply.request);
  std::ranges::sort(requests);
  EXPECT_EQ(requests, (std::vector<std::uint64_t>{41, 42, 43}));
  tell("(goal 3 d)");
  begin();
  EXPECT_TRUE(facts(*store_).contains("d"));
}

TEST_P(LogWalls, KeepAllOfItThroughCompaction) {
  declare();
  for (int i = 0; i < 300; ++i) tell("(goal " + std::to_string(i % 7) + " " + std::to_string(i) + ")");
  const std::string before = facts(*store_);
  log_.reset();
  wall_->compact();
  begin();
  EXPECT_EQ(facts(*store_), before);
  tell("(goal 1 last)");
  begin();
  EXPECT_TRUE(facts(*store_).contains("last"));
}

TEST_P(LogWalls, SayHowItWasAndThatTheyForgot) {
  declare();
  tell("(goal 1 a)");
  const Revision first = store_->revision();
  tell("(goal 1 b)");
  store::Store then;
  const Result<journal::PlayedBack> played = log_->read(then, {.revision = first});
  ASSERT_TRUE(played.has_value()) << describe(played.error());
  EXPECT_TRUE(facts(then).contains("a"));
  EXPECT_EQ(played->to.revision, first);
  EXPECT_TRUE(played->later.contains("(goal 1 b)"));
  store::Store never;
  const Result<journal::PlayedBack> beyond = log_->read(never, {.revision = store_->revision() + 1});
  const bool in_cluster = GetParam();
  ASSERT_EQ(beyond.has_value(), in_cluster) << "what is not durable has revisions that this one does not know";
  EXPECT_TRUE(in_cluster ? beyond->lacks.has_value() : beyond.error().symbol == "not-yet");
}

INSTANTIATE_TEST_SUITE_P(Where, LogWalls, testing::Bool(),
                         [](const auto& where) { return std::string(where.param ? "Cluster" : "File"); });

class ClusterLogs : public testing::Test {
 protected:
  ClusterLogs() { etcd_.trouble = 0; }
  static journal::JournalGroup group(int n) { return {"(0 1 \"b\" (declare))\n" + std::string(n, ' '), "", true}; }
  EtcdModel etcd_{1};
  std::shared_ptr<ModelClient> client_ = std::make_shared<ModelClient>(etcd_);
};

TEST_F(ClusterLogs, OfADeposedBoardWriteNothingMore) {
  const EpochValue first{1, "a", 1};
  etcd_.values[keys.epoch()] = text_of(first);
  etcd_.values[keys.head()] = "0";
  ClusterLog log(client_, client_, keys, first, 0, "etcd://model/cell");
  EXPECT_TRUE(log.append(group(0), true));
  etcd_.values[keys.epoch()] = text_of(EpochValue{2, "b", 2});
  EXPECT_EQ(log.append(group(1), true).error().symbol, "deposed");
  EXPECT_EQ(log.append(group(1), true).error().symbol, "deposed");
  EXPECT_EQ(etcd_.values[keys.head()], "1");
}

TEST_F(ClusterLogs, FindOutWhetherAnUnansweredEntryIsThereAndWriteItOnce) {
  const EpochValue epoch{1, "a", 1};
  etcd_.values[keys.epoch()] = text_of(epoch);
  etcd_.values[keys.head()] = "0";
  ClusterLog log(client_, client_, keys, epoch, 0, "etcd://model/cell");
  int unavailable = 0;
  etcd_.trouble = 0.6;
  for (int n = 1; n <= 50; ++n) {
    while (true) {
      const Result<void> written = log.append(group(n), true);
      if (written) break;
      ASSERT_EQ(written.error().symbol, "unavailable");
      ++unavailable;
    }
  }
  EXPECT_GT(unavailable, 20);
  EXPECT_EQ(log.head(), 50u);
  for (std::uint64_t n = 1; n <= 50; ++n) {
    EXPECT_EQ(entry_from(etcd_.values.at(keys.entry(n)))->group.lines, group(static_cast<int>(n)).lines) << n;
  }
}

TEST_F(ClusterLogs, OfLargeEntriesAreReadOverALineThatTakesAFewAtATime) {
  const EpochValue epoch{1, "a", 1};
  etcd_.values[keys.epoch()] = text_of(epoch);
  etcd_.values[keys.head()] = "0";
  ClusterLog log(client_, client_, keys, epoch, 0, "etcd://model/cell");
  const journal::JournalGroup large{"(0 1 \"b\" (declare))" + std::string(1000, ' ') + "\n", "", true};
  for (int n = 1; n <= 300; ++n) ASSERT_TRUE(log.append(large, true));
  etcd_.bytes_in_time = 6000;
  FollowedLog followed(*client_, keys);
  const Result<void> whole = followed.follow_to(300);
  EXPECT_TRUE(whole) << describe(whole.error());
  EXPECT_EQ(followed.number(), 300u);
}

TEST_F(ClusterLogs, AreReadAndCutShortAFewEntriesAtATime) {
  const EpochValue epoch{1, "a", 1};
  etcd_.values[keys.epoch()] = text_of(epoch);
  etcd_.values[keys.head()] = "0";
  ClusterLog log(client_, client_, keys, epoch, 0, "etcd://model/cell");
  constexpr std::uint64_t many = 5000;
  for (std::uint64_t n = 1; n <= many; ++n) ASSERT_TRUE(log.append(group(0), true));
  FollowedLog followed(*client_, keys);
  EXPECT_TRUE(followed.follow_to(many));
  EXPECT_LT(etcd_.walked, 2 * many);
  EXPECT_GT(take_snapshot(*client_, keys, 1).value(), 0u);
  EXPECT_LE(etcd_.most_deleted, many / 5);
  EXPECT_FALSE(etcd_.values.contains(keys.entry(many - 1)));
  EXPECT_TRUE(etcd_.values.contains(keys.entry(many)));
}

TEST_F(ClusterLogs, ThatWereDamagedAreNotBelieved) {
  etcd_.values[keys.epoch()] = text_of(EpochValue{1, "a", 1});
  etcd_.values[keys.head()] = "0";
  ClusterLog log(client_, client_, keys, {1, "a", 1}, 0, "etcd://model/cell");
  ASSERT_TRUE(log.append(group(3), true));
  etcd_.values[keys.entry(1)].back() ^= 1;
  FollowedLog followed(*client_, keys);
  EXPECT_EQ(followed.follow().error().symbol, "bad-journal");
}

TEST_F(ClusterLogs, ThatLackAnEntryAreRefusedByEveryoneWhoReadsThem) {
  const EpochValue epoch{1, "a", 1};
  etcd_.values[keys.epoch()] = text_of(epoch);
  etcd_.values[keys.head()] = "0";
  ClusterLog log(client_, client_, keys, epoch, 0, "etcd://model/cell");
  for (int n = 1; n <= 5; ++n) ASSERT_TRUE(log.append(group(0), true));
  FollowedLog since_before(*client_, keys);
  ASSERT_TRUE(since_before.follow_to(5));
  for (int n = 6; n <= 9; ++n) ASSERT_TRUE(log.append(group(0), true));
  etcd_.values.erase(keys.entry(7));
  const std::string file = scratch_folder() + "gap.journal";
  store::Store store;
  store::Store past;
  Standby standby(*client_, keys, "b", 7, etcd_.now);
  for (const Failure& failure :
       {FollowedLog(*client_, keys).follow().error(), since_before.follow().error(),
        standby.step([this] { return etcd_.now; }).error(), take_snapshot(*client_, keys, 1).error(),
        cluster_to_file(*client_, keys, file, [](Duration) {}).error(), log.recover(store).error(),
        log.read(past, {.revision = 1}).error()}) {
    EXPECT_EQ(failure.symbol, "bad-journal");
    EXPECT_EQ(failure.sentence, "the log in the cluster is damaged: entry 7 is missing");
  }
  EXPECT_EQ(since_before.follow().error().symbol, "bad-journal") << "again";
}

TEST_F(ClusterLogs, WithADamagedNumberAreRefusedByEveryoneWhoReadsIt) {
  const std::map<std::string, std::string> sound = {
      {keys.epoch(), text_of(EpochValue{1, "a", 1})}, {keys.head(), "0"}, {keys.alive(), text_of(Alive{.epoch = 1})}};
  const std::string file = scratch_folder() + "damaged.journal";
  for (const std::string wrong : {"", "x", "12x", "-1", " 7", "99999999999999999999999"}) {
    etcd_.values = sound;
    etcd_.values[keys.head()] = wrong;
    for (const Failure& failure : {head_of(*client_, keys).error(), take_snapshot(*client_, keys, 1).error(),
                                   cluster_to_file(*client_, keys, file, [](Duration) {}).error()}) {
      EXPECT_EQ(failure.symbol, "bad-journal") << wrong;
      EXPECT_EQ(failure.sentence, "the head of the log in the cluster is not what a board writes");
    }
    for (const std::string& key : {keys.epoch(), keys.alive(), keys.snapshot()}) {
      etcd_.values = sound;
      etcd_.values[key] = wrong;
      Standby standby(*client_, keys, "b", 7, etcd_.now);
      const auto now = [this] { return etcd_.now; };
      Result<bool> stepped = standby.step(now);
      etcd_.now += suspects_after;
      if (stepped) stepped = standby.step(now);
      ASSERT_FALSE(stepped) << key << " is " << wrong;
      EXPECT_EQ(stepped.error().symbol, "bad-journal") << key << " is " << wrong;
    }
  }
}

TEST_F(ClusterLogs, WhoseSnapshotLacksAPartAreDamaged) {
  etcd_.values[keys.snapshot()] = text_of(SnapshotValue{1, "1-1", 2, 0});
  etcd_.values[keys.snapshot_part("1-1", 0)] = "";
  FollowedLog followed(*client_, keys);
  EXPECT_EQ(followed.follow().error().sentence, "the log in the cluster is damaged: a part of the snapshot is missing");
}

}  // namespace
}  // namespace pizarra::cluster
