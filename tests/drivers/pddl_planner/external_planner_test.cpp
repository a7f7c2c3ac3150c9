#include "drivers/pddl_planner/external_planner.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/scratch.hpp"

namespace pizarra::pddl_planner {
namespace {

const PlanOperators operators{{"pick-up", 1}, {"stack", 2}};
const PlanActions wanted{{"pick-up", "b1"}, {"stack", "b1", "b2"}};

// A folder for temporary files that is this test's alone, so that what is left over shows.
class ExternalPlannerTest : public testing::Test {
 protected:
  ExternalPlannerTest() : folder_(scratch_folder() + "planner") {
    std::filesystem::create_directory(folder_);
    setenv("TMPDIR", folder_.c_str(), 1);
  }
  ~ExternalPlannerTest() override {
    EXPECT_TRUE(std::filesystem::is_empty(folder_)) << "files are left over";
    std::filesystem::remove_all(folder_);
    setenv("TMPDIR", scratch_folder().c_str(), 1);
  }

  Result<PlanClaim> claim(const std::string& script, const ProcessLimits& limits = {}) {
    const ExternalPlanner planner(": {domain} {problem}; " + script, limits);
    return planner.plan("the domain", "the problem", operators, [this] { return cancelled_ && cancelled_(); });
  }
  Result<PlanActions> plan(const std::string& script, const ProcessLimits& limits = {}) {
    const Result<PlanClaim> claimed = claim(script, limits);
    if (!claimed) return fail(claimed);
    return claimed->actions;
  }
  std::string refusal(const std::string& script, const ProcessLimits& limits = {}) {
    const Result<PlanActions> actions = plan(script, limits);
    return actions ? "none" : actions.error().symbol;
  }

