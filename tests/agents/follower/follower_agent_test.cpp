// The cell of examples/06-master-and-slave: an UP6 that follows a CRS-F3 through facts alone.

#include "agents/follower/follower_agent.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "agents/launcher/local_cell.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::follower {
namespace {

using Eigen::Vector3d;

// At half the master's speed.
constexpr Duration longest_lag = 600ms;
constexpr double off_the_way_mm = 2;

Datum form(std::string_view text) { return read_one(text).value(); }

// How far a point is from a way given by points on it.
double off_mm(const std::deque<Vector3d>& way, const Vector3d& point) {
  double nearest = (point - way.front()).norm();
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vector3d piece = way[i] - way[i - 1];
    const double along =
        piece.norm() == 0 ? 0 : std::clamp((point - way[i - 1]).dot(piece) / piece.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (point - way[i - 1] - along * piece).norm());
  }
  return nearest;
}

class Follower : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* kind : {"robot", "slave", "follower"}) ASSERT_TRUE(cell.start(kind)) << kind;
    executor.run_for(2s);
  }

  std::string ask(std::string_view agent, std::string_view operation) {
    std::string id = fmt::format("r{}", ++asked);
    Transaction request;
    request.tell(list("request"_sym, Datum::symbol(id), Datum::symbol(agent), form(operation)));
    EXPECT_TRUE(cell.board().transact("user", request)) << operation;
    return id;
  }
  std::string reply(const std::string& id) {
    const std::optional<Datum> fact = fact_like(fmt::format("(reply {} ?answer)", id));
    return fact ? write((*fact)[2]) : "";
  }
  std::string call(std::string_view agent, std::string_view operation) {
    const std::string id = ask(agent, operation);
    const Time deadline = executor.now() + 60s;
    executor.run_until([&] { return !reply(id).empty() || executor.now() > deadline; });
    return reply(id);
  }
  std::optional<Datum> fact_like(std::string_view pattern) {
    const Result<Answers> answers = cell.board().ask(query_from_datum(form(pattern)).value());
    if (!answers || answers->answers.empty()) return std::nullopt;
    return answers->answers.front().facts.front().datum;
  }
  std::string state() {
    const std::optional<Datum> fact = fact_like("(following slave robot ?state ?detail)");
    return fact ? std::string((*fact)[3].text()) : "";
  }
  Datum detail() { return (*fact_like("(following slave robot ?state ?detail)"))[4]; }
  Vector3d place(std::string_view robot) {
    const std::optional<Datum> pose = fact_like(fmt::format("(arm-pose {} ? ? ? ? ? ?)", robot));
    return pose ? Vector3d((*pose)[2].number(), (*pose)[3].number(), (*pose)[4].number()) : Vector3d(0, 0, 0);
  }
  // Where the slave is to be while the master is where it is.
  Vector3d wanted() { return place("robot").cwiseProduct(Vector3d(1, -1, 1)) + Vector3d(200, 0, 0); }
  double apart_mm() { return (place("slave") - wanted()).norm(); }
  // Until the slave has come to where the master stands.
  void settle() { executor.run_for(5s); }

  VirtualExecutor executor;
  launcher::LocalCell cell{executor,
                           forms::read_cell_file(source_dir() + "/examples/06-master-and-slave/cell.scm").value(), 1};
  int asked = 0;
};

TEST_F(Follower, RestsUntilItIsAskedToFollow) {
  const Vector3d before = place("slave");
  EXPECT_EQ(state(), "resting");
  EXPECT_EQ(call("robot", "(move-h right 50)"), "(ok true)");
  settle();
  EXPECT_EQ(place("slave"), before);
}

TEST_F(Follower, SlaveIsWhereTheMasterWasOnlyShortlyBeforeAllAlongAPath) {
  EXPECT_EQ(call("follower", "(follow)"), "(ok)");
  settle();
  EXPECT_EQ(state(), "following");
  EXPECT_LT(apart_mm(), 1);
  EXPECT_EQ(call("robot", "(speed 50)"), "(ok true)");
  std::deque<Vector3d> ways;
  double worst_mm = 0;
  Duration worst_lag{};
  constexpr Duration step = 20ms;
  for (const char* operation : {"(move-h right 150)", "(move-v down 120)", "(extend keep-height 80)", "(turn left 30)",
                                "(do-action \"(circle (400 -60 300) (430 -90 300) (460 -60 300))\")", "(ready)"}) {
    const std::string id = ask("robot", operation);
    while (reply(id).empty()) {
      executor.run_for(step);
      ways.push_front(wanted());
      if (ways.size() > static_cast<std::size_t>(longest_lag / step)) ways.pop_back();
      worst_mm = std::max(worst_mm, off_mm(ways, place("slave")));
    }
    EXPECT_EQ(reply(id), "(ok true)") << operation;
    const Time stood = executor.now();
    executor.run_until([&] { return apart_mm() < 1 || executor.now() - stood > 10s; });
    worst_lag = std::max(worst_lag, executor.now() - stood);
  }
  EXPECT_LT(worst_mm, off_the_way_mm);
  EXPECT_LT(worst_lag, longest_lag);
  EXPECT_EQ(state(), "following");
}

