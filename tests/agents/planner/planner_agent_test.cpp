#include "agents/planner/agent/planner_agent.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/planner/planning_domains.hpp"

namespace pizarra::planner {
namespace {

constexpr std::string_view operators = R"((get-operations (
  (operator PICK-UP (params (<ob1> OBJECT)) (preconds (clear <ob1>) (on-table <ob1>) (arm-empty))
    (effects (holding <ob1>) (del (clear <ob1>)) (del (on-table <ob1>)) (del (arm-empty))))
  (operator PUT-DOWN (params (<ob1> OBJECT)) (preconds (holding <ob1>))
    (effects (clear <ob1>) (arm-empty) (on-table <ob1>) (del (holding <ob1>))))
  (operator STACK (params (<ob1> OBJECT) (<ob2> OBJECT)) (preconds (clear <ob2>) (holding <ob1>))
    (effects (arm-empty) (clear <ob1>) (on <ob1> <ob2>) (del (clear <ob2>)) (del (holding <ob1>))))
  (operator UNSTACK (params (<ob1> OBJECT) (<ob2> OBJECT)) (preconds (on <ob1> <ob2>) (clear <ob1>) (arm-empty))
    (effects (holding <ob1>) (clear <ob2>) (del on <ob1> <ob2>) (del clear <ob1>) (del arm-empty))))))";

std::string facts_form(std::string_view goals) {
  return fmt::format(
      "(get-facts (types (circle OBJECT) (square OBJECT) (cross OBJECT)) (initials (on-table circle) (on square "
      "circle) "
      "(clear square) (on-table cross) (clear cross) (arm-empty)) (goals {}))",
      goals);
}

// A planner on a board, and whoever asks it.
template <class T>
class PlannerCell {
 public:
  explicit PlannerCell(Budget budget = {}) { begin(budget); }
  void begin(Budget budget = {}) {
    view = board.view("planner");
    agent = std::make_unique<PlannerAgent>(runtime::AgentContext{"planner", "localhost", executor, *view, Random(1)},
                                           budget);
    job = executor.spawn(live());
  }
  void kill() {
    job = Job();
    agent.reset();
  }
  Task<void> live() { const Result<void> ended = co_await agent->run(); }

  std::string ask(std::string_view operation) {
    std::string id = fmt::format("r{}", ++asked);
    Transaction request;
    request.tell(list("request"_sym, Datum::symbol(id), "planner"_sym, form(operation)));
    bool told = false;
    const Time deadline = executor.now() + 10s;
    executor.run_until([&] {
      told = told || board.transact("user", request).has_value();
      return told || executor.now() > deadline;
    });
    EXPECT_TRUE(told);
    return id;
  }
  std::string reply(const std::string& id) {
    const std::optional<Datum> fact = find(fmt::format("(reply {} ?answer)", id));
    return fact ? write((*fact)[2]) : "";
  }
  std::string call(std::string_view operation) {
    const std::string id = ask(operation);
    const Time deadline = executor.now() + 30s;
    executor.run_until([&] { return !reply(id).empty() || executor.now() > deadline; });
    return reply(id);
  }
  std::string refusal(std::string_view operation) {
    const Datum answer = form(call(operation));
    return answer.is_form("fail") ? fmt::format("{} {}", answer[1].text(), write(answer[3])) : write(answer);
  }
  std::string state() {
    const std::optional<Datum> fact = find("(planner ?state ?detail)");
    return fact ? fmt::format("{} {}", (*fact)[1].text(), write((*fact)[2])) : "";
  }
  std::optional<Datum> find(std::string_view pattern) {
    const Result<Answers> answers = board.ask(query_from_datum(form(pattern)).value());
    if (!answers || answers->answers.empty()) return std::nullopt;
    return answers->answers.front().facts.front().datum;
  }

  T executor;
  memory::MemoryBoard board{executor};
  std::unique_ptr<Board> view;
  std::unique_ptr<PlannerAgent> agent;
  Job job;
  int asked = 0;
};

using Cell = PlannerCell<VirtualExecutor>;

// (make-plan 3 ...) with the same operators, so that the circle comes onto the square.
std::string make_plan() {
  const Datum given = form(facts_form("(on circle square)"));
  return write(list("make-plan"_sym, 3, form(operators)[1], given[1], given[2], given[3]));
}

