#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "agents/coordinator/plan/task_domain.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/coordinator/shortest_plan.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::coordinator {
namespace {

Datum d(std::string_view text) { return read_one(text).value(); }

std::vector<Datum> all(std::string_view text) {
  const Datum read = d(text);
  return {read.items().begin(), read.items().end()};
}

TaskDomain domain(const std::string& name) {
  const Result<TaskDomain> read = TaskDomain::read(source_dir() + "/domains/" + name);
  EXPECT_TRUE(read) << describe(read.error());
  return *read;
}

Facts perceived(const TaskDomain& task, std::string_view measured, std::string_view believed = "()") {
  const Result<std::vector<Datum>> found = task.perception().perceive(all(measured), all(believed));
  EXPECT_TRUE(found);
  return {found->begin(), found->end()};
}

Facts facts(std::string_view text) {
  const std::vector<Datum> items = all(text);
  return {items.begin(), items.end()};
}

TEST(BlocksDomain, SeesATowerAndWhatStandsAlone) {
  EXPECT_EQ(perceived(domain("blocks.scm"),
                      "((gripper 84.0) (grip 450 0 300) (seen a 480 0 30) (seen b 482 3 90.4) (seen c 478 150 29))"),
            facts("((on b a) (on-table a) (on-table c) (bare b) (bare c) (clear b) (clear c) (arm-empty))"));
}

TEST(BlocksDomain, SeesWhatIsHeldAndNotWhatTheOpenGripperStandsAround) {
  const TaskDomain task = domain("blocks.scm");
  EXPECT_EQ(perceived(task, "((gripper 60.3) (grip 450 0 200) (seen a 452 2 198))"), facts("((holding a) (bare a))"));
  EXPECT_EQ(perceived(task, "((gripper 84.0) (grip 450 0 30) (seen a 452 2 31))"),
            facts("((on-table a) (bare a) (clear a) (arm-empty))"));
}

// As after eyes that had taken one for the other for a moment.
TEST(BlocksDomain, HoldsNothingThatIsBelowWhatIsHeldHoweverSmallTheCubes) {
  for (const double cube_mm : {42.0, 48.0, 60.0}) {
    TaskDomain task = domain("blocks.scm");
    task.use_cubes(cube_mm);
    const std::string measured = fmt::format("((gripper {0}) (grip 450 0 {1}) (seen a 450 0 {1}) (seen b 450 0 {2}))",
                                             cube_mm, 1.5 * cube_mm + 1, cube_mm / 2 + 2);
    const Facts found = perceived(task, measured, "((holding b))");
    EXPECT_TRUE(found.contains(d("(holding a)"))) << cube_mm;
    EXPECT_FALSE(found.contains(d("(holding b)"))) << cube_mm;
  }
}

TEST(BlocksDomain, SeesWhatLiesAskewLeanOnAllThatMayHoldItUp) {
  EXPECT_EQ(perceived(domain("blocks.scm"),
                      "((gripper 84.0) (grip 450 0 300) (seen a 480 0 62) (seen b 480 -50 30) (seen c 480 48 30))"),
            facts("((leans a b) (leans a c) (bare a) (on-table b) (on-table c) (arm-empty))"));
}

std::vector<Datum> planned(const TaskDomain& task, std::string_view measured, std::string_view goal) {
  const Datum types = d("(types (a OBJECT) (b OBJECT) (c OBJECT))");
  const std::optional<std::vector<Datum>> plan = shortest_plan(task, types, perceived(task, measured), facts(goal));
  EXPECT_TRUE(plan) << goal;
  return plan.value_or(std::vector<Datum>());
}

TEST(BlocksDomain, LiftsACubeOffWhatIsNotSeenForAGoalThatHasItOnTheTable) {
  const TaskDomain task = domain("blocks.scm");
  constexpr std::string_view measured = "((gripper 84.0) (grip 450 0 300) (seen a 480 0 90) (seen b 480 200 30))";
  EXPECT_EQ(perceived(task, measured),
            facts("((raised a) (bare a) (clear a) (on-table b) (bare b) (clear b) (arm-empty))"));
  const std::vector<Datum> plan = planned(task, measured, "((on-table a) (on b a))");
  ASSERT_EQ(plan.size(), 4u);
  EXPECT_EQ(plan[0], d("(LIFT a)"));
  EXPECT_EQ(plan[1], d("(PUT-DOWN a)"));
}

TEST(BlocksDomain, FreesACubeThatLeansBeforeAnotherIsPutOnIt) {
  const std::vector<Datum> plan = planned(
      domain("blocks.scm"),
      "((gripper 84.0) (grip 450 0 300) (seen a 480 0 62) (seen b 480 -50 30) (seen c 480 200 30))", "((on c a))");
  ASSERT_EQ(plan.size(), 3u);
  EXPECT_EQ(plan.front(), d("(FREE a b)"));
  EXPECT_EQ(plan.back(), d("(STACK c a)"));
}

TEST(BlocksDomain, TakesOffWhatACubeThatLeansBearsBeforeItIsPushedOver) {
  const TaskDomain task = domain("blocks.scm");
  constexpr std::string_view loaded =
      "((gripper 84.0) (grip 450 0 300) (seen a 480 0 62) (seen b 480 -50 30) (seen c 480 2 120))";
  EXPECT_EQ(perceived(task, loaded), facts("((leans a b) (on c a) (on-table b) (bare c) (clear c) (arm-empty))"));
  const std::vector<Datum> plan = planned(task, loaded, "((on-table a))");
  ASSERT_EQ(plan.size(), 3u);
  EXPECT_EQ(plan.front(), d("(UNSTACK c a)"));
  EXPECT_EQ(plan.back(), d("(FREE a b)"));
}

TEST(BlocksDomain, SeesThatWhatSlippedInTheGripperIsHeldStillAndWhatIsBelowItIsNot) {
  EXPECT_EQ(perceived(domain("blocks.scm"), "((gripper 60.2) (grip 450 0 200) (seen a 455 3 168) (seen b 450 2 108))"),
            facts("((holding a) (bare a) (bare b) (clear b))"));
}

TEST(BlocksDomain, SeesNothingSupportedInMidAir) {
  EXPECT_EQ(perceived(domain("blocks.scm"), "((gripper 84.0) (grip 450 0 300) (seen a 480 -150 160))"),
            facts("((bare a) (clear a) (arm-empty))"));
}

TEST(BlocksDomain, SeesWhatSomebodyHoldsHighAboveACubeLeanOnNothing) {
  EXPECT_EQ(perceived(domain("blocks.scm"), "((gripper 84.0) (grip 450 0 300) (seen a 440 20 213) (seen b 475 50 30))"),
            facts("((on-table b) (bare a) (clear a) (bare b) (clear b) (arm-empty))"));
}

TEST(BlocksDomain, GoesOnHoldingWhatIsLostFromSightForAMoment) {
  const TaskDomain task = domain("blocks.scm");
  constexpr std::string_view measured = "((gripper 60.0) (grip 450 100 300) (seen a 452 2 198) (unseen a))";
  EXPECT_TRUE(perceived(task, measured, "((holding a))").contains(d("(holding a)")));
  EXPECT_FALSE(perceived(task, measured).contains(d("(holding a)")));
}

TEST(BlocksDomain, HoldsNothingElseThatIsLostFromSightWhileACubeIsHeld) {
  EXPECT_EQ(perceived(domain("blocks.scm"),
                      "((gripper 60.0) (grip 450 100 300) (seen a 452 102 298) (seen b 480 -120 30) (unseen b))",
                      "((holding a) (on-table b) (bare a) (bare b) (clear b))"),
            facts("((holding a) (bare a) (on-table b) (bare b) (clear b))"));
}

TEST(BlocksDomain, DoesNotFlickerAtABound) {
  const TaskDomain task = domain("blocks.scm");
  constexpr std::string_view measured = "((seen a 480 0 30) (seen b 480 32.5 90))";
  EXPECT_FALSE(perceived(task, measured).contains(d("(on b a)")));
  EXPECT_TRUE(perceived(task, measured, "((on b a))").contains(d("(on b a)")));
}

TEST(BlocksDomain, EveryOperationsEffectsFollowFromItsPreconditions) {
  const TaskDomain task = domain("blocks.scm");
  const Result<GroundOperation> stack = task.ground(d("(STACK a b)"));
  ASSERT_TRUE(stack);
  EXPECT_EQ(stack->preconditions, all("((clear b) (holding a))"));
  EXPECT_EQ(stack->adds, all("((arm-empty) (clear a) (on a b))"));
  EXPECT_EQ(stack->deletes, all("((clear b) (bare b) (holding a))"));
  EXPECT_EQ(task.ground(d("(STAK a b)")).error().symbol, "unknown-operator");
  EXPECT_EQ(task.ground(d("(STACK a)")).error().symbol, "wrong-arity");
}

TEST(BlocksDomain, SaysHowEveryOperatorIsCarriedOut) {
  for (const char* file : {"blocks.scm", "numbered-places.scm", "sizes.scm"}) {
    const TaskDomain task = domain(file);
    for (const forms::Operator& known : task.domain().operators) {
      std::vector<Datum> operation{Datum::symbol(known.name)};
      for (std::size_t i = 0; i < known.params.size(); ++i) operation.push_back("x"_sym);
      const Result<std::vector<Datum>> steps = task.micro_tasks().expand(Datum::list(operation));
      ASSERT_TRUE(steps) << known.name;
      const bool acts = std::ranges::any_of(*steps, [](const Datum& step) {
        return step.is_form("close") || step.is_form("release") || step.is_form("push-over");
      });
      EXPECT_TRUE(acts) << known.name;
      EXPECT_TRUE(steps->back().is_form("raise") || steps->back().is_form("check-held")) << known.name;
    }
  }
}

TEST(NumberedPlaces, KnowsWhereThingsStandAndWhatIsFree) {
  const TaskDomain task = domain("numbered-places.scm");
  EXPECT_EQ(perceived(task, "((gripper 84.0) (seen a 480 -205 30) (seen b 480 -98 30) (seen c 480 -99 90))"),
            facts("((at a place-1) (at b place-2) (on c b) (free place-3) (free place-4) (clear a) (clear c) "
                  "(arm-empty))"));
  ASSERT_TRUE(task.named_place("place-3"));
  EXPECT_EQ(task.named_place("place-9"), nullptr);
}

TEST(NumberedPlaces, BuildsNothingOnACubeThatLiesAskew) {
  const Facts found =
      perceived(domain("numbered-places.scm"), "((gripper 84.0) (seen a 480 -170 58) (seen b 480 -205 30))");
  EXPECT_EQ(found,
            facts("((askew a) (at b place-1) (free place-2) (free place-3) (free place-4) (clear b) (arm-empty))"));
}

TEST(SizesDomain, SeesTowersOfSizesAndWhatFitsOnWhat) {
  TaskDomain task = domain("sizes.scm");
  task.use_cubes(60, {{"a", 60}, {"b", 50}, {"c", 40}});
  EXPECT_EQ(perceived(task, "((gripper 84.0) (seen a 480 -150 30) (seen b 475 -150 85) (seen c 470 -150 130))"),
            facts("((fits b a) (fits c a) (fits c b) (on b a) (on c b) (at a place-1) (free place-2) (free place-3) "
                  "(clear c) (arm-empty))"));
  const Facts held = perceived(task, "((gripper 41.0) (grip 480 0 300) (seen c 470 1 299))");
  EXPECT_TRUE(held.contains(d("(holding c)")));
  EXPECT_EQ(task.edge_mm("c"), 40);
  EXPECT_EQ(task.edge_mm("of-another-cell"), 60);
  EXPECT_EQ(task.edge_like(46), 50);
  EXPECT_FALSE(task.edge_like(0));
}

// The example of a variant as docs/write-a-domain.md shows it.
std::string variant_on_the_page() {
  const std::string page = whole_file(source_dir() + "/docs/write-a-domain.md");
  const std::size_t begin = page.find("(domain tray");
  return begin == std::string::npos ? "" : page.substr(begin, page.find("```", begin) - begin);
}

TEST(VariantOnThePage, IsShortAndPlannedWith) {
  const std::string text = variant_on_the_page();
  const auto lines = std::ranges::count(text, '\n');
  EXPECT_GT(lines, 0);
  EXPECT_LT(lines, 20);
  std::filesystem::create_directory_symlink(source_dir() + "/domains", scratch_folder() + "domains");
  std::ofstream(scratch_folder() + "tray.scm") << text;
  const Result<TaskDomain> task = TaskDomain::read(scratch_folder() + "tray.scm");
  ASSERT_TRUE(task) << describe(task.error());
  constexpr std::string_view measured =
      "((gripper 84.0) (grip 450 0 300) (seen a 480 0 30) (seen b 480 0 90) (seen c 480 150 30))";
  EXPECT_EQ(perceived(*task, measured), facts("((on b a) (on-table a) (on-table c) (bare b) (bare c) (clear b) "
                                              "(clear c) (tray-free) (arm-empty))"));
  const std::vector<Datum> plan = planned(*task, measured, "((served a) (on c b))");
  EXPECT_EQ(plan.size(), 6u);
  EXPECT_TRUE(std::ranges::find(plan, d("(SERVE a)")) != plan.end()) << write(Datum::list(plan));
  const Result<std::vector<Datum>> steps = task->micro_tasks().expand(d("(SERVE a)"));
  ASSERT_TRUE(steps);
  EXPECT_EQ((*steps)[2], d("(align (at-place a tray))"));
}

// The blocks with one piece of their text replaced.
Result<TaskDomain> blocks_with(const std::string& old, const std::string& now) {
  std::string text = whole_file(source_dir() + "/domains/blocks.scm");
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  text.replace(at, old.size(), now);
  const std::string file = scratch_folder() + "damaged-domain.scm";
  std::ofstream(file) << text;
  return TaskDomain::read(file);
}

TEST(TaskDomain, RefusesAtItsPlaceWhatTheCoordinatorCouldNotDo) {
  struct Damage {
    std::string old, now, symbol;
  };
  const std::vector<Damage> damages{
      {"(PICK-UP (<ob1>) (GRASP <ob1>))", "(PICK-UP (<ob1>) (JUMP <ob1>))", "unknown-step"},
      {"(PICK-UP (<ob1>) (GRASP <ob1>))", "(PICK-UP (<ob1>) (PICK-UP <ob1>))", "unknown-step"},
      {"(PICK-UP (<ob1>) (GRASP <ob1>))", "", "missing-task"},
      {"(PICK-UP (<ob1>) (GRASP <ob1>))", "(PICK-UP (<ob1>) (align (teleport <ob1>)))", "unknown-target"},
      {"(PICK-UP (<ob1>) (GRASP <ob1>))", "(PICK-UP (<ob1>) (GRASP (free-spot <ob1>)))", "wrong-argument"},
      {"(constant cube 60)", "(constant cube 0)", "missing-constant"},
      {"(sees OBJECT)", "(sees THING)", "unknown-type"},
  };
  for (const Damage& damage : damages) {
    const Result<TaskDomain> read = blocks_with(damage.old, damage.now);
    ASSERT_FALSE(read) << damage.now;
    EXPECT_EQ(read.error().symbol, damage.symbol) << describe(read.error());
    EXPECT_NE(read.error().place.find("damaged-domain.scm:"), std::string::npos) << describe(read.error());
  }
}

TEST(TaskDomain, ReportsWhatIsWrongInPerceptionAndMicroTasksTogether) {
  const std::string file = scratch_folder() + "wrong-twice.scm";
  std::ofstream(file) << "(domain d (types OBJECT) (predicates (clear (ob OBJECT)))\n"
                         "  (perception (rule))\n"
                         "  (micro-tasks (JUMP)))";
  const Result<TaskDomain> read = TaskDomain::read(file);
  ASSERT_FALSE(read);
  const std::string report = describe(read.error());
  EXPECT_NE(report.find("a rule is"), std::string::npos) << report;
  EXPECT_NE(report.find("a micro-task is"), std::string::npos) << report;
}

TEST(TaskDomain, SaysThatThereAreNoMicroTasks) {
  std::ofstream(scratch_folder() + "no-tasks.scm")
      << "(domain d (types OBJECT) (predicates (clear (ob OBJECT))) (perception (constant cube 60)))";
  EXPECT_EQ(TaskDomain::read(scratch_folder() + "no-tasks.scm").error().symbol, "missing-section");
  EXPECT_FALSE(TaskDomain::read(scratch_folder() + "no-such-file.scm"));
}

}  // namespace
}  // namespace pizarra::coordinator
