#include "programs/chaos/mistaken_eyes.hpp"

#include <gtest/gtest.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/run_task.hpp"

namespace pizarra::chaos {
namespace {

constexpr const char* relation = "(relation look ((eyes symbol) (frame integer) (text string) (of list)) (key eyes))";
constexpr const char* seen =
    R"look((look vision 4 "(TRACK 3 (\"circle\" OK (1.00, 2.00, 3.00)) (\"cross\" FAIL) (\"square\" FAIL))" )look"
    R"look((("circle" seen 0.9 (left 1 2)) ("cross" lost) ("square" lost))))look";
constexpr const char* mistaken =
    R"look((look vision 4 "(TRACK 3 (\"cross\" OK (1.00, 2.00, 3.00)) (\"circle\" FAIL) (\"square\" FAIL))" )look"
    R"look((("cross" seen 0.9 (left 1 2)) ("circle" lost) ("square" lost))))look";

constexpr const char* seen_far =
    R"look((look vision 5 "(TRACK 3 (\"circle\" OK (90.00, 120.00, 900.00)) (\"cross\" FAIL) (\"square\" FAIL))" )look"
    R"look((("circle" seen 0.9 (left 90 120) (right 50 120) (range 900 1) (face 2) (pose 1 2 3)) )look"
    R"look(("cross" lost) ("square" lost))))look";
constexpr const char* invented =
    R"look((look vision 5 "(TRACK 3 (\"circle\" OK (90.00, 120.00, 900.00)) (\"cross\" FAIL) )look"
    R"look((\"square\" OK (140.00, 120.00, 900.00)))" )look"
    R"look((("circle" seen 0.9 (left 90 120) (right 50 120) (range 900 1) (face 2) (pose 1 2 3)) ("cross" lost) )look"
    R"look(("square" seen 0.9 (left 140.0 120) (right 100.0 120) (range 900 1) (face 2)))))look";

class Eyes : public testing::Test {
 protected:
  // The look as it stands on the board once the eyes told it.
  std::string told(const char* look) {
    Transaction telling;
    telling.tell(read_one(look).value());
    EXPECT_TRUE(run(time_, eyes_.transact(std::move(telling))));
    const Query any = query_for(read_one("(look vision ? ? ?)").value());
    return write(board_.ask(any).value().answers.front().facts.front().datum);
  }
  void SetUp() override {
    const Result<Relation> look = relation_from_datum(read_one(relation).value());
    ASSERT_TRUE(look) << look.error().sentence;
    ASSERT_TRUE(run(time_, eyes_.declare({*look})));
  }

  VirtualExecutor time_;
  memory::MemoryBoard board_{time_};
  const std::unique_ptr<Board> session_ = board_.view("vision");
  Mistakes mistakes_;
  MistakenEyes eyes_{*session_, time_, mistakes_};
};

TEST_F(Eyes, TellLooksAsTheyAre) { EXPECT_EQ(told(seen), write(read_one(seen).value())); }

TEST_F(Eyes, ExchangeTwoNamesInTextAndListForAWhile) {
  mistakes_.names = {.until = time_.now() + 1s, .one = "circle", .other = "cross"};
  EXPECT_EQ(told(seen), write(read_one(mistaken).value()));
  time_.run_for(1s);
  EXPECT_EQ(told(seen), write(read_one(seen).value()));
}

TEST_F(Eyes, InventASightingBesideAnotherForSoManyLooks) {
  mistakes_.invented = {.object = "square", .beside = "circle", .aside_px = 50, .looks_left = 2};
  EXPECT_EQ(told(seen_far), write(read_one(invented).value()));
  EXPECT_EQ(told(seen_far), write(read_one(invented).value()));
  EXPECT_EQ(told(seen_far), write(read_one(seen_far).value()));
}

TEST_F(Eyes, InventNothingOfWhatTheySeeNorBesideWhatTheyDoNotSee) {
  mistakes_.invented = {.object = "circle", .beside = "square", .aside_px = 50, .looks_left = 1};
  EXPECT_EQ(told(seen_far), write(read_one(seen_far).value()));
  mistakes_.invented = {.object = "square", .beside = "cross", .aside_px = 50, .looks_left = 1};
  EXPECT_EQ(told(seen_far), write(read_one(seen_far).value()));
  EXPECT_EQ(mistakes_.invented.looks_left, 1);
}

}  // namespace
}  // namespace pizarra::chaos