constexpr std::string_view begun =
    "((on-table circle) (on square circle) (clear square) (on-table cross) (clear cross) (arm-empty))";
constexpr std::string_view put_down =
    "((on-table circle) (clear circle) (on-table square) (clear square) (on-table cross) (clear cross) (arm-empty))";

TEST(PlannerAgent, MakesAPlanInOneRequestAndHandsOutWhatFollowsFromWhatHolds) {
  Cell cell;
  EXPECT_EQ(cell.call(make_plan()),
            "(ok (((UNSTACK square circle)) ((PUT-DOWN square)) ((PICK-UP circle)) ((STACK circle square))))");
  EXPECT_EQ(write(*cell.find("(plan ?n ?operations)")),
            "(plan 3 ((UNSTACK square circle) (PUT-DOWN square) (PICK-UP circle) (STACK circle square)))");
  EXPECT_TRUE(cell.call(fmt::format("(next-operation 3 {})", begun)).starts_with("(ok 0 ((UNSTACK square circle) "));
  EXPECT_EQ(cell.call(fmt::format("(next-operation 3 {})", put_down)),
            "(ok 2 ((PICK-UP circle) (STACK circle square)) "
            "((arm-empty) (clear circle) (clear square) (on-table circle)) ((clear square) (holding circle)))");
  EXPECT_EQ(cell.call("(next-operation 3 ((on circle square)))"),
            "(ok 4 () ((on circle square)) ((on circle square)))");
  EXPECT_EQ(cell.refusal("(next-operation 3 ((on cross circle)))"), "off-plan 3");
  EXPECT_EQ(cell.refusal(fmt::format("(next-operation 4 {})", begun)), "not-ready 4");
}

TEST(PlannerAgent, TriesAPlanAndGoesOnWithTheOneInUse) {
  Cell cell;
  cell.call(make_plan());
  const Datum given = form(facts_form("(on square cross)"));
  const Datum tried = list("try-plan"_sym, form(operators)[1], given[1], given[2], given[3]);
  EXPECT_EQ(cell.call(write(tried)), "(ok (((UNSTACK square circle)) ((STACK square cross))))");
  EXPECT_TRUE(cell.find("(plan 3 ?operations)"));
  EXPECT_TRUE(cell.call(fmt::format("(next-operation 3 {})", begun)).starts_with("(ok 0 ((UNSTACK square circle) "));
  const Datum impossible = form(facts_form("(on square square)"));
  const Datum in_vain = list("try-plan"_sym, form(operators)[1], impossible[1], impossible[2], impossible[3]);
  EXPECT_TRUE(cell.refusal(write(in_vain)).starts_with("no-plan "));
}

TEST(PlannerAgent, GoesOnWithItsPlanAfterItWasKilled) {
  Cell cell;
  cell.call(make_plan());
  cell.kill();
  cell.executor.run_for(3s);
  cell.begin();
  cell.executor.run_for(1s);
  EXPECT_TRUE(cell.call(fmt::format("(next-operation 3 {})", put_down)).starts_with("(ok 2 ((PICK-UP circle) "));
}

TEST(PlannerAgent, TakesNoEarlierPlanUpAgainOnceNoneCouldBeFound) {
  Cell cell;
  cell.call(make_plan());
  const Datum given = form(facts_form("(on square square)"));
  const Datum impossible = list("make-plan"_sym, 3, form(operators)[1], given[1], given[2], given[3]);
  EXPECT_TRUE(cell.refusal(write(impossible)).starts_with("no-plan "));
  EXPECT_FALSE(cell.find("(plan 3 ?operations)"));
  cell.kill();
  cell.executor.run_for(3s);
  cell.begin();
  cell.executor.run_for(1s);
  EXPECT_EQ(cell.refusal(fmt::format("(next-operation 3 {})", begun)), "not-ready 3");
}

TEST(PlannerAgent, PlansAndHandsOutOneOperationAtATime) {
  Cell cell;
  EXPECT_EQ(cell.call(operators), "(ok)");
  EXPECT_EQ(cell.call(facts_form("(on circle square)")), "(ok)");
  EXPECT_EQ(cell.state(), "idle ()");
  EXPECT_EQ(cell.call("(get-plan)"),
            "(ok (((UNSTACK square circle)) ((PUT-DOWN square)) ((PICK-UP circle)) ((STACK circle square))))");
  EXPECT_EQ(cell.state(),
            "planned (optimal guided "
            "(((UNSTACK square circle)) ((PUT-DOWN square)) ((PICK-UP circle)) ((STACK circle square))))");
  EXPECT_EQ(cell.call("(start-plan)"), "(ok (UNSTACK square circle))");
  EXPECT_TRUE(cell.call(fmt::format("(next-operation 0 {})", put_down)).starts_with("(ok 2 ((PICK-UP circle) "));
}

