// A look at the cells of a hall whose boards hold facts that no cell of ours tells.

#include "programs/commands/cell_sight.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/run_task.hpp"

namespace pizarra::programs {
namespace {

class CellSightTest : public testing::Test {
 protected:
  struct Served {
    explicit Served(Executor& executor)
        : board(executor),
          server(server::BoardServer::open(executor, board, {.addresses = {"tcp://127.0.0.1:*"}}).value()) {}
    void tell(const std::string& relation, const std::vector<std::string>& facts) {
      const std::vector<Relation> relations{
          relation_from_datum(read_one("(relation " + relation + ")").value()).value()};
      ASSERT_TRUE(board.declare("bob", relations));
      Transaction telling;
      for (const std::string& fact : facts) telling.tell(read_one(fact).value());
      ASSERT_TRUE(board.transact("bob", telling));
    }
    memory::MemoryBoard board;
    std::unique_ptr<server::BoardServer> server;
    const std::string address = server->addresses().front();
  };
  static std::vector<std::string> each(std::size_t count, const std::function<std::string(std::size_t)>& fact) {
    std::vector<std::string> facts;
    for (std::size_t n = 1; n <= count; ++n) facts.push_back(fact(n));
    return facts;
  }
  void name(const std::vector<std::string>& boards) {
    hall.tell("context-board ((name symbol) (address string)) (key name) (durable)", boards);
  }
  std::vector<CellSight> look(std::size_t most = 1000) {
    return run(executor, look_at_cells(executor, contexts, hall.address, most));
  }

  RealExecutor executor;
  client::Contexts contexts{executor, "alice", std::nullopt, 1s};
  Served hall{executor};
  Served cell{executor};
};

TEST_F(CellSightTest, ShowsTheNewestGoalAndEventOfMany) {
  name({"(context-board blocks \"" + cell.address + "\")"});
  cell.tell("goal ((n integer) (goal list)) (key n)",
            each(300, [](std::size_t n) { return fmt::format("(goal {} ((on circle lid)))", n); }));
  cell.tell("goal-state ((n integer) (state symbol) (detail datum)) (key n)",
            each(300, [](std::size_t n) { return fmt::format("(goal-state {} reached ())", n); }));
  cell.tell("event ((n integer) (kind symbol) (sentence string) (detail datum)) (key n)",
            each(300, [](std::size_t n) { return fmt::format("(event {0} plan \"plan {0}\" ())", n); }));
  const CellSight seen = look().at(1);
  EXPECT_FALSE(seen.fault) << describe(*seen.fault);
  EXPECT_EQ(seen.goal, "300 reached (on circle lid)");
  EXPECT_EQ(seen.said, "plan 300");
}

TEST_F(CellSightTest, ReadsNoMoreOfABoardThanALineHolds) {
  name({"(context-board blocks \"" + cell.address + "\")"});
  cell.tell("arm ((robot symbol) (state symbol) (action string)) (key robot)",
            each(5000, [](std::size_t n) { return fmt::format("(arm arm-{} moving \"\")", n); }));
  const CellSight seen = look().at(1);
  EXPECT_FALSE(seen.fault) << describe(*seen.fault);
  EXPECT_EQ(std::ranges::count(seen.arms, ','), 19) << seen.arms;
  EXPECT_LT(json_of(seen, 100).size(), 400U);
}

TEST_F(CellSightTest, ABoardWithOtherRelationsOfTheseNamesIsAFaultOfItsCellAlone) {
  Served odd(executor);
  name({"(context-board blocks \"" + cell.address + "\")", "(context-board odd \"" + odd.address + "\")"});
  odd.tell("goal-state ((text string) (more string) (detail datum)) (key text)", {"(goal-state \"9\" \"<b>\" ())"});
  odd.tell("goal ((n integer)) (key n)", {"(goal 0)"});
  const std::vector<CellSight> cells = look();
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_FALSE(cells[1].fault);
  ASSERT_TRUE(cells[2].fault) << json_of(cells[2]);
}

TEST_F(CellSightTest, LooksAtNoMoreCellsThanAreWantedAndWaitsForSilentOnesTogether) {
  name(each(500, [](std::size_t n) { return fmt::format("(context-board c{} \"ipc:///nobody/{}\")", n, n); }));
  const Time begun = executor.now();
  const std::vector<CellSight> cells = look(101);
  EXPECT_LT(executor.now() - begun, 10s) << "twice 1 s for a hundred boards";
  ASSERT_EQ(cells.size(), 102U);
  EXPECT_FALSE(cells[0].fault);
  ASSERT_TRUE(cells[101].fault);
  EXPECT_EQ(cells[101].fault->symbol, "too-many") << "the list says that it is cut";
  for (const CellSight& silent : std::span(cells).subspan(1, 100)) {
    ASSERT_TRUE(silent.fault);
    EXPECT_TRUE(silent.fault->sentence.starts_with("the board does not answer: " + silent.path));
  }
}

}  // namespace
}  // namespace pizarra::programs
