#include "agents/pan_tilt/pan_tilt_agent.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/ptu/ptu_driver.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/drivers/ptu/wire_to_unit.hpp"

namespace pizarra::pan_tilt {
namespace {

Datum form(std::string_view text) { return read_one(text).value(); }

// One life of the agent: destroying it is the agent's death.
class Life {
 public:
  Life(Executor& executor, memory::MemoryBoard& board, ptu::PanTiltDriver& driver)
      : view_(board.view("pan-tilt")),
        agent_({"pan-tilt", "localhost", executor, *view_, Random(1)}, driver, forms::CameraPose{}),
        job_(executor.spawn(live())) {}

 private:
  Task<void> live() {
    const Result<void> ended = co_await agent_.run();
    EXPECT_TRUE(ended) << describe(ended.error());
  }
  std::unique_ptr<Board> view_;
  PanTiltAgent agent_;
  Job job_;
};

class Head : public testing::Test {
 protected:
  void SetUp() override {
    life.emplace(executor, board, driver);
    executor.run_for(2s);
  }

  std::string ask(std::string_view operation) {
    const std::string id = fmt::format("r{}", ++asked);
    Transaction request;
    request.tell(list("request"_sym, Datum::symbol(id), "pan-tilt"_sym, form(operation)));
    EXPECT_TRUE(board.transact("user", request)) << operation;
    return id;
  }
  Datum reply(const std::string& id) {
    const std::optional<Datum> fact = fact_like(fmt::format("(reply {} ?answer)", id));
    return fact ? (*fact)[2] : Datum();
  }
  // The answer's values as text, or the failure's symbol.
  std::string call(std::string_view operation) {
    const std::string id = ask(operation);
    const Time deadline = executor.now() + 120s;
    executor.run_until([&] { return reply(id).size() > 0 || executor.now() > deadline; });
    const Datum answer = reply(id);
    return answer.is_form("fail") ? std::string(answer[1].text()) : write(answer);
  }
  std::optional<Datum> fact_like(std::string_view pattern) {
    const Result<Answers> answers = board.ask(query_from_datum(form(pattern)).value());
    if (!answers || answers->answers.empty()) return std::nullopt;
    return answers->answers.front().facts.front().datum;
  }
  std::string fact(std::string_view pattern) {
    const std::optional<Datum> found = fact_like(pattern);
    return found ? write(*found) : "";
  }
  double pan() {
    const std::optional<Datum> head = fact_like("(head ?p ?t still)");
    return head ? (*head)[1].number() : 999;
  }
  double tilt() {
    const std::optional<Datum> head = fact_like("(head ?p ?t still)");
    return head ? (*head)[2].number() : 999;
  }
  // What the coordinator would tell.
  void place(std::string_view name, double x_mm, double y_mm, double z_mm) {
    const Datum relation =
        form("(relation place ((name symbol) (x number) (y number) (z number) (frame number)) (key name))");
    ASSERT_TRUE(board.declare("coordinator", {relation_from_datum(relation).value()}));
    Transaction told;
    told.tell(list("place"_sym, Datum::symbol(name), x_mm, y_mm, z_mm, 1));
    ASSERT_TRUE(board.transact("coordinator", told));
  }

