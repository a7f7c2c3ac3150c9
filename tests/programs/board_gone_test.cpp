// A client does not wait for ever when the board is gone, and goes on when it comes back.

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

using std::chrono::seconds;

// Much longer than anything here takes on a machine that does nothing else.
constexpr seconds patience{60};

Said run(const std::string& words) { return shell(std::string(PIZARRA_CELL) + " " + words + " 2>&1"); }

std::string file(const std::string& name) { return scratch_folder() + name; }

// Asked of an agent that is said to be there and never answers.
const std::vector<std::string> waiting_forms = {"--eval", "(tell (agent ghost robot \"here\"))", "--eval",
                                                "(ghost (monitor))"};

bool says(const Running& program, const std::string& text) {
  return wait_until([&] { return program.said().find(text) != std::string::npos; }, patience);
}

void write_cell(const std::string& agent) {
  std::ofstream(file("cell.scm")) << "(cell lone (world (cube circle (at 450 0))) (domain \"" << source_dir()
                                  << "/domains/blocks.scm\") (host \"localhost\" (agents " << agent << ")))\n";
}

// As nothing kills it but a fault; who runs the cell starts it again.
void kill_board() {
  const std::string ps = run("ps --json").text;
  const std::size_t pid = ps.find("\"pid\":", ps.find("\"name\":\"board\""));
  ASSERT_NE(pid, std::string::npos) << ps;
  ASSERT_EQ(kill(std::atoi(ps.c_str() + pid + 6), SIGKILL), 0);
}

TEST(UpBeforeItsBoard, SaysWhatItWaitsForAndTellsTheStoryWhenTheBoardComes) {
  write_cell("planner");
  const std::string address = "ipc://" + file("late.ipc");
  Running up({PIZARRA_CELL, "up", file("cell.scm"), "--board", address}, file("early.log"));
  ASSERT_TRUE(says(up, "the board does not answer")) << up.said();
  EXPECT_TRUE(says(up, ": waiting for it\n")) << up.said();
  const Running board({PIZARRA_BOARD, "--listen", address}, file("late.log"));
  EXPECT_TRUE(says(up, "the board answers\n")) << up.said();
  EXPECT_TRUE(says(up, "planner is there\n")) << up.said();
  const std::string story = up.said();
  EXPECT_EQ(story.find("waiting for it"), story.rfind("waiting for it")) << story;
  up.signal(SIGTERM);
  EXPECT_EQ(up.end(patience), 0) << up.said();
}

// A cell with a planner alone, its watch, and a form that waits.
class BoardOfACellGone : public testing::Test {
 protected:
  void SetUp() override {
    write_cell("planner");
    up_.emplace(std::vector<std::string>{PIZARRA_CELL, "up", file("cell.scm")}, file("up.log"));
    const auto planner_is_there = [] { return run("ask '(agent planner ?k ?)'").text == "?k = planner\n"; };
    ASSERT_TRUE(wait_until(planner_is_there, patience)) << up_->said();
    watch_.emplace(std::vector<std::string>{PIZARRA_CELL, "watch", "(agent ?who robot ?)"}, file("watch.log"));
    ASSERT_TRUE(says(*watch_, "watch 1"));
    std::vector<std::string> words{PIZARRA_CELL, "repl"};
    words.insert(words.end(), waiting_forms.begin(), waiting_forms.end());
    waiting_.emplace(words, file("waiting.log"));
    ASSERT_TRUE(says(*watch_, "+ ?who = ghost"));
  }

  std::optional<Running> up_;
  std::optional<Running> watch_;
  std::optional<Running> waiting_;
};

TEST_F(BoardOfACellGone, DownEndsWhoWaitsAtOnceWithOneLineAndStatus4) {
  EXPECT_EQ(run("down " + file("cell.scm")).status, 0);
  // Less than what a silent board is given.
  EXPECT_EQ(watch_->end(seconds(5)), 4) << watch_->said();
  EXPECT_TRUE(watch_->said().ends_with("\npizarra: the cell lone has ended\n")) << watch_->said();
  EXPECT_EQ(waiting_->end(seconds(5)), 4) << waiting_->said();
  EXPECT_TRUE(waiting_->said().ends_with("\npizarra: the cell lone has ended\n")) << waiting_->said();
}

