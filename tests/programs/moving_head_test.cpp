// A cell whose cameras stand on a pan-tilt unit: what they saw is placed rightly however the unit has turned them.

#include <cmath>
#include <gtest/gtest.h>

#include "agents/launcher/local_cell.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/programs/tapped_cell.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

Datum form(std::string_view text) { return read_one(text).value(); }

Task<void> call(simulation::Link& link, Datum request, std::optional<Result<simulation::Message>>& out) {
  out = co_await link.call(std::move(request), 20s);
}

forms::CellDescription cell_of(const std::string& file) {
  return forms::read_cell_file(source_dir() + "/" + file).value();
}

class MovingHead : public testing::Test {
 protected:
  explicit MovingHead(const forms::CellDescription& description = cell_of("examples/03-moving-head/cell.scm"))
      : cell(executor, description, 5) {}
  void SetUp() override {
    for (const std::string& kind : launcher::agent_kinds(cell.description())) ASSERT_TRUE(cell.start(kind)) << kind;
    const Result<void> built = teach_and_build(executor, cell.board(), {form("(on circle triangle)")});
    ASSERT_TRUE(built) << describe(built.error());
  }

  void ask(std::string_view agent, std::string_view operation) {
    Transaction request;
    const Datum id = Datum::symbol("r" + std::to_string(++asked));
    request.tell(list("request"_sym, id, Datum::symbol(agent), form(operation)));
    ASSERT_TRUE(cell.board().transact("user", request));
  }
  void ask_head(std::string_view operation) { ask("pan-tilt", operation); }
  // Why the second goal was refused, in words; empty while it is not.
  std::string refusal() {
    const std::optional<Datum> state = fact_like("(goal-state 2 refused ?why)");
    return state ? write(*state) : "";
  }
  bool runs_until_refused(Duration patience) {
    const Time deadline = executor.now() + patience;
    executor.run_until([&] { return !refusal().empty() || executor.now() > deadline; });
    return !refusal().empty();
  }
  std::optional<Datum> fact_like(std::string_view pattern) {
    const Result<Answers> answers = cell.board().ask(query_from_datum(form(pattern)).value());
    if (!answers || answers->answers.empty()) return std::nullopt;
    return answers->answers.front().facts.front().datum;
  }
  Datum ask_world(std::string_view request) {
    std::optional<Result<simulation::Message>> answer;
    const Job job = executor.spawn(call(cell.link(), form(request), answer));
    executor.run_until([&] { return answer.has_value(); });
    EXPECT_TRUE(*answer) << request;
    return *answer ? (*answer)->head : Datum();
  }
  // How far from its mark's true place an object is told to be, mm; 1000 where nothing is told.
  double error_of(const std::string& name) {
    const std::optional<Datum> place = fact_like("(place " + name + " ?x ?y ?z ?frame)");
    if (!place) return 1000;
    const Datum truth = ask_world("(truth)");
    for (const Datum& cube : truth.items()) {
      if (!cube.is_form("cube") || !cube[1].is_symbol(name)) continue;
      const double yaw = cube[5].number() * M_PI / 180;
      const double x = cube[2].number() + 30 * std::cos(yaw);
      const double y = cube[3].number() + 30 * std::sin(yaw);
      return std::hypot((*place)[2].number() - x, (*place)[3].number() - y, (*place)[4].number() - cube[4].number());
    }
    return 1000;
  }
  double pan() {
    const std::optional<Datum> head = fact_like("(head ?p ?t still)");
    return head ? (*head)[1].number() : 1000;
  }

  VirtualExecutor executor;
  launcher::LocalCell cell;
  int asked = 0;
};

TEST_F(MovingHead, TheGoalIsReachedAndPlacesStayTrueWhereverTheHeadLooks) {
  const double before_mm = error_of("square");
  EXPECT_LT(before_mm, 8);
  for (const char* turn : {"(set-pan-pos 4)", "(set-tilt-pos -5)", "(set-pan-pos -4)", "(look-ahead)"}) {
    ask_head(turn);
    executor.run_for(4s);
    for (const char* name : {"circle", "triangle", "square", "cross"})
      EXPECT_LT(error_of(name), 8) << turn << ", " << name;
  }
}

// The unit's axes pass beside the camera, and the agents know them as well as a calibration tells them.
forms::CellDescription calibrated_cell() {
  forms::CellDescription cell = cell_of("tests/scenarios/cells/leaning-head.scm");
  cell.camera.pose = cell.world_camera;
  cell.camera.sure_mm = 0.5;
  cell.camera.sure_deg = 0.05;
  return cell;
}

