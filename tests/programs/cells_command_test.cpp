// `cells`: a hall's board names two cells, of which one does not answer.

#include <gtest/gtest.h>

#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"

namespace pizarra::programs {
namespace {

using std::chrono::seconds;

class CellsOfAHall : public testing::Test {
 protected:
  static std::string address(const std::string& board) { return "ipc://" + scratch_folder() + board + ".ipc"; }
  static std::vector<std::string> board(const std::string& name) { return {PIZARRA_BOARD, "--listen", address(name)}; }
  static Said run(const std::string& words, const std::string& board) {
    return shell(std::string(PIZARRA_CELL) + " " + words + " --board " + address(board) + " 2>&1");
  }
  static bool is_up(const Running& board) {
    return wait_until([&] { return board.said().contains("ready on "); }, seconds(60));
  }
  static void tell(const std::string& board, const std::string& relation, const std::string& fact) {
    ASSERT_EQ(run("declare '(relation " + relation + ")'", board).status, 0);
    const Said told = run("tell '" + fact + "'", board);
    ASSERT_EQ(told.status, 0) << told.text;
  }
};

TEST_F(CellsOfAHall, AreShownWithWhatEachDoesAndWhyOneIsNotKnown) {
  const Running hall(board("hall"), scratch_folder() + "hall.log");
  const Running blocks(board("blocks"), scratch_folder() + "blocks.log");
  std::optional<Running> kits(std::in_place, board("kits"), scratch_folder() + "kits.log");
  ASSERT_TRUE(is_up(hall) && is_up(blocks) && is_up(*kits));
  ASSERT_EQ(run("contexts --add blocks=" + address("blocks"), "hall").status, 0);
  ASSERT_EQ(run("contexts --add kits=" + address("kits"), "hall").status, 0);
  tell("blocks", "agent ((name symbol) (kind symbol) (host string)) (key name)", "(agent robot robot \"bench\")");
  tell("blocks", "goal ((n integer) (goal list)) (key n)", "(goal 9 ((on lid circle)))");
  tell("blocks", "goal-state ((n integer) (state symbol) (detail datum)) (key n)", "(goal-state 9 reached ())");
  tell("blocks", "goal ((n integer) (goal list)) (key n)", "(goal 10 ((on circle lid)))");
  tell("blocks", "goal-state ((n integer) (state symbol) (detail datum)) (key n)", "(goal-state 10 running ())");
  tell("blocks", "arm ((robot symbol) (state symbol) (action string)) (key robot)", "(arm robot fault \"alarm 4415\")");
  tell("blocks", "stop ((who symbol) (reason string)) (key who)", "(stop anna \"a hand\")");
  const Said all = run("cells", "hall");
  EXPECT_EQ(all.status, 0) << all.text;
  EXPECT_TRUE(all.text.contains("10 running (on circle lid)")) << all.text;
  EXPECT_TRUE(all.text.contains("robot fault: alarm 4415")) << all.text;
  EXPECT_TRUE(all.text.contains("anna: a hand\n")) << all.text;
  EXPECT_TRUE(all.text.contains("\nkits ")) << all.text;
  kits.reset();
  const Said some = run("cells --json", "hall");
  EXPECT_EQ(some.status, 1) << "not all of them are known";
  EXPECT_TRUE(some.text.contains("{\"path\":\"kits\",\"address\":\"" + address("kits") +
                                 "\",\"fault\":\"the board does not answer"))
      << some.text;
  EXPECT_TRUE(some.text.contains("\"fault\":null,\"agents\":1,\"goal\":\"10 running (on circle lid)\"")) << some.text;
}

}  // namespace
}  // namespace pizarra::programs
