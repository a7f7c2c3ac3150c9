#include "programs/commands/board_sample.hpp"

#include <gtest/gtest.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"

namespace pizarra::programs {
namespace {

Probe probe(std::int64_t sent, std::int64_t committed, std::int64_t acknowledged) {
  return {Time(Duration(sent)), Time(Duration(committed)), Time(Duration(acknowledged))};
}

TEST(CommitTime, IsByTheBoardsClockWhereThatCanBeOurs) { EXPECT_EQ(commit_time(probe(100, 140, 200)), 40us); }

// Clocks of two processes differ by a little, those of two machines by much.
TEST(CommitTime, LiesBetweenTellingAndAnswerWhateverTheBoardsClockShows) {
  EXPECT_EQ(commit_time(probe(100, 97, 200)), 0us);
  EXPECT_EQ(commit_time(probe(100, 5140, 200)), 100us);
  EXPECT_EQ(commit_time(probe(9100, 140, 9200)), 0us);
}

// What ends at once; nothing here waits.
template <class T>
T result_of(VirtualExecutor& executor, Task<T> task) {
  std::optional<T> result;
  const auto keep = [](Task<T> kept, std::optional<T>& out) -> Task<void> {
    T value = co_await kept;
    out.emplace(std::move(value));
  };
  const Job job = executor.spawn(keep(std::move(task), result));
  executor.run_for(1ms);
  return std::move(*result);
}

Relation declared(const char* name, std::vector<Argument> arguments) {
  return {.name = name, .arguments = std::move(arguments), .key = {0}, .durable = false, .lease = {}};
}

const std::vector<Relation> agents_and_requests = {
    declared("agent", {{"name", ArgumentType::symbol}, {"kind", ArgumentType::symbol}, {"host", ArgumentType::string}}),
    declared("request",
             {{"id", ArgumentType::symbol}, {"agent", ArgumentType::symbol}, {"form", ArgumentType::datum}})};

class BoardSamplerTest : public testing::Test {
 protected:
  void declare(const std::vector<Relation>& relations) {
    ASSERT_TRUE(board_.declare("mallory", relations).has_value());
  }
  void tell(const std::string& teller, Datum fact) {
    Transaction transaction;
    transaction.tell(std::move(fact));
    ASSERT_TRUE(board_.transact(teller, transaction).has_value());
  }
  void begin() { EXPECT_TRUE(result_of(executor_, sampler_.begin()).has_value()); }
  // A second after begin(), or after the sample before.
  BoardSample sample() {
    executor_.run_for(1s);
    return result_of(executor_, sampler_.next()).value();
  }
  VirtualExecutor executor_;
  memory::MemoryBoard board_{executor_};
  const std::unique_ptr<Board> view_ = board_.view("top");
  BoardSampler sampler_{executor_, *view_, "top-1"};
};

TEST_F(BoardSamplerTest, ShowsTheRestWhereClientsHaveToldMoreAgentsThanAnAnswerHolds) {
  declare(agents_and_requests);
  const auto come = [&](const char* name, std::size_t host) {
    tell("mallory", list("agent"_sym, Datum::symbol(name), "kind"_sym, std::string(host, 'h')));
  };
  come("robot", 10);
  begin();
  const BoardSample before = sample();
  EXPECT_EQ(before.agents.size(), 1U);
  EXPECT_FALSE(before.agents_unknown.has_value());
  for (const char* name : {"a", "b", "c"}) come(name, 400'000);
  const BoardSample after = sample();
  ASSERT_TRUE(after.agents_unknown.has_value());
  EXPECT_EQ(after.agents_unknown->symbol, "too-large");
  EXPECT_EQ(after.facts, 4);
  EXPECT_TRUE(after.journey.has_value());
}

// What a board remembers is so many transactions: a `top` that is left on must not push them out.
TEST_F(BoardSamplerTest, ALookTellsOneFactAndTakesItBack) {
  begin();
  const BoardSample before = sample();
  const BoardSample after = sample();
  EXPECT_TRUE(after.journey.has_value());
  EXPECT_EQ(after.revision, before.revision + 2);
}

TEST_F(BoardSamplerTest, ShowsTheRestWhereClientsHaveDeclaredAgentsOrRequestsOtherwise) {
  for (const char* other : {"agent", "request"}) {
    SCOPED_TRACE(other);
    memory::MemoryBoard board(executor_);
    std::vector<Relation> relations = agents_and_requests;
    for (Relation& relation : relations) {
      if (relation.name == other) relation.arguments.pop_back();
    }
    ASSERT_TRUE(board.declare("mallory", relations).has_value());
    const std::unique_ptr<Board> view = board.view("top");
    BoardSampler sampler(executor_, *view, "top-1");
    ASSERT_TRUE(result_of(executor_, sampler.begin()).has_value());
    executor_.run_for(1s);
    const Result<BoardSample> sample = result_of(executor_, sampler.next());
    ASSERT_TRUE(sample.has_value()) << describe(sample.error());
    ASSERT_TRUE(sample->agents_unknown.has_value());
    EXPECT_EQ(sample->agents_unknown->symbol, "wrong-shape");
    EXPECT_EQ(sample->relations.size(), 2U);
    EXPECT_TRUE(sample->journey.has_value());
  }
}

TEST_F(BoardSamplerTest, ShowsNobodyWhereAgentsHaveComeAndRequestsHaveNotBeenDeclared) {
  declare({agents_and_requests.front()});
  begin();
  const BoardSample now = sample();
  EXPECT_FALSE(now.agents_unknown.has_value());
  EXPECT_TRUE(now.agents.empty());
}

// The board names 64 tellers of a relation.
TEST_F(BoardSamplerTest, CountsWhoWasForgottenByWhatItToldSince) {
  declare(agents_and_requests);
  declare({declared("seen", {{"n", ArgumentType::integer}})});
  int n = 0;
  const auto tells = [&](const std::string& teller, int times) {
    for (int i = 0; i < times; ++i) tell(teller, list("seen"_sym, ++n));
  };
  tell("robot", list("agent"_sym, "robot"_sym, "kind"_sym, "here"));
  tells("robot", 500);
  begin();
  for (int i = 0; i < 64; ++i) tells("guest-" + std::to_string(i), 1);
  tells("robot", 3);
  EXPECT_NEAR(sample().agents.at(0).told_per_second, 3, 0.01);
}

}  // namespace
}  // namespace pizarra::programs
