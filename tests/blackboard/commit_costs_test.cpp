// How much is done for watches that follow a commit, whatever they find.

#include <algorithm>
#include <gtest/gtest.h>

#include "blackboard/limits.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/watch/watch_table.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

struct WatchedStore {
  WatchedStore() {
    store.on_commit([this](const store::Commit& commit) { watches.committed(commit); });
    EXPECT_TRUE(store
                    .declare({relation("(relation on ((a datum) (b datum)))"),
                              relation("(relation at ((a datum) (b datum)) (key a))"),
                              relation("(relation big ((a datum)))"), relation("(relation mode ((a datum)) (key))")})
                    .has_value());
  }

  store::Store store;
  watch::WatchTable watches{store};
};

// However many watches a commit concerns, so much is done for them, whether they look at anything or not; who is left
// out begins anew.
class CommitCosts : public testing::Test {
 protected:
  static constexpr int facts = 5000;
  static constexpr std::size_t readers = 4;
  static constexpr std::size_t most =
      limits::examined + readers * limits::examined_a_turn + 2 * readers * facts * watch::CommitLooks::looks_a_search;

  void watch(const std::string& watched, int of_each) {
    for (std::size_t reader = 0; reader < readers; ++reader) {
      const auto backlog = std::make_shared<watch::Backlog>();
      for (int i = 0; i < of_each; ++i) {
        queues_.push_back(both_.watches.add(query(watched), nullptr, "greedy", backlog).value());
        queues_.back()->pop().value();
      }
    }
  }
  // In one transaction.
  void tell_many(const std::string& first, int count = facts) {
    Transaction many;
    for (int i = 0; i < count; ++i) many.tell(read("(on " + first + " " + std::to_string(i) + ")"));
    ASSERT_TRUE(both_.store.transact("teller", many, {}).has_value());
  }
  std::uint64_t examined() const {
    std::uint64_t examined = 0;
    for (const auto& queue : queues_) examined += queue->examined();
    return examined;
  }
  std::size_t left_out() const {
    const auto is_left_out = [](const auto& queue) { return queue->must_look(); };
    return static_cast<std::size_t>(std::ranges::count_if(queues_, is_left_out));
  }
  void all_know(std::size_t answers) {
    for (const auto& queue : queues_) {
      std::size_t known = 0;
      while (queue->ready()) {
        const Change change = queue->pop().value();
        known = (change.resynchronised ? 0 : known) + change.added.size();
      }
      ASSERT_EQ(known, answers);
    }
  }

  WatchedStore both_;
  std::vector<std::unique_ptr<watch::WatchQueue>> queues_;
};

TEST_F(CommitCosts, CountWhatIsTriedAndDoesNotFit) {
  watch("(and (on ?x ?y) (< ?y ?x))", 1);
  tell_many("-1");
  EXPECT_GE(examined(), readers * facts);
  EXPECT_EQ(left_out(), 0U);
}

TEST_F(CommitCosts, CountASearchThatLooksAtNothing) {
  watch("(and (on ?x ?y) (at ?y ?z))", 1);
  tell_many("1");
  EXPECT_GE(examined(), readers * facts * watch::CommitLooks::looks_a_search);
  EXPECT_EQ(left_out(), 0U);
}

TEST_F(CommitCosts, AreBoundedForWatchesThatNothingFits) {
  for (const std::string watched : {"(and (on ?x ?y) (< ?y ?x))", "(and (on ?x ?y) (at ?y ?z))"}) {
    queues_.clear();
    watch(watched, 60);
    const std::uint64_t before = examined();
    tell_many(watched.contains("at") ? "-1" : "-2");
    EXPECT_LE(examined() - before, most) << watched;
    EXPECT_GT(left_out(), 0U) << watched;
    EXPECT_LT(left_out(), queues_.size()) << watched;
    all_know(0);
  }
}

TEST_F(CommitCosts, AreBoundedForWatchesThatEveryFactFits) {
  watch("(on ?x ?y)", 60);
  tell_many("1");
  EXPECT_LE(examined(), most);
  EXPECT_GT(left_out(), 0U);
  EXPECT_LT(left_out(), queues_.size());
  all_know(facts);
}

TEST_F(CommitCosts, AreBoundedForAnswersThatGoTogether) {
  watch("(and (mode ?m) (on ?x ?y))", 60);
  ASSERT_TRUE(both_.store.transact("teller", Transaction().tell(read("(mode 1)")), {}).has_value());
  constexpr int answers = 2000;
  tell_many("1", answers);
  all_know(answers);
  const std::uint64_t before = examined();
  ASSERT_TRUE(both_.store.transact("teller", Transaction().retract(read("(mode ?)")), {}).has_value());
  EXPECT_LE(examined() - before, most);
  EXPECT_GT(left_out(), 0U);
  all_know(0);
}

TEST_F(CommitCosts, AreBoundedWhereEveryFactLeadsToEveryWatch) {
  watch("(and (on 1 ?y) (at ?y ?z) (big ?z))", 60);
  watch("(and (on ?x ?y) (big ?x) (< ?y -1))", 60);
  tell_many("1");
  EXPECT_LE(examined(), most);
  ASSERT_TRUE(
      both_.store
          .transact("teller", Transaction().tell(read("(at 7 8)")).tell(read("(at 8 9)")).tell(read("(big 8)")), {})
          .has_value());
  for (std::size_t i = 0; i < queues_.size(); ++i) {
    std::size_t known = 0;
    while (queues_[i]->ready()) known = queues_[i]->pop().value().added.size();
    ASSERT_EQ(known, i < queues_.size() / 2 ? 1U : 0U);
  }
}

}  // namespace
}  // namespace pizarra