TEST_F(Follower, MastersEndStopsTheSlaveAndItGoesOnOnlyWhenAsked) {
  call("follower", "(follow)");
  settle();
  call("robot", "(speed 5)");
  ask("robot", "(move-h right 150)");
  executor.run_for(2s);
  ASSERT_TRUE(cell.kill("robot"));
  executor.run_for(3s);
  EXPECT_EQ(state(), "broken");
  EXPECT_EQ(detail()[1].text(), "absent");
  const Vector3d stands = place("slave");
  ASSERT_TRUE(cell.start("robot"));
  settle();
  EXPECT_EQ(call("robot", "(ready)"), "(ok true)");
  settle();
  EXPECT_EQ(place("slave"), stands);
  EXPECT_EQ(call("follower", "(follow)"), "(ok)");
  settle();
  EXPECT_LT(apart_mm(), 1);
}

TEST_F(Follower, SlaveAtItsLimitSaysWhichAxisAndGoesOnWhenTheMasterIsBack) {
  call("follower", "(follow)");
  settle();
  EXPECT_EQ(call("robot", "(turn right 175)"), "(ok true)");
  settle();
  EXPECT_EQ(state(), "limited") << write(detail());
  EXPECT_EQ(detail()[1].text(), "joint-limit");
  EXPECT_NE(detail()[2].text().find("axis 1"), std::string::npos) << write(detail());
  EXPECT_EQ(call("robot", "(ready)"), "(ok true)");
  settle();
  EXPECT_EQ(state(), "following");
  EXPECT_LT(apart_mm(), 1);
}

TEST_F(Follower, OthersCommandTheSlaveOnlyWhileItDoesNotFollow) {
  EXPECT_EQ(call("slave", "(move-v down 30)"), "(ok true)");
  call("follower", "(follow)");
  settle();
  EXPECT_EQ(form(call("slave", "(move-v down 30)"))[1].text(), "not-commander");
  EXPECT_EQ(call("follower", "(rest)"), "(ok)");
  EXPECT_EQ(call("slave", "(move-v down 30)"), "(ok true)");
}

TEST_F(Follower, SlavesOwnReflexBreaksItOff) {
  call("follower", "(follow)");
  settle();
  call("robot", "(move-h right 20)");
  settle();
  Transaction stop;
  stop.tell(form("(stop user \"enough\")"));
  ASSERT_TRUE(cell.board().transact("user", stop));
  const Vector3d stands = place("slave");
  Transaction resume;
  resume.retract(form("(stop user ?)"));
  executor.run_for(500ms);
  EXPECT_EQ(place("slave"), stands);
  ASSERT_TRUE(cell.board().transact("user", resume));
  EXPECT_EQ(state(), "following") << "nothing was to be done";
}

// A robot of which there are facts alone.
TEST_F(Follower, FollowsWhoeverIsWiredAsTheMasterAndGoesToNoOtherUnasked) {
  const auto robot_2_at = [this](double y_mm) {
    Transaction says;
    says.tell(form("(agent robot-2 robot \"localhost\")"));
    says.tell(form(fmt::format("(arm-pose robot-2 420.0 {:.1f} 300.0 0.0 90.0 0.0)", y_mm)));
    ASSERT_TRUE(cell.board().transact("robot-2", says));
    settle();
  };
  const auto wire = [this](std::string_view master) {
    Transaction wiring;
    wiring.tell(list("wired"_sym, "follower"_sym, "master"_sym, Datum::symbol(master)));
    ASSERT_TRUE(cell.board().transact("user", wiring));
    settle();
  };
  robot_2_at(-60);
  wire("robot-2");
  EXPECT_EQ(call("follower", "(follow)"), "(ok)");
  settle();
  EXPECT_LT((place("slave") - Vector3d(620, 60, 300)).norm(), 1);
  robot_2_at(20);
  EXPECT_LT((place("slave") - Vector3d(620, -20, 300)).norm(), 1);
  wire("robot");
  const std::optional<Datum> broken = fact_like("(following slave robot-2 broken ?detail)");
  ASSERT_TRUE(broken.has_value());
  EXPECT_EQ((*broken)[4][1].text(), "replaced");
  EXPECT_LT((place("slave") - Vector3d(620, -20, 300)).norm(), 1);
  EXPECT_EQ(call("follower", "(follow)"), "(ok)");
  settle();
  EXPECT_EQ(state(), "following");
  EXPECT_LT(apart_mm(), 1);
}

TEST_F(Follower, NobodyToFollowIsSaid) {
  ASSERT_TRUE(cell.kill("slave"));
  executor.run_for(3s);
  EXPECT_EQ(form(call("follower", "(follow)"))[1].text(), "absent");
  ASSERT_TRUE(cell.start("slave"));
  ASSERT_TRUE(cell.kill("robot"));
  executor.run_for(3s);
  EXPECT_EQ(form(call("follower", "(follow)"))[1].text(), "absent");
}

}  // namespace
}  // namespace pizarra::follower
