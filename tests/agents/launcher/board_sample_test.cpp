#include "agents/launcher/words/board_sample.hpp"

#include <gtest/gtest.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"

namespace pizarra {
namespace {

Probe probe(std::int64_t sent, std::int64_t committed, std::int64_t acknowledged) {
  return {Time(Duration(sent)), Time(Duration(committed)), Time(Duration(acknowledged))};
}

TEST(CommitTimes, AreByTheBoardsClockWhereThatCanBeOurs) {
  EXPECT_EQ(commit_times({probe(100, 140, 200), probe(300, 330, 390)}), (std::vector<Duration>{40us, 30us}));
}

// Clocks of two processes differ by a little, those of two machines by much.
TEST(CommitTimes, LieBetweenTellingAndAnswerWhateverTheBoardsClockShows) {
  EXPECT_EQ(commit_times({probe(100, 97, 200), probe(300, 330, 390)}), (std::vector<Duration>{0us, 33us}));
  EXPECT_EQ(commit_times({probe(100, 5140, 200), probe(300, 5330, 390)}), (std::vector<Duration>{100us, 90us}));
  EXPECT_EQ(commit_times({probe(9100, 140, 9200), probe(9300, 330, 9390)}), (std::vector<Duration>{10us, 0us}));
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

class BoardSamplerTest : public testing::Test {
 protected:
  BoardSample sample() {
    const std::unique_ptr<Board> view = board_.view("top");
    BoardSampler sampler(executor_, *view, "top-1");
    EXPECT_TRUE(result_of(executor_, sampler.begin()).has_value());
    executor_.run_for(1s);
    return result_of(executor_, sampler.next()).value();
  }
  VirtualExecutor executor_;
  MemoryBoard board_{executor_};
};

TEST_F(BoardSamplerTest, ShowsTheRestWhereClientsHaveToldMoreAgentsThanAnAnswerHolds) {
  const auto declared = [](const char* name, std::vector<Argument> arguments) {
    return Relation{.name = name, .arguments = std::move(arguments), .key = {0}, .durable = false, .lease = {}};
  };
  const std::vector<Relation> relations = {
      declared("agent",
               {{"name", ArgumentType::symbol}, {"kind", ArgumentType::symbol}, {"host", ArgumentType::string}}),
      declared("request",
               {{"id", ArgumentType::symbol}, {"agent", ArgumentType::symbol}, {"form", ArgumentType::datum}})};
  ASSERT_TRUE(board_.declare("mallory", relations).has_value());
  const auto tell = [&](const std::string& name, std::size_t host) {
    Transaction transaction;
    transaction.tell(list("agent"_sym, Datum::symbol(name), "kind"_sym, std::string(host, 'h')));
    ASSERT_TRUE(board_.transact("mallory", transaction).has_value());
  };
  tell("robot", 10);
  const BoardSample before = sample();
  EXPECT_EQ(before.agents.size(), 1U);
  EXPECT_FALSE(before.agents_unknown.has_value());
  for (const char* name : {"a", "b", "c"}) tell(name, 400'000);
  const BoardSample after = sample();
  ASSERT_TRUE(after.agents_unknown.has_value());
  EXPECT_EQ(after.agents_unknown->symbol, "too-large");
  EXPECT_EQ(after.facts, 4);
  EXPECT_TRUE(after.journey.has_value());
}

}  // namespace
}  // namespace pizarra