TEST(PlannerAgent, AnswersDoneWhenTheGoalHoldsAlready) {
  Cell cell;
  cell.call(operators);
  cell.call(facts_form("(on square circle)"));
  EXPECT_EQ(cell.call("(get-plan)"), "(ok ())");
  EXPECT_EQ(cell.call("(start-plan)"), "(ok done)");
}

TEST(PlannerAgent, HandsOutParallelStepsInAFixedOrder) {
  Cell cell;
  cell.call("(get-operations ((operator GO (params (<x> HAND)) (preconds) (effects (there <x>)))))");
  cell.call("(get-facts (types (left HAND) (right HAND)) (initials) (goals (there right) (there left)))");
  EXPECT_EQ(cell.call("(get-plan)"), "(ok (((GO left) (GO right))))");
  EXPECT_EQ(cell.call("(start-plan)"), "(ok (GO left))");
  EXPECT_TRUE(cell.call("(next-operation 0 ((there left)))").starts_with("(ok 1 ((GO right))"));
}

TEST(PlannerAgent, KeepsWhatIsLeftOfItsPlanWhenTheFactsAreThoseItExpects) {
  Cell cell;
  cell.call(operators);
  cell.call(facts_form("(on circle square)"));
  cell.call("(get-plan)");
  cell.call(
      "(get-facts (types (circle OBJECT) (square OBJECT) (cross OBJECT)) (initials (on-table circle) (clear circle) "
      "(on-table square) (clear square) (on-table cross) (clear cross) (arm-empty)) (goals (on circle square)))");
  EXPECT_EQ(cell.refusal("(start-plan)"), "not-ready ()");
  EXPECT_EQ(cell.call("(get-plan)"), "(ok (((PICK-UP circle)) ((STACK circle square))))");
  EXPECT_EQ(cell.state(), "planned (optimal kept (((PICK-UP circle)) ((STACK circle square))))");
}

TEST(PlannerAgent, KeepsWhatIsLeftOfItsPlanWhenASearchWasCancelledMeanwhile) {
  Cell cell;
  cell.call(operators);
  cell.call(facts_form("(on circle square)"));
  cell.call("(get-plan)");
  const std::string cancelled = cell.ask("(get-plan)");
  cell.call(facts_form("(on circle square)"));
  EXPECT_EQ(cell.call("(get-plan)"),
            "(ok (((UNSTACK square circle)) ((PUT-DOWN square)) ((PICK-UP circle)) ((STACK circle square))))");
  EXPECT_EQ(form(cell.reply(cancelled))[1], "cancelled"_sym);
  EXPECT_EQ(cell.state().substr(0, 21), "planned (optimal kept");
}

TEST(PlannerAgent, NeverAnswersANewGoalOrAVanishedObjectWithTheOldPlan) {
  Cell cell;
  cell.call(operators);
  cell.call(facts_form("(on circle square)"));
  cell.call("(get-plan)");
  cell.call(facts_form("(on circle cross)"));
  EXPECT_EQ(cell.call("(get-plan)"),
            "(ok (((UNSTACK square circle)) ((PUT-DOWN square)) ((PICK-UP circle)) ((STACK circle cross))))");
  cell.call(
      "(get-facts (types (circle OBJECT) (cross OBJECT)) (initials (on-table circle) (clear circle) (on-table cross) "
      "(clear cross) (arm-empty)) (goals (on circle cross)))");
  EXPECT_EQ(cell.call("(get-plan)"), "(ok (((PICK-UP circle)) ((STACK circle cross))))");
  cell.call(
      "(get-facts (types (circle OBJECT)) (initials (on-table circle) (clear circle) (arm-empty)) "
      "(goals (on circle cross)))");
  EXPECT_EQ(cell.refusal("(get-plan)"), "unknown-object cross");
  EXPECT_EQ(cell.refusal("(start-plan)"), "not-ready ()");
}

