// `up` binds the processes that it keeps running.

#include "agents/launcher/host_names.hpp"

#include <gtest/gtest.h>

#include "agents/runtime/naming.hpp"
#include "agents/runtime/service.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/run_task.hpp"

namespace pizarra::launcher {
namespace {

class HostNames : public testing::Test {
 protected:
  void SetUp() override {
    run(executor, robot.start()).value();
    lease = run(executor, ears->lease(4s)).value();
  }
  void tell(std::vector<Supervisor::Process> processes) {
    const Job job = executor.spawn(bind_processes(*ears, "bench", std::move(processes), lease));
    executor.run_until([&] { return job.done(); });
  }
  // The names of this host.
  std::vector<std::string> bound() {
    std::vector<std::string> names;
    const Datum pattern = list("bound"_sym, list("cell"_sym, "hosts"_sym, "bench"_sym), "?"_sym, "?"_sym, "?"_sym);
    const std::vector<Fact> facts = run(executor, ears->facts(pattern)).value();
    for (const Fact& fact : facts) names.push_back(write(fact.datum));
    return names;
  }

  VirtualExecutor executor;
  memory::MemoryBoard board{executor};
  std::unique_ptr<Board> ears = board.view("narrator");
  std::unique_ptr<Board> view = board.view("arm");
  runtime::AgentContext context{"arm", "bench", executor, *view, Random(1)};
  runtime::Service robot{context, runtime::contract_from_text("(contract robot)").value()};
  LeaseId lease = 0;
};

const std::string arm = "(bound (cell hosts bench) arm robot arm)";

TEST_F(HostNames, AreThoseOfItsAgentsByNameAndKind) {
  tell({{"arm", 17}, {"board", 18}});
  EXPECT_EQ(bound(), std::vector<std::string>{arm});
}

TEST_F(HostNames, StayWhileAProcessIsStartedAgainAndGoWhenItHasEndedForGood) {
  tell({{"arm", 17}});
  tell({{"arm", 0, 1, "killed by signal 9; starts again in 0.5 s"}});
  EXPECT_EQ(bound(), std::vector<std::string>{arm});
  tell({{"arm", 0, 12, "ended with status 2; to start it again would not help", true}});
  EXPECT_EQ(bound(), std::vector<std::string>());
}

TEST_F(HostNames, GoWithTheLauncher) {
  tell({{"arm", 17}});
  executor.run_for(5s);
  EXPECT_EQ(bound(), std::vector<std::string>());
}

TEST_F(HostNames, LeaveOutWhatRunsElsewhereUnderTheName) {
  const std::unique_ptr<Board> other = board.view("eyes");
  runtime::AgentContext elsewhere{"eyes", "desk", executor, *other, Random(1)};
  runtime::Service eyes{elsewhere, runtime::contract_from_text("(contract vision)").value()};
  run(executor, eyes.start()).value();
  tell({{"eyes", 19}});
  EXPECT_EQ(bound(), std::vector<std::string>());
}

}  // namespace
}  // namespace pizarra::launcher
