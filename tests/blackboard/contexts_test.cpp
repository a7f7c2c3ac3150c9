// Boards that name other boards: a hall names its areas, an area its cells.

#include "blackboard/client/contexts.hpp"

#include <gtest/gtest.h>
#include <sstream>

#include "blackboard/server/board_server.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/blackboard/wall.hpp"
#include "tests/run_task.hpp"

namespace pizarra {
namespace {

using client::Contexts;

class ContextsTest : public testing::Test {
 protected:
  struct Served {
    explicit Served(Executor& executor)
        : board(executor),
          server(server::BoardServer::open(executor, board, {.addresses = {"tcp://127.0.0.1:*"}}).value()) {}
    memory::MemoryBoard board;
    std::unique_ptr<server::BoardServer> server;
    const std::string address = server->addresses().front();
  };
  std::string add(const Served& above, const std::string& name, const std::string& address) {
    const Result<void> added = run(executor, contexts.add(above.address, name, address));
    return added ? "ok" : describe(added.error());
  }
  // The hall names north, and that names blocks.
  void SetUp() override {
    ASSERT_EQ(add(hall, "north", north.address), "ok");
    ASSERT_EQ(add(north, "blocks", blocks.address), "ok");
  }
  Result<std::string> resolve(const std::string& path) { return run(executor, contexts.resolve(hall.address, path)); }
  static std::string text_of(const std::vector<Contexts::Row>& rows) {
    std::string all;
    for (const Contexts::Row& row : rows) all += row.path + " " + (row.fault ? row.fault->symbol : "there") + "\n";
    return all;
  }
  std::string listed() { return text_of(run(executor, contexts.list(hall.address))); }
  std::string above(const Served& board) { return text_of(run(executor, contexts.ascend(board.address))); }
  // As somebody tells it who does not ask first.
  static void tell(Served& board, const std::string& fact) {
    ASSERT_TRUE(board.board.transact("bob", Transaction().tell(read(fact))).has_value());
  }

