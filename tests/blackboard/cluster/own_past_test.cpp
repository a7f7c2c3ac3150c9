// A board of a cluster answers about the past: everything of the times that it led, and what is durable of the
// others.

#include "blackboard/cluster/own_past.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/journal/past.hpp"
#include "blackboard/server/kept_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/blackboard/cluster/etcd_model.hpp"
#include "tests/scratch.hpp"

namespace pizarra::cluster {
namespace {

const LogKeys past_keys("blocks");

class OwnPasts : public testing::Test {
 protected:
  OwnPasts() {
    etcd_.trouble = 0;
    std::filesystem::remove_all(folder_);
    etcd_.values[past_keys.head()] = "0";
  }
  // A board leads the cell from now on, as a former one would have left it.
  void lead(const std::string& folder, journal::History history = {}) {
    end();
    ++epoch_;
    const EpochValue mine{epoch_, "board", epoch_};
    etcd_.values[past_keys.epoch()] = text_of(mine);
    FollowedLog followed(*client_, past_keys);
    ASSERT_TRUE(followed.follow_to(std::stoull(etcd_.values[past_keys.head()])).has_value());
    ASSERT_TRUE(followed.follow().has_value());
    const auto log =
        std::make_shared<ClusterLog>(client_, client_, past_keys, mine, followed.number(), "etcd://model/blocks");
    std::unique_ptr<store::Store> store = followed.take_store();
    const Revision first = epoch_ * 1000;
    store->restore_counters(first, first);
    board_ = std::make_unique<server::KeptBoard>(executor_);
    store::JournalSink all;
    if (!folder.empty()) {
      past_ =
          OwnPast::begin(executor_, {folder, history}, "blocks", epoch_, *store, {first, executor_.now()}, log).value();
      all = [this](std::string_view line) { past_->add(line); };
    }
    board_->lead(std::move(store), epoch_ << 40, {}, log, std::move(all));
    answers_ = std::make_unique<journal::Past>(executor_, past_ ? past_->writer() : *board_->journal(),
                                               [this] { return board_->board().store().revision(); });
  }
  void end() {
    answers_.reset();
    if (board_ != nullptr) executor_.run_for(1s);
    board_.reset();
    past_.reset();
  }
  void declare() {
    std::vector<Relation> relations;
    for (const char* text :
         {"(relation seen ((n integer)) (key n))", "(relation goal ((n integer)) (key n) (durable))"}) {
      relations.push_back(relation_from_datum(read_one(text).value()).value());
    }
    ASSERT_TRUE(board_->board().declare("alice", relations).has_value());
  }
  // The revision at which it stands.
  Revision tell(const std::string& fact) {
    executor_.run_for(1s);
    return board_->board().transact("alice", Transaction().tell(read_one(fact).value())).value();
  }
  // What it answers to `(seen ?n)` or `(goal ?n)` at a moment: numbers, or the failure.
  std::string ask(const std::string& pattern, const Moment& at) {
    Query query = query_for(read_one(pattern).value());
    query.at = at;
    std::string said;
    answers_->ask("alice", query, [&](const Result<Answers>& answers) {
      if (!answers) {
        said = describe(answers.error());
        return;
      }
      for (const Answer& answer : answers->answers) {
        said += std::to_string(answer.facts.front().datum[1].integer()) + " ";
      }
    });
    executor_.run_for(10s);
    return said;
  }
  std::string seen(Revision at) { return ask("(seen ?n)", {.revision = at}); }
  std::string goals(Revision at) { return ask("(goal ?n)", {.revision = at}); }