TEST_F(BoardOfACellGone, AKilledUpEndsWhoWaitsToo) {
  up_->signal(SIGKILL);
  EXPECT_EQ(watch_->end(seconds(5)), 4) << watch_->said();
  EXPECT_EQ(waiting_->end(seconds(5)), 4) << waiting_->said();
}

TEST_F(BoardOfACellGone, ABoardThatIsStartedAgainEndsNobody) {
  kill_board();
  const auto told = [] { return run("tell '(agent spirit robot \"there\")'").status == 0; };
  EXPECT_TRUE(wait_until(told, patience)) << up_->said();
  EXPECT_TRUE(says(*watch_, "+ ?who = spirit")) << watch_->said();
  EXPECT_EQ(waiting_->end(seconds(0)), std::nullopt) << waiting_->said();

  const auto planner_is_there = [] { return run("ask '(agent planner ?k ?)'").text == "?k = planner\n"; };
  EXPECT_TRUE(wait_until(planner_is_there, patience)) << up_->said();
  const std::string story = up_->said();
  const std::string arrival = "planner is there";
  ASSERT_NE(story.find(arrival), std::string::npos) << story;
  EXPECT_EQ(story.find(arrival), story.rfind(arrival)) << story;
}

TEST_F(BoardOfACellGone, WhoEndsOrIsInterruptedIsNotPresentAnyMore) {
  const auto presences = [] {
    const std::string shown = run("ps").text;
    const std::string_view row = "\n  prompt-";
    std::size_t count = 0;
    for (std::size_t at = shown.find(row); at != std::string::npos; at = shown.find(row, at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(presences(), 1U) << "the prompt whose form waits, but nobody who asks the board alone: " << run("ps").text;
  watch_->signal(SIGINT);
  waiting_->signal(SIGTERM);
  EXPECT_EQ(watch_->end(patience), 130) << watch_->said();
  EXPECT_EQ(waiting_->end(patience), 130) << waiting_->said();
  EXPECT_EQ(presences(), 0U) << run("ps").text;
}

TEST(BoardGone, AStopOutlivesItUntilSomebodyWithdrawsIt) {
  write_cell("robot");
  Running up({PIZARRA_CELL, "up", file("cell.scm")}, file("up.log"));
  const auto robot_is_there = [] { return run("ask '(agent robot ?k ?)'").text == "?k = robot\n"; };
  ASSERT_TRUE(wait_until(robot_is_there, patience)) << up.said();
  ASSERT_EQ(run("tell '(stop me \"my arm is in there\")'").status, 0);
  kill_board();
  const auto told = [] { return run("tell '(agent spirit robot \"there\")'").status == 0; };
  ASSERT_TRUE(wait_until(told, patience)) << up.said();
  ASSERT_TRUE(wait_until(robot_is_there, patience)) << up.said();
  EXPECT_EQ(run("ask '(stop me ?reason)'").text, "?reason = \"my arm is in there\"\n");
  const Said refused = run("repl --eval '(robot (home))'");
  EXPECT_NE(refused.text.find("me says stop: my arm is in there"), std::string::npos) << refused.text;
}

TEST(BoardGone, OneThatAnswersNothingForTenSecondsEndsWhoWaitsWithStatus4) {
  const std::string address = "ipc://" + file("board.ipc");
  const std::string program = std::filesystem::path(PIZARRA_CELL).replace_filename("pizarra-board");
  Running board({program, "--listen", address}, file("board.log"));
  ASSERT_TRUE(says(board, "ready")) << board.said();
  Running watch({PIZARRA_CELL, "watch", "--board", address, "(board-refusal ?who ? ? ?)"}, file("watch.log"));
  ASSERT_TRUE(says(watch, "[1] nothing yet")) << watch.said();
  board.signal(SIGKILL);
  ASSERT_EQ(board.end(patience), -SIGKILL);
  EXPECT_EQ(watch.end(seconds(7)), std::nullopt) << watch.said();
  EXPECT_EQ(watch.end(patience), 4) << watch.said();
  EXPECT_TRUE(watch.said().ends_with("\npizarra: the board has answered nothing for 10 s: \"" + address + "\"\n"))
      << watch.said();
}

}  // namespace
}  // namespace pizarra::programs