  std::string folder_;
  std::function<bool()> cancelled_;
};

TEST_F(ExternalPlannerTest, ReadsThePlanThatIsWrittenToItsFile) {
  EXPECT_EQ(plan("echo '(pick-up b1)\n(stack b1 b2)' > {plan}").value(), wanted);
}

TEST_F(ExternalPlannerTest, ReadsThePlanThatIsPrinted) {
  EXPECT_EQ(plan("echo 'step 0: PICK-UP B1'; echo '     1: STACK B1 B2'").value(), wanted);
}

TEST_F(ExternalPlannerTest, ReadsTheLastOfNumberedPlans) {
  EXPECT_EQ(plan("echo '(stack b1 b2)' > {plan}.1; echo '(pick-up b1)\n(stack b1 b2)' > {plan}.2").value(), wanted);
}

TEST_F(ExternalPlannerTest, GivesThePlannerItsFiles) {
  EXPECT_TRUE(
      plan("test \"$(cat {domain})\" = 'the domain' && test \"$(cat {problem})\" = 'the problem' && : > {plan}"));
}

TEST_F(ExternalPlannerTest, AnEmptyPlanIsAPlan) { EXPECT_TRUE(plan(": > {plan}").value().empty()); }

TEST_F(ExternalPlannerTest, TellsEveryWayToFailApart) {
  EXPECT_EQ(refusal("exec /nowhere/planner"), "planner-missing");
  EXPECT_EQ(refusal("kill -SEGV $$"), "planner-crashed");
  EXPECT_EQ(refusal("sh -c 'kill -SEGV $$'; exit $?"), "planner-crashed");
  EXPECT_EQ(refusal("echo unsolvable; exit 12"), "planner-failed");
  EXPECT_EQ(refusal("exit 128"), "planner-failed");
  EXPECT_EQ(refusal("exit 255"), "planner-failed");
  EXPECT_EQ(refusal("echo hello"), "garbage");
  EXPECT_EQ(refusal("echo hello > {plan}"), "garbage");
  EXPECT_EQ(refusal("head -c 100000 /dev/urandom"), "garbage");
  EXPECT_EQ(refusal("yes", {.output_bytes = 100'000}), "too-much-output");
  EXPECT_EQ(ExternalPlanner("ff {domain}").plan("", "", operators, [] { return false; }).error().symbol, "bad-command");
}

// Whether its plan works is for others to find out: then how it ended does not matter.
TEST_F(ExternalPlannerTest, HandsOnThePlanOfOneThatEndedBadlyWithHowItEnded) {
  const std::string write = "echo '(pick-up b1)\n(stack b1 b2)' > {plan}; ";
  EXPECT_FALSE(claim(write)->ended);
  for (const auto& [end, symbol] : {std::pair{"kill -SEGV $$", "planner-crashed"},
                                    {"exit 139", "planner-crashed"},
                                    {"exit 1", "planner-failed"},
                                    {"sleep 100", "time-out"}}) {
    const Result<PlanClaim> claimed = claim(write + end, {.seconds = 0.3});
    ASSERT_TRUE(claimed) << end;
    EXPECT_EQ(claimed->actions, wanted);
    EXPECT_EQ(claimed->ended.value().symbol, symbol);
  }
}

TEST_F(ExternalPlannerTest, TellsHowThePlannerEndedBeforeWhatIsWrongWithThePlanItLeft) {
  const std::string half = "echo '(pick-up b1)' > {plan}; printf '(stack b1' >> {plan}; ";
  EXPECT_EQ(refusal(half), "garbage");
  EXPECT_EQ(refusal(half + "kill -SEGV $$"), "planner-crashed");
  EXPECT_EQ(refusal(half + "exit 1"), "planner-failed");
  EXPECT_EQ(refusal(half + "sleep 100", {.seconds = 0.2}), "time-out");
}

TEST_F(ExternalPlannerTest, RefusesAPlanThatIsNoPlainFile) {
  for (const std::string leave : {"mkdir {plan}", "mkfifo {plan}", "ln -s /dev/zero {plan}", "ln -s {problem} {plan}",
                                  "echo '(pick-up b1)' > {plan}; mkdir {plan}.1"}) {
    EXPECT_EQ(refusal(leave, {.seconds = 20}), "garbage") << leave;
  }
}

TEST_F(ExternalPlannerTest, RefusesAPlanThatIsTooLong) {
  EXPECT_EQ(refusal("truncate -s 200000 {plan}", {.output_bytes = 100'000}), "too-much-output");
}

TEST_F(ExternalPlannerTest, RepeatsWhatThePlannerSaidLast) {
  EXPECT_EQ(plan("echo first; echo 'no :adl here'; exit 3").error().sentence,
            "the planner ended with status 3 and without a plan; it said: no :adl here");
}

TEST_F(ExternalPlannerTest, NamesTheSignalThatAShellTellsAsAStatus) {
  EXPECT_EQ(plan("echo searching; exit 139").error().sentence,
            "the planner was ended by Segmentation fault; it said: searching");
}

TEST_F(ExternalPlannerTest, EndsAPlannerThatTakesTooLong) {
  EXPECT_EQ(refusal("sleep 100", {.seconds = 0.2}), "time-out");
  EXPECT_EQ(refusal("exec >/dev/null 2>&1; sleep 100", {.seconds = 0.2}), "time-out");
  EXPECT_EQ(refusal("trap '' TERM INT; while :; do :; done", {.seconds = 0.2}), "time-out");
}

TEST_F(ExternalPlannerTest, EndsAPlannerThatWantsTooMuchMemory) {
  const std::string all = "exec python3 -c 'x = bytearray(1 << 30)'";
  const std::string symbol = refusal(all, {.memory_bytes = 256 << 20});
  EXPECT_TRUE(symbol == "planner-failed" || symbol == "planner-missing") << symbol;
}

// The child of a child that would write a file later is gone with them.
TEST_F(ExternalPlannerTest, LeavesNoProcessBehindWhenItIsStopped) {
  const std::string alive = folder_ + "_alive";
  std::filesystem::remove(alive);
  cancelled_ = [&] { return std::filesystem::exists(alive); };
  EXPECT_EQ(refusal(fmt::format("(while :; do echo $$ > {}; sleep 0.01; done) & wait", alive)), "cancelled");
  std::filesystem::remove(alive);
  usleep(100'000);  // what is still alive would have made it anew
  EXPECT_FALSE(std::filesystem::exists(alive));
}

TEST_F(ExternalPlannerTest, LeavesNoProcessBehindWhenThePlannerEndsFirst) {
  const std::string alive = folder_ + "_alive";
  EXPECT_TRUE(plan(fmt::format("(while :; do echo x > {}; sleep 0.01; done) & : > {{plan}}", alive)));
  std::filesystem::remove(alive);
  usleep(100'000);
  EXPECT_FALSE(std::filesystem::exists(alive));
}

// In a session of its own, its parent gone, and so out of reach of signals to the planner's group.
TEST_F(ExternalPlannerTest, LeavesNoProcessBehindThatLeftThePlannersSession) {
  const std::string alive = folder_ + "_alive";
  const std::string script = folder_ + "_script";
  std::ofstream(script) << fmt::format("while :; do echo x > {}; sleep 0.01; done", alive);
  const std::string leave =
      fmt::format("(setsid setsid sh {} &); while [ ! -e {} ]; do sleep 0.01; done; ", script, alive);
  for (const std::string end : {": > {plan}", "sleep 100", "kill -SEGV $$", "yes"}) {
    std::filesystem::remove(alive);
    plan(leave + end, {.seconds = 0.5, .output_bytes = 100'000});
    std::filesystem::remove(alive);
    usleep(100'000);
    EXPECT_FALSE(std::filesystem::exists(alive)) << end;
  }
  std::filesystem::remove(script);
}

// One that dies without a word, here by SIGKILL, takes what it had started with it.
TEST_F(ExternalPlannerTest, LeavesNoProcessBehindWhereItIsKilledItself) {
  const std::string alive = folder_ + "_alive";
  std::filesystem::remove(alive);
  const pid_t caller = fork();
  if (caller == 0) {
    plan(fmt::format("(while :; do echo x > {}; sleep 0.01; done) & sleep 100", alive));
    _exit(0);
  }
  while (!std::filesystem::exists(alive)) usleep(10'000);
  kill(caller, SIGKILL);
  waitpid(caller, nullptr, 0);
  usleep(100'000);
  std::filesystem::remove(alive);
  usleep(100'000);
  EXPECT_FALSE(std::filesystem::exists(alive));
  for (const auto& left : std::filesystem::directory_iterator(folder_)) std::filesystem::remove_all(left);
}

}  // namespace
}  // namespace pizarra::pddl_planner