  EtcdModel etcd_{1};
  const std::shared_ptr<ModelClient> client_ = std::make_shared<ModelClient>(etcd_);
  VirtualExecutor executor_;
  const std::string folder_ = scratch_folder() + "past";
  std::uint64_t epoch_ = 0;
  std::unique_ptr<OwnPast> past_;
  std::unique_ptr<server::KeptBoard> board_;
  std::unique_ptr<journal::Past> answers_;
};

TEST_F(OwnPasts, SayWhatWasThereWithoutBeingDurableAtEachMomentOfATermAndOfTheNext) {
  lead(folder_);
  declare();
  const Revision one = tell("(seen 1)");
  const Time then = executor_.now();
  const Revision two = tell("(seen 2)");
  const Revision goal = tell("(goal 1)");
  EXPECT_EQ(seen(one), "1 ");
  EXPECT_EQ(seen(two), "1 2 ");
  EXPECT_EQ(ask("(seen ?n)", {.time = then}), "1 ");
  EXPECT_EQ(goals(two), "");
  EXPECT_EQ(goals(goal), "1 ");
  lead(folder_);
  const Revision three = tell("(seen 3)");
  EXPECT_EQ(seen(three), "3 ") << "it begins with what is durable";
  EXPECT_EQ(goals(three), "1 ");
  EXPECT_EQ(seen(two), "1 2 ");
  EXPECT_TRUE(seen(three + 1).starts_with("there is no revision")) << seen(three + 1);
}

TEST_F(OwnPasts, TellATimeInWhichAnotherBoardLedAsAGapAndWhatWasDurableThen) {
  lead(folder_);
  declare();
  const Revision own = tell("(seen 1)");
  tell("(goal 1)");
  lead(folder_ + "-of-another");
  tell("(seen 2)");
  const Revision others = tell("(goal 2)");
  const Time then = executor_.now();
  lead(folder_);
  tell("(seen 3)");
  EXPECT_EQ(seen(own), "1 ");
  EXPECT_EQ(goals(others), "1 2 ");
  EXPECT_EQ(seen(others),
            "this board has nothing of what was not durable after revision 1002 and before revision 3000: it did not "
            "lead then, or did not keep it");
  EXPECT_EQ(ask("(seen ?n)", {.time = then}), seen(others));
  std::filesystem::remove_all(folder_ + "-of-another");
}

TEST_F(OwnPasts, AreAGapWhereABoardKeepsNone) {
  lead("");
  declare();
  tell("(seen 1)");
  const Revision goal = tell("(goal 1)");
  EXPECT_EQ(goals(goal), "1 ");
  EXPECT_EQ(seen(goal),
            "the log of boards that take over has only what is durable, and this board keeps no past of its own");
  const Revision behind = tell("(seen 2)");
  EXPECT_EQ(goals(behind), "1 ") << "it stood, though the log ends before";
  EXPECT_EQ(seen(behind), seen(goal));
  EXPECT_TRUE(goals(behind + 1).starts_with("there is no revision")) << goals(behind + 1);
}

TEST_F(OwnPasts, EndWhereMoreWaitsForTheDiskThanMayAndKeepNobodyWaiting) {
  lead(folder_);
  declare();
  std::string reason;
  past_->on_end = [&](const Failure& failure) { reason = failure.symbol; };
  const Revision known = tell("(seen 1)");
  executor_.run_for(1s);
  const std::string long_line = fmt::format("({} {} \"alice\" (declare){})", known,
                                            executor_.now().time_since_epoch().count(), std::string(1 << 20, ' '));
  for (int i = 0; i < 17 && reason.empty(); ++i) past_->add(long_line);
  EXPECT_EQ(reason, "journal-full");
  const Revision lost = tell("(seen 2)");
  EXPECT_TRUE(seen(lost).contains("has nothing of what was not durable after revision")) << seen(lost);
  EXPECT_EQ(goals(lost), "");
  EXPECT_TRUE(seen(lost + 1).starts_with("there is no revision")) << seen(lost + 1);
  tell("(goal 1)");
  executor_.run_for(1s);
  EXPECT_TRUE(seen(lost).contains("has nothing of what was not durable after revision")) << seen(lost);
  EXPECT_EQ(seen(known), "1 ");
}

TEST_F(OwnPasts, KeepTheNewestTermsAlone) {
  for (std::size_t term = 0; term < OwnPast::most_terms + 3; ++term) {
    lead(folder_);
    if (term == 0) declare();
    tell("(seen 1)");
  }
  std::size_t journals = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() == ".journal") ++journals;
  }
  EXPECT_EQ(journals, OwnPast::most_terms);
  EXPECT_TRUE(seen(1001).contains("before revision 4000")) << seen(1001);
}

TEST_F(OwnPasts, LeaveThoseOfCellsWithLongerNamesInTheSameFolderAlone) {
  store::Store store;
  const auto blocks_0 = OwnPast::begin(executor_, {folder_, {}}, "blocks-0", 1, store, {}, nullptr).value();
  const auto blocks_2 = OwnPast::begin(executor_, {folder_, {}}, "blocks-2", 1, store, {}, nullptr).value();
  const auto files_of_others = [&] {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("blocks-0-") || name.starts_with("blocks-2-")) names.insert(name);
    }
    return names;
  };
  const std::set<std::string> before = files_of_others();
  ASSERT_TRUE(before.contains("blocks-0-000001.journal") && before.contains("blocks-2-000001.journal"));
  const auto begun = OwnPast::begin(executor_, {folder_, {.bytes = 0}}, "blocks", 1, store, {}, nullptr);
  EXPECT_TRUE(begun.has_value()) << describe(begun.error());
  EXPECT_EQ(files_of_others(), before);
}

TEST_F(OwnPasts, AreNotBegunInAFolderWithThePastOfAnotherLog) {
  epoch_ = 7;
  lead(folder_);
  end();
  store::Store store;
  const auto refused = OwnPast::begin(executor_, {folder_, {}}, "blocks", 3, store, {}, nullptr);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().symbol, "exists");
}

}  // namespace
}  // namespace pizarra::cluster