  VirtualExecutor executor;
  memory::MemoryBoard board{executor};
  simulation::PtuEmulator unit{executor, *simulation::find_ptu_model("ptu46-17.5")};
  ptu::WireToUnit wire{executor, unit};
  ptu::PtuDriver driver{executor, wire};
  std::optional<Life> life;
  int asked = 0;
};

TEST_F(Head, TellsWhereItLooksAndWhatTheUnitCanDo) {
  EXPECT_EQ(fact("(head ?p ?t ?s)"), "(head 0.0 0.0 still)");
  EXPECT_EQ(fact("(pan-tilt ?s ?t)"), "(pan-tilt ready \"\")");
  const Datum limits = fact_like("(pan-tilt-unit ?p ?t)").value();
  EXPECT_NEAR(limits[1][0].number(), -158.914, 0.001);
  EXPECT_NEAR(limits[2][1].number(), 31.063, 0.001);
}

TEST_F(Head, GoesToAnglesAndByAngles) {
  EXPECT_EQ(call("(set-pan-pos 20)"), "(ok true)");
  EXPECT_EQ(call("(set-tilt-pos -10.5)"), "(ok true)");
  executor.run_for(5s);
  EXPECT_NEAR(pan(), 20, 0.03);
  EXPECT_NEAR(tilt(), -10.5, 0.03);
  EXPECT_EQ(call("(set-pan-rel-pos -5)"), "(ok true)");
  EXPECT_EQ(call("(set-tilt-rel-pos 2)"), "(ok true)");
  executor.run_for(5s);
  EXPECT_NEAR(pan(), 15, 0.06);
  EXPECT_NEAR(tilt(), -8.5, 0.06);
  EXPECT_NEAR(unit.pan_deg(), pan(), 0.001);
}

TEST_F(Head, SaysThatItMovesBeforeItDoesAndThatItStandsOnlyOnceItDoes) {
  ask("(set-pan-pos 40)");
  bool told_before = false;
  const Time end = executor.now() + 6s;
  while (executor.now() < end) {
    executor.run_for(1ms);
    const bool says_still = fact_like("(head ?p ?t still)").has_value();
    if (unit.moving()) {
      told_before = true;
      ASSERT_FALSE(says_still);
    } else if (told_before && says_still) {
      ASSERT_NEAR(pan(), unit.pan_deg(), 0.001);
    }
  }
  EXPECT_TRUE(told_before);
  EXPECT_NEAR(pan(), 40, 0.03);
}

TEST_F(Head, RefusesAnglesBeyondTheUnitThatIsThere) {
  EXPECT_EQ(call("(set-pan-pos 159)"), "out-of-range");
  EXPECT_EQ(call("(set-tilt-pos 31.5)"), "out-of-range");
  EXPECT_EQ(call("(set-pan-rel-pos -1e308)"), "out-of-range");
  EXPECT_EQ(call("(set-pan-speed 101)"), "out-of-range");
  EXPECT_EQ(call("(set-tilt-speed -1)"), "out-of-range");
  EXPECT_EQ(call("(set-pan-pos \"left\")"), "wrong-shape");
  EXPECT_EQ(fact("(head ?p ?t ?s)"), "(head 0.0 0.0 still)");
}

TEST_F(Head, SpeedIsAPartOfTheUnitsOwnAndOutlivesTheAgent) {
  EXPECT_EQ(call("(set-pan-speed 100)"), "(ok true)");
  EXPECT_TRUE(wire.sent.ends_with("PS5833 TS1167 ") || wire.sent.find("PS5833 TS1167 ") != std::string::npos);
  life.reset();
  executor.run_for(3s);
  wire.sent.clear();
  life.emplace(executor, board, driver);
  executor.run_for(3s);
  EXPECT_NE(wire.sent.find("PS5833 "), std::string::npos);
}

TEST_F(Head, ResetsEachAxisOrBoth) {
  call("(set-pan-pos 30)");
  call("(set-tilt-pos 10)");
  executor.run_for(5s);
  EXPECT_EQ(call("(reset-tilt)"), "(ok true)");
  executor.run_for(1s);
  EXPECT_NEAR(tilt(), 0, 1e-9);
  EXPECT_NEAR(pan(), 30, 0.03);
  const std::string reset = ask("(reset-all)");
  executor.run_for(1s);
  EXPECT_EQ(fact("(pan-tilt ?s ?t)"), "(pan-tilt resetting \"\")");
  EXPECT_EQ(fact("(head ?p ?t ?s)"), "");
  executor.run_for(60s);
  EXPECT_EQ(write(reply(reset)), "(ok true)");
  EXPECT_EQ(fact("(head ?p ?t ?s)"), "(head 0.0 0.0 still)");
  EXPECT_EQ(fact("(pan-tilt ?s ?t)"), "(pan-tilt ready \"\")");
}

TEST_F(Head, ClosedItLeavesTheUnitAloneUntilOpened) {
  EXPECT_EQ(call("(pt-close)"), "(ok true)");
  EXPECT_EQ(call("(set-pan-pos 5)"), "closed");
  EXPECT_EQ(fact("(head ?p ?t ?s)"), "");
  wire.sent.clear();
  executor.run_for(10s);
  EXPECT_EQ(wire.sent, "");
  EXPECT_EQ(call("(pt-init)"), "(ok true)");
  EXPECT_EQ(call("(set-pan-pos 5)"), "(ok true)");
}

TEST_F(Head, WithoutPowerNobodyKnowsWhereItLooksUntilItHasResetItself) {
  call("(set-pan-pos 100)");
  executor.run_for(500ms);
  unit.power(false);
  executor.run_for(3s);
  EXPECT_EQ(fact("(head ?p ?t ?s)"), "");
  EXPECT_EQ((*fact_like("(pan-tilt ?s ?t)"))[1], "lost"_sym);
  EXPECT_EQ(call("(set-pan-pos 5)"), "disconnected");
  unit.power(true);
  executor.run_for(60s);
  EXPECT_EQ(fact("(pan-tilt ?s ?t)"), "(pan-tilt ready \"\")");
  EXPECT_EQ(fact("(head ?p ?t ?s)"), "(head 0.0 0.0 still)");
  EXPECT_EQ(call("(set-pan-pos 5)"), "(ok true)");
}

TEST_F(Head, APulledPlugInMidMoveIsSaidAndMendedWhenItIsBack) {
  call("(set-pan-pos 100)");
  wire.pull();
  executor.run_for(1s);
  EXPECT_EQ(fact("(head ?p ?t ?s)"), "");
  wire.pulled = false;
  executor.run_for(10s);
  EXPECT_NEAR(pan(), 100, 0.03);
}

TEST_F(Head, WhoTurnsItByHandIsSeen) {
  unit.receive("PP500 ");
  executor.run_for(5s);
  EXPECT_NEAR(pan(), 500 * 185.1428 / 3600, 0.001);
}

TEST_F(Head, LooksAtAnObjectAndFollowsItOnceItLeavesTheMiddle) {
  EXPECT_EQ(call("(look-at circle)"), "unknown-place");
  place("circle", 450, -165, 30);
  EXPECT_EQ(call("(look-at circle)"), "(ok true)");
  EXPECT_EQ(fact("(looking-at ?x)"), "(looking-at circle)");
  executor.run_for(3s);
  EXPECT_NEAR(pan(), std::atan2(-165, 880) * 180 / M_PI, 0.03);
  EXPECT_NEAR(tilt(), std::atan2(-170, std::hypot(165, 880)) * 180 / M_PI, 0.03);
  const double before = pan();
  place("circle", 450, -125, 30);
  executor.run_for(3s);
  EXPECT_EQ(pan(), before);
  place("circle", 450, 100, 30);
  executor.run_for(3s);
  EXPECT_NEAR(pan(), std::atan2(100, 880) * 180 / M_PI, 0.03);
  EXPECT_EQ(call("(set-pan-pos 0)"), "(ok true)");
  EXPECT_EQ(fact("(looking-at ?x)"), "");
  place("circle", 450, 300, 30);
  executor.run_for(3s);
  EXPECT_NEAR(pan(), 0, 1e-9);
}

TEST_F(Head, LooksAsFarAsItCanAtWhatIsBeyondItsReach) {
  place("star", 1330, 0, 1200);
  EXPECT_EQ(call("(look-at star)"), "(ok true)");
  executor.run_for(5s);
  EXPECT_NEAR(tilt(), 31.06, 0.06);
  EXPECT_EQ(call("(look-ahead)"), "(ok true)");
  executor.run_for(5s);
  EXPECT_EQ(fact("(head ?p ?t ?s)"), "(head 0.0 0.0 still)");
}

}  // namespace
}  // namespace pizarra::pan_tilt