  RealExecutor executor;
  Contexts contexts{executor, "alice", std::nullopt, 2s};
  Served hall{executor};
  Served north{executor};
  Served blocks{executor};
};

TEST_F(ContextsTest, APathOfNamesLeadsFromBoardToBoard) {
  EXPECT_EQ(resolve("").value(), hall.address);
  EXPECT_EQ(resolve("north").value(), north.address);
  EXPECT_EQ(resolve("north/blocks").value(), blocks.address);
  EXPECT_EQ(listed(), " there\nnorth there\nnorth/blocks there\n");
}

TEST_F(ContextsTest, ANameThatNobodyHasIsToldWithWhereItIsMissing) {
  const Result<std::string> below = resolve("north/kits");
  ASSERT_FALSE(below.has_value());
  EXPECT_EQ(below.error().symbol, "no-context");
  EXPECT_EQ(below.error().sentence, "north names no board kits");
  const Result<std::string> beneath = resolve("north/blocks/deeper");
  ASSERT_FALSE(beneath.has_value());
  EXPECT_EQ(beneath.error().sentence, "north/blocks names no board deeper");
}

TEST_F(ContextsTest, ABoardOfTheWayThatDoesNotAnswerIsNamed) {
  north.server.reset();
  const Result<std::string> beyond = resolve("north/blocks");
  ASSERT_FALSE(beyond.has_value());
  EXPECT_EQ(beyond.error().symbol, "unreachable");
  EXPECT_EQ(beyond.error().sentence, "the board does not answer: north at " + north.address);
  EXPECT_EQ(listed(), " there\nnorth unreachable\n");
  EXPECT_EQ(above(blocks), " there\nblocks unreachable\n");
}

TEST_F(ContextsTest, SilentBoardsAreWaitedForTogether) {
  std::vector<std::unique_ptr<Served>> silent;
  for (int n = 0; n < 5; ++n) {
    silent.push_back(std::make_unique<Served>(executor));
    ASSERT_EQ(add(hall, "area-" + std::to_string(n), silent.back()->address), "ok");
  }
  for (const auto& board : silent) board->server.reset();
  const Time begun = executor.now();
  const std::string all = listed();
  EXPECT_LT(executor.now() - begun, 8s) << "not 2 s for each of the five";
  EXPECT_TRUE(all.starts_with(" there\narea-0 unreachable\narea-1 unreachable\n")) << all;
  EXPECT_TRUE(all.ends_with("north there\nnorth/blocks there\n")) << all;
}

TEST_F(ContextsTest, MoreBoardsThanAreAskedAtOnceAreAllListed) {
  const std::size_t many = 2 * Contexts::most_asked_at_once + 1;
  Transaction naming;
  for (std::size_t n = 1; n <= many; ++n) {
    naming.tell(
        list("context-board"_sym, Datum::symbol("a" + std::to_string(n)), "tcp://127.0.0." + std::to_string(n) + ":1"));
  }
  ASSERT_TRUE(hall.board.transact("bob", naming).has_value());
  Contexts hasty(executor, "alice", std::nullopt, 500ms);
  std::size_t silent = 0;
  for (const Contexts::Row& row : run(executor, hasty.list(hall.address))) {
    if (row.path.starts_with("a") && row.fault && row.fault->symbol == "unreachable") ++silent;
  }
  EXPECT_EQ(silent, many);
}

TEST_F(ContextsTest, WhatLeadsBackIsListedOnceAndSaidToBeALoop) {
  Served kits(executor);
  ASSERT_EQ(add(blocks, "up", kits.address), "ok");
  ASSERT_EQ(add(hall, "also", blocks.address), "ok");
  tell(blocks, "(context-board up \"" + hall.address + "\")");
  EXPECT_EQ(listed(), " there\nalso there\nnorth there\nalso/up context-loop\nnorth/blocks context-loop\n");
  EXPECT_EQ(resolve("north/blocks/up/north").value(), north.address) << "a path ends, whatever it passes";
}

TEST_F(ContextsTest, ANameIsNotTakenFromTheBoardThatHasIt) {
  const std::string taken = add(hall, "north", blocks.address);
  EXPECT_TRUE(taken.starts_with(hall.address + " names " + north.address + " north: take another name")) << taken;
  EXPECT_EQ(resolve("north").value(), north.address);
  EXPECT_EQ(above(blocks), " there\nblocks there\nnorth/blocks there\n") << "and the other was not told of it";
  EXPECT_EQ(add(hall, "north", north.address), "ok") << "the same again";
}

TEST_F(ContextsTest, ABoardNamesNeitherItselfNorOneAboveIt) {
  const std::string itself = add(hall, "self", hall.address);
  EXPECT_TRUE(itself.starts_with(hall.address + " cannot name itself")) << itself;
  const std::string above_it = add(blocks, "up", hall.address);
  EXPECT_TRUE(above_it.starts_with(blocks.address + " cannot name a board above it")) << above_it;
  EXPECT_EQ(listed(), " there\nnorth there\nnorth/blocks there\n");
  EXPECT_EQ(above(hall), " there\n");
}

TEST_F(ContextsTest, ABoardMayNameTheOneThatNamedItBefore) {
  ASSERT_TRUE(hall.board.transact("bob", Transaction().retract(read("(context-board north ?)"))).has_value());
  EXPECT_EQ(add(north, "hall", hall.address), "ok");
  EXPECT_EQ(above(hall), " there\nhall there\nnorth/hall orphan\n") << "it was named so";
}

TEST_F(ContextsTest, TheBoardsAboveAreListedByAllParentsAlsoWhereOneDoesNotAnswer) {
  Served kits(executor);
  Served office(executor);
  ASSERT_EQ(add(office, "kits", kits.address), "ok");
  ASSERT_EQ(add(north, "kits", kits.address), "ok");
  const auto sorted = [](std::string text) {
    std::vector<std::string> lines;
    for (std::istringstream in(text); std::getline(in, text);) lines.push_back(text);
    std::ranges::sort(lines);
    return lines;
  };
  const std::vector<std::string> all = {" there", "kits there", "kits there", "north/kits there"};
  EXPECT_EQ(sorted(above(kits)), all);
  office.server.reset();
  const std::vector<std::string> some = {" there", "kits there", "kits unreachable", "north/kits there"};
  EXPECT_EQ(sorted(above(kits)), some);
}

TEST_F(ContextsTest, ABoardKnowsWhoNamesItUntilItIsAnOrphan) {
  EXPECT_EQ(above(blocks), " there\nblocks there\nnorth/blocks there\n");
  ASSERT_TRUE(north.board.transact("bob", Transaction().retract(read("(context-board blocks ?)"))).has_value());
  const std::vector<Contexts::Row> lost = run(executor, contexts.ascend(blocks.address));
  ASSERT_EQ(text_of(lost), " there\nblocks orphan\n");
  EXPECT_EQ(lost[1].fault->sentence, north.address + " does not name " + blocks.address + " as blocks any more");
}

TEST_F(ContextsTest, AListThatIsCutSaysSo) {
  EXPECT_EQ(text_of(run(executor, contexts.list(hall.address, 3))), listed());
  const std::vector<Contexts::Row> cut = run(executor, contexts.list(hall.address, 2));
  EXPECT_EQ(text_of(cut), " there\nnorth there\nnorth/blocks too-many\n");
  EXPECT_EQ(cut[2].fault->sentence, "the list is full: it lacks this one, 0 more of the same level, and all below");
}

TEST_F(ContextsTest, ABoardThatIsNotThereIsNotNamed) {
  const std::string refused = add(hall, "south", "tcp://127.0.0.1:1");
  EXPECT_TRUE(refused.starts_with("the board does not answer: south at tcp://127.0.0.1:1")) << refused;
  EXPECT_EQ(resolve("south").error().symbol, "no-context");
}

}  // namespace
}  // namespace pizarra