TEST(PlannerAgent, SaysWhichGoalsMakeAPlanImpossible) {
  Cell cell;
  cell.call(operators);
  cell.call(facts_form("(clear cross) (on circle square) (on circle cross)"));
  EXPECT_EQ(cell.call("(get-plan)"),
            "(fail no-plan \"no plan exists: (clear cross) and (on circle cross) can never hold together from here\" "
            "((clear cross) (on circle cross)))");
  EXPECT_EQ(cell.state().substr(0, 21), "no-plan (fail no-plan");
  EXPECT_EQ(cell.refusal("(start-plan)"), "not-ready ()");
}

TEST(PlannerAgent, GivesUpWithinItsBudgetAndSaysSo) {
  Cell cell(Budget{.nodes = 2});
  cell.call(operators);
  cell.call(facts_form("(on circle square) (on square cross)"));
  EXPECT_EQ(cell.call("(get-plan)"), "(fail gave-up \"no plan was found within 2 states; there may be one\" ())");
}

TEST(PlannerAgent, AsksForWhatItWasNotTold) {
  Cell cell;
  EXPECT_EQ(cell.refusal("(get-plan)"), "not-ready ()");
  cell.call(operators);
  EXPECT_EQ(cell.refusal("(get-plan)"), "not-ready ()");
  EXPECT_EQ(cell.refusal("(next-operation 0 ())"), "not-ready 0");
  cell.call(facts_form("(on circle square)"));
  cell.call("(get-plan)");
  EXPECT_EQ(cell.refusal("(next-operation 0 ())"), "not-ready 0");
  cell.call("(start-plan)");
  EXPECT_EQ(cell.refusal("(next-operation 0 ())"), "off-plan 0");
}

TEST(PlannerAgent, RefusesMalformedRequestsWithOneFailureAboutTheWrongPart) {
  Cell cell;
  EXPECT_EQ(cell.refusal("(get-operations ())"), "bad-operator ()");
  EXPECT_EQ(cell.refusal("(get-operations ((operator FLY)))"), "bad-operator (operator FLY)");
  EXPECT_EQ(cell.refusal("(get-operations ((operator FLY (params (x OBJECT)) (preconds) (effects))))"),
            "bad-operator (x OBJECT)");
  EXPECT_EQ(cell.refusal("(get-operations ((operator FLY (params) (effects) (preconds))))"), "bad-operator (effects)");
  EXPECT_EQ(cell.refusal("(get-operations ((operator FLY (params) (preconds) (effects (del)))))"),
            "bad-operator (del)");
  EXPECT_EQ(cell.refusal("(get-operations ((operator FLY (params) (preconds) (effects)) "
                         "(operator FLY (params) (preconds) (effects))))"),
            "bad-operator FLY");
  EXPECT_EQ(cell.refusal("(get-facts (types (circle OBJECT)) (initials) (goals))"), "bad-facts (goals)");
  EXPECT_EQ(cell.refusal("(get-facts (types circle) (initials) (goals (clear circle)))"), "bad-facts circle");
  EXPECT_EQ(cell.refusal("(get-facts (initials) (types) (goals))"), "bad-facts (initials)");
  EXPECT_EQ(cell.refusal("(get-facts (types) (initials (clear (x))) (goals (a)))"), "bad-facts (clear (x))");
  EXPECT_EQ(cell.refusal("(get-facts (types))"), "wrong-shape (get-facts (types))");
  cell.call(operators);
  cell.call(facts_form("(on circle star)"));
  EXPECT_EQ(cell.refusal("(get-plan)"), "unknown-object star");
}

TEST(PlannerAgent, ANewRequestCancelsThePlanningUnderWay) {
  Cell cell;
  cell.call(operators);
  cell.call(facts_form("(on circle square)"));
  const std::string first = cell.ask("(get-plan)");
  const std::string second = cell.ask("(get-plan)");
  cell.executor.run_for(1s);
  EXPECT_EQ(form(cell.reply(first))[1], "cancelled"_sym);
  EXPECT_TRUE(form(cell.reply(second)).is_form("ok"));
  EXPECT_EQ(cell.state().substr(0, 7), "planned");
  const std::string third = cell.ask("(get-plan)");
  cell.call(facts_form("(on cross square)"));
  cell.executor.run_for(1s);
  EXPECT_EQ(form(cell.reply(third))[1], "cancelled"_sym);
  EXPECT_EQ(cell.refusal("(start-plan)"), "not-ready ()");
  EXPECT_EQ(cell.call("(get-plan)"), "(ok (((PICK-UP cross)) ((STACK cross square))))");
}

