// The example cell as processes, in real time: whoever is killed is started again and the goal is reached all the same;
// however `up` ends, no process outlives it.

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

#include "tests/programs/running.hpp"
#include "tests/programs/taught_cell.hpp"
#include "tests/scratch.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

// Much longer than anything here takes on a machine that does nothing else.
constexpr seconds patience{90};
constexpr seconds stop_time{10};
constexpr std::size_t processes = 8;  // up, the board, the world and five agents

struct Shown {
  pid_t pid = 0;  // 0: not running
  int restarts = -1;
};

class UpKilled : public testing::Test {
 protected:
  void SetUp() override { start(); }

  void start() { up_.emplace(std::vector<std::string>{PIZARRA_CELL, "up", cell_file_}, folder_ + "up.log"); }
  std::string say(std::vector<std::string> words) {
    words.insert(words.begin(), PIZARRA_CELL);
    Running running(std::move(words), folder_ + "said.log");
    running.end(patience);
    return running.said();
  }
  // Whether a query of the variable ?x comes to have an answer.
  bool comes(const std::string& query) {
    return wait_until([&] { return say({"ask", query}).find("?x = ") != std::string::npos; }, patience);
  }
  Shown shown(const std::string& process) {
    const std::string text = say({"ps", "--json"});
    const std::size_t line = text.find("\"name\":\"" + process + "\"");
    if (line == std::string::npos) return {};
    const auto number = [&](const std::string& key) {
      return std::atoi(text.c_str() + text.find("\"" + key + "\":", line) + key.size() + 3);
    };
    return {number("pid"), number("restarts")};
  }
  // Every process whose command line names this test's folder, which all of the cell's do; zombies have none.
  std::vector<std::string> cell_processes() {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
      const std::string command = whole_file(entry.path().string() + "/cmdline");
      if (command.find(folder_) != std::string::npos) found.push_back(entry.path().filename().string() + " " + command);
    }
    return found;
  }
  bool nothing_runs(seconds how_long) {
    return wait_until([this] { return cell_processes().empty(); }, how_long);
  }
  // The sockets and state in the run's folder: what a stopped cell does not leave behind.
  std::vector<std::string> remains() {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ + "pizarra")) {
      if (entry.is_socket() || entry.path().filename() == "state") found.push_back(entry.path().string());
    }
    return found;
  }

  // Kills them all as soon as the query has an answer, while the goal is pursued, and waits until other processes have
  // taken their places.
  void kill_when(const std::string& query, const std::vector<std::string>& agents) {
    std::map<std::string, Shown> before;
    for (const std::string& agent : agents) before[agent] = shown(agent);
    ASSERT_TRUE(comes(query)) << up_->said();
    killed_ = std::chrono::steady_clock::now();
    for (const auto& [agent, process] : before) {
      ASSERT_GT(process.pid, 0) << agent << '\n' << up_->said();
      ASSERT_EQ(kill(process.pid, SIGKILL), 0);
    }
    for (const auto& [agent, process] : before) {
      const auto restarted = [&, &name = agent, &old = process] {
        const Shown now = shown(name);
        return now.restarts > old.restarts && now.pid > 0 && now.pid != old.pid;
      };
      EXPECT_TRUE(wait_until(restarted, patience)) << agent << '\n' << up_->said();
    }
  }
  void stop_cleanly() {
    EXPECT_EQ(cell_processes().size(), processes);
    up_->signal(SIGINT);
    EXPECT_EQ(up_->end(stop_time), 0) << up_->said();
    EXPECT_EQ(cell_processes(), std::vector<std::string>());
    EXPECT_EQ(remains(), std::vector<std::string>());
    EXPECT_EQ(say({"ps"}), "no cell runs here\n");
  }

  const std::string folder_ = scratch_folder();
  const std::string cell_file_ = taught_cell(PIZARRA_CELL) + "cell.scm";
  std::optional<Running> up_;
  std::chrono::steady_clock::time_point killed_;
};

TEST_F(UpKilled, ACoordinatorKilledWhileItPicksUpGoesOnAndReachesTheGoal) {
  ASSERT_TRUE(comes("(person done ?x)")) << up_->said();
  Running goal({PIZARRA_CELL, "repl", "--eval", "(goal (on circle triangle))"}, folder_ + "goal.log");
  kill_when("(operation ? (PICK-UP ?x) running)", {"coordinator"});
  EXPECT_EQ(goal.end(patience), 0) << goal.said() << up_->said();
  stop_cleanly();
}

TEST_F(UpKilled, VisionAndPlannerKilledWhileABlockIsHeldComeBackAndTheGoalIsReached) {
  ASSERT_TRUE(comes("(person done ?x)")) << up_->said();
  Running goal({PIZARRA_CELL, "repl", "--eval", "(goal (on circle triangle))"}, folder_ + "goal.log");
  kill_when("(holding ?x)", {"vision", "planner"});
  EXPECT_EQ(goal.end(patience), 0) << goal.said() << up_->said();
  stop_cleanly();
}

TEST_F(UpKilled, ABoardKilledWhileABlockIsHeldLivesAgainWithWhatIsDurableAndTheGoalIsReached) {
  ASSERT_TRUE(comes("(person done ?x)")) << up_->said();
  Running goal({PIZARRA_CELL, "repl", "--eval", "(goal (on circle triangle))"}, folder_ + "goal.log");
  kill_when("(holding ?x)", {"board"});
  EXPECT_TRUE(comes("(goal-state ?x reached ?)")) << goal.said() << up_->said();
  const auto since = std::chrono::ceil<seconds>(std::chrono::steady_clock::now() - killed_);
  const std::string then = std::to_string(since.count()) + "s";
  EXPECT_EQ(say({"ask", "--at", then, "(goal-state ?x running ?)"}), "?x = 1\n") << "the past goes on, too";

  kill_when("(goal-state ?x reached ?)", {"board"});
  EXPECT_TRUE(comes("(on ?x triangle)")) << "what is believed is told again\n" << up_->said();
  const std::string why = say({"why"});
  EXPECT_NE(why.find("goal 1 is reached"), std::string::npos) << why;
  EXPECT_TRUE(comes("(person done ?x)")) << up_->said();
  const std::string story = up_->said();
  const std::string taught = "everything is taught";
  EXPECT_EQ(story.find(taught), story.rfind(taught)) << "nothing is told twice\n" << story;
  stop_cleanly();
}

TEST_F(UpKilled, NoProcessOutlivesAKilledUpAndTheNextOneStartsInItsPlace) {
  ASSERT_TRUE(wait_until([this] { return shown("vision").pid > 0 && cell_processes().size() == processes; }, patience))
      << up_->said();
  up_->signal(SIGKILL);
  EXPECT_EQ(up_->end(stop_time), -SIGKILL);
  EXPECT_TRUE(nothing_runs(stop_time)) << cell_processes().front();

  start();
  ASSERT_TRUE(comes("(agent ?x vision ?)")) << up_->said();
  up_->signal(SIGINT);
  EXPECT_EQ(up_->end(stop_time), 0) << up_->said();
  EXPECT_EQ(cell_processes(), std::vector<std::string>());
  EXPECT_EQ(remains(), std::vector<std::string>());
}

}  // namespace
}  // namespace pizarra::programs
