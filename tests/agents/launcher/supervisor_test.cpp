#include "agents/launcher/supervisor.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "blackboard/time/real_executor.hpp"
#include "tests/scratch.hpp"

namespace pizarra::launcher {
namespace {

struct Watched {
  RealExecutor executor;
  std::vector<std::string> told;
  Supervisor supervisor{executor, [this](const ProcessEvent& event) { told.push_back(event.sentence); }};
  std::string log = scratch_folder() + "supervised.log";

  Result<void> start(const std::string& script) { return supervisor.start({"script", {"/bin/sh", "-c", script}, log}); }
  void run_until(std::function<bool()> finished) {
    const Time deadline = executor.now() + 20s;
    executor.call_at(deadline, [this] { executor.stop(); });
    executor.run_until(std::move(finished));
  }
  // The executor looks whether it is finished after each event, and a file that grows is none.
  void look_often() {
    executor.call_at(executor.now() + 10ms, [this] { look_often(); });
  }
  void stop() {
    supervisor.stop();
    run_until([this] { return supervisor.stopped(); });
  }
};

TEST(Supervisor, StartsAgainWhatDies) {
  Watched watched;
  ASSERT_TRUE(watched.start("exit 3"));
  watched.run_until([&] { return watched.supervisor.processes()[0].restarts >= 2; });
  EXPECT_GE(watched.supervisor.processes()[0].restarts, 2);
  EXPECT_EQ(watched.told[1], "ended with status 3; starts again in 0.25 s");
  EXPECT_EQ(watched.told[3], "ended with status 3; starts again in 0.5 s");
  watched.stop();
}

TEST(Supervisor, TriesAgainWhereAProcessCannotBeStarted) {
  Watched watched;
  const std::string folder = scratch_folder() + "away";
  std::filesystem::create_directory(folder);
  watched.log = folder + "/supervised.log";
  ASSERT_TRUE(watched.start("exec sleep 100"));
  std::filesystem::remove_all(folder);
  kill(watched.supervisor.processes()[0].pid, SIGKILL);
  const auto could_not = [&] { return watched.told.back().starts_with("cannot write"); };
  watched.run_until(could_not);
  ASSERT_TRUE(could_not()) << watched.told.back();
  std::filesystem::create_directory(folder);
  watched.run_until([&] { return watched.supervisor.processes()[0].pid != 0; });
  EXPECT_NE(watched.supervisor.processes()[0].pid, 0);
  watched.stop();
}

TEST(Supervisor, DoesNotStartAgainWhatEndsWithAFinalStatus) {
  Watched watched;
  ASSERT_TRUE(watched.supervisor.start({"script", {"/bin/sh", "-c", "exit 3"}, watched.log, {2, 3}}));
  watched.run_until([&] { return watched.told.size() >= 2; });
  EXPECT_EQ(watched.told[1], "ended with status 3; to start it again would not help");
  EXPECT_EQ(watched.supervisor.processes()[0].restarts, 0);
  watched.stop();
}

TEST(Supervisor, SaysWhichSignalKilledAProcess) {
  Watched watched;
  ASSERT_TRUE(watched.start("kill -9 $$"));
  watched.run_until([&] { return watched.told.size() >= 2; });
  EXPECT_EQ(watched.told[1], "killed by signal 9; starts again in 0.25 s");
  watched.stop();
}

TEST(Supervisor, StopsEverythingEvenWhatIgnoresTheFirstSignal) {
  Watched watched;
  ASSERT_TRUE(watched.start("trap '' TERM; while true; do sleep 0.1; done"));
  ASSERT_TRUE(watched.start("exec sleep 100"));
  const std::vector<Supervisor::Process> running = watched.supervisor.processes();
  watched.stop();
  EXPECT_TRUE(watched.supervisor.stopped());
  for (const Supervisor::Process& process : running) EXPECT_NE(kill(process.pid, 0), 0);
}

TEST(Supervisor, StopsOnASignalToItself) {
  Watched watched;
  ASSERT_TRUE(watched.start("exec sleep 100"));
  kill(getpid(), SIGTERM);
  watched.run_until([&] { return watched.supervisor.stopped(); });
  EXPECT_TRUE(watched.supervisor.stopped());
}

TEST(Supervisor, KeepsWhatAProcessPrints) {
  Watched watched;
  std::filesystem::remove(watched.log);
  ASSERT_TRUE(watched.start("echo printed; exec sleep 100"));
  watched.look_often();
  watched.run_until(
      [&] { return std::filesystem::exists(watched.log) && std::filesystem::file_size(watched.log) > 7; });
  std::ifstream log(watched.log);
  std::string line;
  std::getline(log, line);
  EXPECT_EQ(line, "printed");
  watched.stop();
}

TEST(Supervisor, LetsTheOthersGoBeforeAProgramThatIsNice) {
  Watched watched;
  constexpr int most = 19;
  const int own = getpriority(PRIO_PROCESS, 0);
  const int nicer = std::min(own + 5, most);
  ASSERT_TRUE(watched.supervisor.start({"nice", {"/bin/sleep", "100"}, watched.log, {}, 5}));
  ASSERT_TRUE(watched.start("exec sleep 100"));
  const auto niceness = [&](std::size_t which) {
    return getpriority(PRIO_PROCESS, static_cast<id_t>(watched.supervisor.processes()[which].pid));
  };
  watched.look_often();
  watched.run_until([&] { return niceness(0) == nicer; });
  EXPECT_EQ(niceness(0), nicer);
  EXPECT_EQ(niceness(1), own);
  watched.stop();
}

TEST(Supervisor, RefusesWhatCannotBeRun) {
  Watched watched;
  const Result<void> started = watched.supervisor.start({"none", {"/nowhere/none"}, watched.log});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().symbol, "cannot-start");
}

}  // namespace
}  // namespace pizarra::launcher