class LeaningHead : public MovingHead {
 protected:
  LeaningHead() : MovingHead(calibrated_cell()) {}
};

TEST_F(LeaningHead, PlacesStayTrueWhereverTheHeadLooks) {
  for (const char* turn : {"(set-pan-pos 5)", "(set-tilt-pos -6)", "(set-pan-pos -5)", "(look-ahead)"}) {
    ask_head(turn);
    executor.run_for(4s);
    for (const char* name : {"circle", "triangle", "square", "cross"})
      EXPECT_LT(error_of(name), 8) << turn << ", " << name;
  }
}

TEST_F(MovingHead, WhileItTurnsNothingIsToldToBeElsewhere) {
  ask_head("(set-pan-speed 2)");
  ask_head("(set-pan-pos 8)");
  const Time end = executor.now() + 4s;
  while (executor.now() < end) {
    executor.run_for(50ms);
    ASSERT_LT(error_of("square"), 8);
  }
  EXPECT_NEAR(pan(), 8, 0.06);
}

TEST_F(MovingHead, LooksAtAnObjectAndKeepsItInTheMiddleWhenAHandMovesIt) {
  ask_head("(look-at cross)");
  executor.run_for(3s);
  const double before_deg = pan();
  ask_world("(hand place cross 560 -60)");
  executor.run_for(8s);
  EXPECT_LT(error_of("cross"), 10);
  EXPECT_LT(pan(), before_deg - 10);
  const Datum seen = ask_world("(where-seen cross)");
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(seen[0].number(), 160, 60);
  EXPECT_NEAR(seen[1].number(), 120, 60);
}

TEST_F(MovingHead, LooksAroundForAMissingBlockAndTurnsBackWhereItIsNowhere) {
  ask_head("(set-pan-pos 3)");
  executor.run_for(2s);
  ask_world("(hand remove cross)");
  ask("coordinator", "(goal (on cross square))");
  double furthest_deg = 0;
  const Time deadline = executor.now() + 300s;
  while (refusal().empty() && executor.now() < deadline) {
    executor.run_for(100ms);
    if (pan() < 900) furthest_deg = std::max(furthest_deg, std::abs(pan()));
  }
  EXPECT_NE(refusal().find("cross is not seen, and the head looked in "), std::string::npos) << refusal();
  EXPECT_GT(furthest_deg, 10);
  EXPECT_NEAR(pan(), 3, 0.1);
}

TEST_F(MovingHead, IsLeftAloneWhileItKeepsAnObjectInViewForSomebodyAndTheRefusalSaysSo) {
  ask_head("(look-at square)");
  executor.run_for(3s);
  const double before_deg = pan();
  ask_world("(hand remove cross)");
  ask("coordinator", "(goal (on cross square))");
  ASSERT_TRUE(runs_until_refused(300s));
  EXPECT_NE(refusal().find("somebody has it keep square in view"), std::string::npos) << refusal();
  EXPECT_NEAR(pan(), before_deg, 0.1);
}

TEST_F(MovingHead, DoesNotTurnUnderAStopAndLooksAroundOnceThatIsRetracted) {
  Transaction stop;
  stop.tell(form("(stop me \"wait\")"));
  ASSERT_TRUE(cell.board().transact("user", stop));
  ask_world("(hand remove cross)");
  ask("coordinator", "(goal (on cross square))");
  const Time end = executor.now() + 30s;
  while (executor.now() < end) {
    executor.run_for(100ms);
    ASSERT_NEAR(pan(), 0, 0.1);
  }
  EXPECT_EQ(refusal(), "");
  Transaction go_on;
  go_on.retract(form("(stop me ?)"));
  ASSERT_TRUE(cell.board().transact("user", go_on));
  ASSERT_TRUE(runs_until_refused(300s));
  EXPECT_NE(refusal().find("the head looked in "), std::string::npos) << refusal();
}

TEST_F(MovingHead, AHeadThatLosesItsPowerIsWaitedForAndTheCellGoesOn) {
  ask_head("(set-pan-pos 7)");
  executor.run_for(300ms);
  ask_world("(head power off)");
  executor.run_for(3s);
  EXPECT_FALSE(fact_like("(head ?p ?t ?s)"));
  EXPECT_LT(error_of("square"), 8);
  ask_world("(head power on)");
  executor.run_for(40s);
  EXPECT_EQ(pan(), 0);
  EXPECT_LT(error_of("square"), 8);
}

}  // namespace
}  // namespace pizarra::programs