// In real time, on a worker thread: this many blocks take far longer than this test waits.
TEST(PlannerAgent, AnswersWhileItPlansAndStopsPlanningWhenToldSomethingElse) {
  PlannerCell<RealExecutor> cell(Budget{.nodes = SIZE_MAX, .levels = 250, .bytes = std::size_t{1} << 40});
  Random random(11);
  const PlanningTask hard = random_blocks(40, random);
  std::vector<Datum> types{"types"_sym}, initials{"initials"_sym}, goals{"goals"_sym};
  for (const PlanningObject& object : hard.objects) types.push_back(list(object.name, Datum::symbol(object.type)));
  initials.insert(initials.end(), hard.initials.begin(), hard.initials.end());
  goals.insert(goals.end(), hard.goals.begin(), hard.goals.end());
  const Datum asked = list("get-facts"_sym, Datum::list(types), Datum::list(initials), Datum::list(goals));
  EXPECT_EQ(cell.call(operators), "(ok)");
  EXPECT_EQ(cell.call(write(asked)), "(ok)");
  const std::string waiting = cell.ask("(get-plan)");
  const Time deadline = cell.executor.now() + 5s;
  cell.executor.run_until([&] { return cell.state().starts_with("planning") || cell.executor.now() > deadline; });
  EXPECT_EQ(cell.refusal("(start-plan)"), "not-ready ()");
  EXPECT_EQ(cell.reply(waiting), "");
  EXPECT_EQ(cell.call(facts_form("(on cross square)")), "(ok)");
  EXPECT_EQ(cell.call("(get-plan)"), "(ok (((PICK-UP cross)) ((STACK cross square))))");
  cell.executor.run_until([&] { return !cell.reply(waiting).empty() || cell.executor.now() > deadline; });
  EXPECT_EQ(form(cell.reply(waiting))[1], "cancelled"_sym);
}

TEST(PlannerAgent, ItsStateGoesWithItAndASuccessorBeginsAfresh) {
  Cell cell;
  cell.call(operators);
  cell.kill();
  cell.executor.run_for(3s);
  EXPECT_EQ(cell.state(), "");
  cell.begin();
  cell.executor.run_for(1s);
  EXPECT_EQ(cell.state(), "idle ()");
  EXPECT_EQ(cell.refusal("(get-plan)"), "not-ready ()");
}

// Whatever is sent, each request gets one answer and the planner goes on.
TEST(PlannerAgent, SurvivesRandomlyDamagedRequests) {
  Cell cell;
  const std::vector<Datum> whole{form(operators),    form(facts_form("(on circle square)")),
                                 form("(get-plan)"), form("(start-plan)"),
                                 form(make_plan()),  form(fmt::format("(next-operation 3 {})", begun))};
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const std::function<Datum(const Datum&)> damaged = [&](const Datum& datum) -> Datum {
      if (random.below(40) == 0)
        return std::vector<Datum>{Datum(),
                                  "del"_sym,

                                  Datum::integer(-7),
                                  "<y>"_sym,
                                  Datum::string("star"),
                                  list("on"_sym, "circle"_sym)}[random.below(6)];
      if (!datum.is_list()) return datum;
      std::vector<Datum> items;
      for (const Datum& item : datum.items()) {
        if (random.below(60) != 0) items.push_back(damaged(item));
        if (random.below(60) == 0) items.push_back(damaged(item));
      }
      return Datum::list(std::move(items));
    };
    const std::string text = write(damaged(whole[random.below(whole.size())]));
    const std::string reply = cell.call(text);
    ASSERT_FALSE(reply.empty()) << "seed " << seed << ": " << text;
    const Datum answer = form(reply);
    ASSERT_TRUE(answer.is_form("ok") || answer.is_form("fail")) << "seed " << seed << ": " << text;
    if (answer.is_form("fail")) {
      ASSERT_GT(answer[2].text().size(), 10u) << "seed " << seed << ": " << text;
    }
  }
  EXPECT_EQ(cell.call(operators), "(ok)");
  EXPECT_EQ(cell.call(facts_form("(on cross square)")), "(ok)");
  EXPECT_EQ(cell.call("(get-plan)"), "(ok (((PICK-UP cross)) ((STACK cross square))))");
}

}  // namespace
}  // namespace pizarra::planner
