// `pizarra plan` as a person meets it at the shell: what it says and how it ends.

#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

std::string file(const std::string& name, const std::string& text) {
  const std::string path = scratch_folder() + name;
  std::ofstream(path) << text;
  return path;
}

std::string domain() {
  return file("domain.pddl", R"((define (domain blocks) (:requirements :strips)
    (:predicates (on ?x ?y) (on-table ?x) (clear ?x) (arm-empty) (holding ?x) (red ?x))
    (:action pick-up :parameters (?x) :precondition (and (clear ?x) (on-table ?x) (arm-empty))
      :effect (and (not (on-table ?x)) (not (clear ?x)) (not (arm-empty)) (holding ?x)))
    (:action stack :parameters (?x ?y) :precondition (and (holding ?x) (clear ?y))
      :effect (and (not (holding ?x)) (not (clear ?y)) (clear ?x) (arm-empty) (on ?x ?y)))))");
}

std::string problem(const std::string& goal) {
  return file("problem.pddl", R"((define (problem p) (:domain blocks) (:objects A B C)
    (:init (on-table a) (on-table b) (on-table c) (clear a) (clear b) (clear c) (arm-empty)) (:goal )" +
                                  goal + "))");
}

Said plan(const std::string& goal, const std::string& options = "") {
  return shell(fmt::format("{} plan {} {} {} 2>&1", PIZARRA_PLAN, domain(), problem(goal), options));
}

TEST(Plan, IsPrintedStepByStep) {
  const Said said = plan("(and (on a b) (on b c))");
  EXPECT_EQ(said.status, 0);
  EXPECT_TRUE(said.text.starts_with("1  (pick-up b)\n2  (stack b c)\n3  (pick-up a)\n4  (stack a b)\n4 steps"))
      << said.text;
}

TEST(Plan, IsNothingButActionsForPddlTools) {
  const Said said = plan("(on a b)", "--pddl");
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.text, "(pick-up a)\n(stack a b)\n");
}

// Everything else goes to standard error.
TEST(Plan, IsNothingAtAllForPddlToolsWhereThereIsNone) {
  const auto printed = [](const std::string& goal, const std::string& options) {
    return shell(fmt::format("{} plan {} {} --pddl {} 2>/dev/null", PIZARRA_PLAN, domain(), problem(goal), options))
        .text;
  };
  EXPECT_EQ(printed("(clear a)", ""), "");
  EXPECT_EQ(printed("(and (on a b) (on b a))", ""), "");
  EXPECT_EQ(printed("(on a d)", ""), "");
  EXPECT_EQ(printed("(on a b)", "--time 0"), "");
  EXPECT_EQ(printed("(on a b)", "--planner 'echo hello # {domain} {problem}'"), "");
  EXPECT_EQ(printed("(on a b)", "--planner '/nowhere/ff {domain} {problem}'"), "");
  EXPECT_EQ(printed("(on a b)", "--fast --time 60"), "(pick-up a)\n(stack a b)\n");
}

TEST(Plan, IsOneObjectForPrograms) {
  const Said said = plan("(on a b)", "--json");
  EXPECT_EQ(said.status, 0);
  EXPECT_TRUE(said.text.starts_with(R"_({"plan":[["(pick-up a)"],["(stack a b)"]],"steps":2,)_")) << said.text;
}

TEST(Plan, IsEmptyWhereTheGoalHolds) {
  const Said said = plan("(clear a)");
  EXPECT_EQ(said.status, 0);
  EXPECT_TRUE(said.text.starts_with("nothing to do: the goal holds already")) << said.text;
}

TEST(Plan, ThatCannotBeIsRefusedWithTheGoalsThatConflict) {
  const Said said = plan("(and (on a b) (on b a))");
  EXPECT_EQ(said.status, 3);
  EXPECT_TRUE(said.text.starts_with("pizarra: no plan exists: (on a b) and (on b a) can never hold together"))
      << said.text;
  const Said json = plan("(and (on a b) (on b a))", "--json");
  EXPECT_EQ(json.status, 3);
  EXPECT_TRUE(json.text.starts_with(R"_({"error":{"symbol":"no-plan",)_")) << json.text;
}

TEST(Plan, ThatCannotBeIsTracedToWhatIsMissing) {
  const std::string operators = file("dark", R"(
    (operator LIGHT (params (<x> LAMP)) (preconds (wired <x>) (has-key <x>)) (effects (lit <x>)))
    (operator WIRE (params (<x> LAMP)) (preconds (plugged <x>)) (effects (wired <x>))))");
  const std::string facts =
      file("dark-facts", "(types (a LAMP) (b LAMP)) (initials (has-key a) (plugged b)) (goals (lit a))");
  const Said said = shell(fmt::format("{} plan {} {} 2>&1", PIZARRA_PLAN, operators, facts));
  EXPECT_EQ(said.status, 3);
  EXPECT_EQ(said.text,
            "pizarra: no plan exists: (lit a) can never hold from here: (lit a) needs (wired a), and (wired a) needs "
            "(plugged a), and (plugged a) neither holds at the beginning nor is brought about by any operator\n");
}

// Nothing is declared in the thesis' files.
TEST(Plan, ThatCannotBeForASlipOfThePenNamesTheNearest) {
  const std::string operators = file("slip", R"(
    (operator TAKE (params (<x> LAMP)) (preconds (free)) (effects (holding <x>)))
    (operator LIGHT (params (<x> LAMP)) (preconds (holdin <x>)) (effects (lit <x>))))");
  const std::string facts = file("slip-facts", "(types (a LAMP)) (initials (free)) (goals (lit a))");
  EXPECT_EQ(shell(fmt::format("{} plan {} {} 2>&1", PIZARRA_PLAN, operators, facts)).text,
            "pizarra: no plan exists: (lit a) can never hold from here: (lit a) needs (holdin a), and (holdin a) "
            "neither holds at the beginning nor is brought about by any operator; the nearest is holding\n");
}

// What stands behind "can never hold from here: ".
std::string why(const std::string& facts, const std::string& goal) {
  const std::string text = file(
      "why.pddl", "(define (problem p) (:domain blocks) (:objects A B C) (:init " + facts + ") (:goal " + goal + "))");
  const Said said = shell(fmt::format("{} plan {} {} 2>&1", PIZARRA_PLAN, domain(), text));
  EXPECT_EQ(said.status, 3);
  constexpr std::string_view before = "can never hold from here: ";
  const std::size_t at = said.text.find(before);
  return at == std::string::npos ? said.text : said.text.substr(at + before.size());
}

TEST(Plan, ThatCannotBeIsTracedToTheFactsThatAreMissingAtTheBeginning) {
  EXPECT_EQ(why("", "(on a b)"),
            "(on a b) needs (holding a), and (holding a) needs (on-table a), and (on-table a) neither holds at the "
            "beginning nor is brought about by any operator; nothing at all holds at the beginning\n");
  EXPECT_EQ(why("(clear a) (on-table a) (clear b)", "(on a b)"),
            "(on a b) needs (holding a), and (holding a) needs (arm-empty), and (arm-empty) does not hold at the "
            "beginning, and only what needs it brings it about\n");
  EXPECT_EQ(why("(clear a)", "(red a)"),
            "(red a) neither holds at the beginning nor is brought about by any operator\n");
  EXPECT_EQ(why("(red a)", "(not (red a))"), "(red a) holds from the beginning, and no operator ends that\n");
}

// `red` is declared, and neither an action nor an initial fact speaks of it.
TEST(Plan, AnswersForGoalsThatNothingSpeaksOf) {
  EXPECT_EQ(plan("(and (on a b) (red a))").status, 3);
  const Said absent = plan("(and (not (red a)) (not (red b)))");
  EXPECT_EQ(absent.status, 0) << absent.text;
  EXPECT_TRUE(absent.text.starts_with("nothing to do")) << absent.text;
}

TEST(Plan, AnswersForGoalsAboutWhatIsEqual) {
  EXPECT_EQ(plan("(and (= a a) (not (= a b)))").status, 0);
  EXPECT_EQ(plan("(and (= c c) (on a b))", "--pddl").text, "(pick-up a)\n(stack a b)\n");
  for (const std::string options : {"", "--fast --time 1"}) {
    const Said different = plan("(and (= a b) (on a b))", options);
    EXPECT_EQ(different.status, 3);
    EXPECT_TRUE(different.text.starts_with("pizarra: no plan exists: (= a b) can never hold")) << different.text;
    const Said same = plan("(and (on a b) (not (= a a)))", options);
    EXPECT_EQ(same.status, 3);
    EXPECT_TRUE(same.text.starts_with("pizarra: no plan exists: (not (= a a)) can never hold")) << same.text;
  }
  EXPECT_EQ(plan("(= a d)").status, 2);
}

TEST(Plan, ThatCannotBeIsTracedToObjectsThatDoNotFit) {
  const std::string roads = file("roads.pddl", R"((define (domain roads) (:requirements :typing)
    (:types truck place hand) (:predicates (at ?t - truck ?p - place) (road ?a ?b - place) (loaded ?t - truck))
    (:action drive :parameters (?t - truck ?a ?b - place) :precondition (and (at ?t ?a) (road ?a ?b))
      :effect (and (at ?t ?b) (not (at ?t ?a))))
    (:action load :parameters (?t - truck ?h - hand) :effect (loaded ?t))))");
  const auto why_not = [&](const std::string& goal) {
    const std::string text = file("roads-problem.pddl", R"((define (problem p) (:domain roads)
      (:objects t - truck a b c d - place) (:init (at t a) (road a b) (road c d)) (:goal )" +
                                                            goal + "))");
    return shell(fmt::format("{} plan {} {} 2>&1", PIZARRA_PLAN, roads, text)).text;
  };
  EXPECT_EQ(why_not("(at t d)"),
            "pizarra: no plan exists: (at t d) can never hold from here: drive needs (at t ?a) and (road ?a d) for "
            "(at t d), and no objects have all of that\n");
  EXPECT_EQ(why_not("(loaded t)"),
            "pizarra: no plan exists: (loaded t) can never hold from here: load, which brings (loaded t) about, takes "
            "a hand, and there is none\n");
}

TEST(Plan, ThatCannotBeIsTracedToATypeThatNoObjectHas) {
  const std::string operators = file("typed", R"(
    (operator PICK-UP (params (<a> object)) (preconds (clear <a>)) (effects (holding <a>)))
    (operator STACK (params (<a> object) (<b> BLOCK)) (preconds (holding <a>)) (effects (on <a> <b>))))");
  const std::string facts = file(
      "typed-facts", "(types (circle object) (square object)) (initials (clear circle)) (goals (on circle square))");
  EXPECT_EQ(shell(fmt::format("{} plan {} {} 2>&1", PIZARRA_PLAN, operators, facts)).text,
            "pizarra: no plan exists: (on circle square) can never hold from here: STACK, which brings (on circle "
            "square) about, takes a BLOCK, and there is none\n");
}

TEST(Plan, ThatCannotBeIsExplainedInTheLanguageOfTheFiles) {
  const std::string operators = file("typed", R"(
    (operator PUT (params (<a> CUBE) (<b> CUBE)) (preconds (near <a> <b>) (free <b>)) (effects (on <a> <b>))))");
  const auto why_not = [&](const std::string& facts) {
    return shell(fmt::format("{} plan {} {} 2>&1", PIZARRA_PLAN, operators, file("typed-facts", facts))).text;
  };
  EXPECT_EQ(why_not("(types (a CUBE) (t TABLE)) (initials (free t)) (goals (on a t))"),
            "pizarra: no plan exists: (on a t) can never hold from here: PUT, which brings (on <a> <b>) about, takes a "
            "CUBE for <b>, and t is a TABLE\n");
}

TEST(Plan, ThatCannotBeIsTracedToAnObjectOfAnotherType) {
  const std::string tables = file("tables.pddl", R"((define (domain tables) (:requirements :typing)
    (:types block table) (:predicates (on ?x ?y) (clear ?x))
    (:action put :parameters (?x - block ?y - block) :precondition (clear ?x) :effect (on ?x ?y))))");
  const std::string text = file("tables-problem.pddl", R"((define (problem p) (:domain tables)
      (:objects a - block t - table) (:init (clear a)) (:goal (on a t))))");
  EXPECT_EQ(shell(fmt::format("{} plan {} {} 2>&1", PIZARRA_PLAN, tables, text)).text,
            "pizarra: no plan exists: (on a t) can never hold from here: put, which brings (on ?x ?y) about, takes a "
            "block for ?y, and t is a table\n");
}

TEST(Plan, ThatCannotBeIsTracedToWhatNeverHoldsTogether) {
  EXPECT_EQ(why("(clear a) (on-table a) (arm-empty)", "(on a a)"),
            "(stack a a) needs (clear a) and (holding a), which never hold together\n");
}

// Every fact can be had, but a coin buys one thing only; of what the last action needs, only that is told.
TEST(Plan, ThatCannotBeIsTracedThroughWhatNeverHoldsByItself) {
  const std::string shop = file("shop.pddl", R"((define (domain shop)
    (:predicates (coin) (open) (bread) (wine) (tired) (meal) (happy) (song))
    (:action buy-bread :precondition (and (open) (coin)) :effect (and (bread) (not (coin))))
    (:action buy-wine :precondition (and (open) (coin)) :effect (and (wine) (not (coin))))
    (:action dine :precondition (and (open) (bread) (wine)) :effect (meal))
    (:action sing :precondition (and (open) (wine)) :effect (song))
    (:action rest :precondition (and (meal) (open)) :effect (happy))
    (:action doze :precondition (and (meal) (song)) :effect (happy))))");
  const std::string text =
      file("evening.pddl", "(define (problem p) (:domain shop) (:init (coin) (open)) (:goal (and (song) (happy))))");
  EXPECT_EQ(shell(fmt::format("{} plan {} {} 2>&1", PIZARRA_PLAN, shop, text)).text,
            "pizarra: no plan exists: (happy) can never hold from here: (happy) needs (meal), and (dine) needs (bread) "
            "and (wine), which never hold together\n");
}

// A road whose length is not told cannot be paid for; the one behind it is not to blame.
TEST(Plan, ThatCannotBeIsTracedToACostWithoutAValue) {
  const std::string roads = file("roads.pddl", R"((define (domain roads)
    (:requirements :typing :action-costs) (:types truck city)
    (:predicates (at ?t - truck ?c - city) (road ?a ?b - city))
    (:functions (total-cost) - number (dist ?a ?b - city) - number)
    (:action drive :parameters (?t - truck ?a ?b - city) :precondition (and (at ?t ?a) (road ?a ?b))
      :effect (and (at ?t ?b) (not (at ?t ?a)) (increase (total-cost) (dist ?a ?b))))))");
  const auto plan_to = [&](const std::string& goal) {
    const std::string trip = file("trip.pddl", fmt::format(R"((define (problem trip) (:domain roads)
      (:objects t1 - truck a b c d - city) (:init (at t1 a) (road a b) (road b c) (= (dist b c) 3))
      (:goal (at t1 {})) (:metric minimize (total-cost))))",
                                                           goal));
    return shell(fmt::format("{} plan {} {} 2>&1", PIZARRA_PLAN, roads, trip)).text;
  };
  const std::string near = "(drive t1 a b) costs (dist a b), and (dist a b) has no value\n";
  EXPECT_EQ(plan_to("b"), "pizarra: no plan exists: (at t1 b) can never hold from here: " + near);
  EXPECT_EQ(plan_to("c"),
            "pizarra: no plan exists: (at t1 c) can never hold from here: (at t1 c) needs (at t1 b), and " + near);
  EXPECT_EQ(plan_to("d"),
            "pizarra: no plan exists: (at t1 d) can never hold from here: (at t1 d) needs (road ?a d), and (road ?a d) "
            "neither holds at the beginning nor is brought about by any operator\n");
}

TEST(Plan, OfWrongFilesIsAUsageError) {
  const Said said = plan("(and (on a d) (clera b))");
  EXPECT_EQ(said.status, 2);
  EXPECT_NE(said.text.find("there is no object d"), std::string::npos) << said.text;
  EXPECT_NE(said.text.find("there is no predicate clera; the nearest is clear"), std::string::npos) << said.text;
  EXPECT_EQ(shell(fmt::format("{} plan /nowhere/a /nowhere/b 2>&1", PIZARRA_PLAN)).status, 2);
  EXPECT_EQ(plan("(on a b)", "--pdl").status, 2);
  for (const std::string time : {"0", "-1", "nan", "inf", "-inf", "1e400", "soon", "''"}) {
    const Said refused = plan("(on a b)", "--time " + time);
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(refused.text.starts_with("pizarra: --time: a time is a number of seconds above 0, not "))
        << refused.text;
    EXPECT_LT(refused.text.size(), 120u);
  }
  const Said both = plan("(on a b)", "--optimal --planner 'ff {domain} {problem}'");
  EXPECT_EQ(both.status, 2);
  EXPECT_NE(both.text.find("excludes"), both.text.npos) << both.text;
  const Said empty = plan("(on a b)", "--planner ' '");
  EXPECT_EQ(empty.status, 2);
  EXPECT_TRUE(empty.text.starts_with("pizarra: --planner: a command must be given")) << empty.text;
  const Said alone = shell(fmt::format("{} plan {} 2>&1", PIZARRA_PLAN, domain()));
  EXPECT_EQ(alone.status, 2);
  EXPECT_EQ(alone.text, "pizarra: PROBLEM is required; pizarra plan --help says more\n");
  const Said folder = shell(fmt::format("{} plan {} / 2>&1", PIZARRA_PLAN, domain()));
  EXPECT_EQ(folder.status, 2);
  EXPECT_EQ(folder.text, "pizarra: / is a folder, and a file must be named\n");
  EXPECT_EQ(plan("(on a b)", "--pddl --json").status, 2);
}

TEST(Plan, ReadsTheThesisFiles) {
  const std::string operators = file("operators", R"(
    (operator PICK-UP (params (<ob1> OBJECT)) (preconds (clear <ob1>) (on-table <ob1>) (arm-empty))
      (effects (holding <ob1>) (del (clear <ob1>)) (del (on-table <ob1>)) (del (arm-empty)))))");
  const std::string facts = file("facts",
                                 "(types (circle OBJECT)) (initials (clear circle) (on-table circle) (arm-empty))"
                                 "(goals (holding circle))");
  const Said said = shell(fmt::format("{} plan {} {} --pddl", PIZARRA_PLAN, operators, facts));
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.text, "(PICK-UP circle)\n");
}

TEST(Plan, MayBeMadeFast) {
  const Said said = plan("(and (on a b) (on b c))", "--fast --time 0.3 --seed 7");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_NE(said.text.find("4 actions; fast, "), std::string::npos) << said.text;
  EXPECT_EQ(plan("(and (on a b) (on b a))", "--fast").status, 3);
  EXPECT_EQ(plan("(on a b)", "--fast --optimal").status, 2);
}

TEST(Plan, MayBeAnotherPlannersAndIsChecked) {
  const Said said = plan("(on a b)", "--pddl --planner 'echo \"0: PICK-UP A\n1: STACK A B\" # {domain} {problem}'");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_EQ(said.text, "(pick-up a)\n(stack a b)\n");
  const Said wrong = plan("(on a b)", "--planner 'echo \"(stack a b)\" > {plan} # {domain} {problem}'");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.text.find("the planner's plan does not work: (stack a b) needs (holding a)"), std::string::npos)
      << wrong.text;
  EXPECT_EQ(plan("(on a b)", "--planner '/nowhere/ff {domain} {problem}'").status, 4);
  EXPECT_EQ(plan("(on a b)", "--planner 'sleep 100 # {domain} {problem}' --time 0.2").status, 1);
  EXPECT_EQ(plan("(on a b)", "--planner 'ff {domain}'").status, 2);
}

// The output of a planner that crashed, failed or ran out of time counts only where it is a plan.
TEST(Plan, OfAnotherPlannerThatEndsBadlyIsTakenOnlyWhereItWorks) {
  const auto with = [](const std::string& script, const std::string& options = "") {
    return plan("(on a b)", fmt::format("--pddl {} --planner '{} # {{domain}} {{problem}}'", options, script));
  };
  const std::string whole = "echo \"(pick-up a)\" > {plan}; echo \"(stack a b)\" >> {plan}; ";
  const std::string half = "echo \"(pick-up a)\" > {plan}; printf \"(stack a\" >> {plan}; ";
  for (const std::string left : {"touch {plan}; ", half.c_str(), "echo \"(pick-up a)\" > {plan}; "}) {
    const Said crashed = with(left + "kill -SEGV $$");
    EXPECT_EQ(crashed.status, 1);
    EXPECT_EQ(crashed.text, "pizarra: the planner was ended by Segmentation fault\n") << left;
    EXPECT_EQ(with(left + "echo no solution; exit 1").text,
              "pizarra: the planner ended with status 1 and without a plan; it said: no solution\n")
        << left;
    EXPECT_EQ(with(left + "sleep 10", "--time 0.3").text, "pizarra: the planner had no plan after 0.3 s\n") << left;
  }
  EXPECT_EQ(with("touch {plan}").text, "pizarra: the planner\'s plan does not work: (on a b) is not reached\n");
  for (const std::string end : {"kill -SEGV $$", "exit 139", "exit 2"}) {
    EXPECT_EQ(with(whole + end).text, "(pick-up a)\n(stack a b)\n") << end;
  }
  EXPECT_EQ(with(whole + "sleep 10", "--time 0.5").text, "(pick-up a)\n(stack a b)\n");
}

// Twenty discs: no planner of ours is through with them soon.
std::string endless() {
  std::string discs, facts, goals;
  for (int i = 1; i <= 20; ++i) {
    discs += fmt::format(" d{}", i);
    const std::string below = i == 20 ? "p1" : fmt::format("d{}", i + 1);
    facts += fmt::format("(on d{} {})", i, below);
    goals += fmt::format("(on d{} {})", i, i == 20 ? "p3" : below);
    for (int j = i + 1; j <= 20; ++j) facts += fmt::format("(smaller d{} d{})", j, i);
    for (int p = 1; p <= 3; ++p) facts += fmt::format("(smaller p{} d{})", p, i);
  }
  const std::string hanoi = file("hanoi.pddl", R"((define (domain hanoi)
    (:predicates (clear ?x) (on ?x ?y) (smaller ?x ?y))
    (:action move :parameters (?disc ?from ?to)
      :precondition (and (smaller ?to ?disc) (on ?disc ?from) (clear ?disc) (clear ?to))
      :effect (and (clear ?from) (on ?disc ?to) (not (on ?disc ?from)) (not (clear ?to))))))");
  return hanoi + " " +
         file("hanoi-20.pddl",
              fmt::format("(define (problem h) (:domain hanoi) (:objects p1 p2 p3{}) (:init (clear d1) (clear p2) "
                          "(clear p3) {}) (:goal (and {})))",
                          discs, facts, goals));
}

TEST(Plan, GivesUpWhenItsTimeIsOver) {
  const Said said = shell(fmt::format("{} plan {} --time 0.3 2>&1", PIZARRA_PLAN, endless()));
  EXPECT_EQ(said.status, 1) << said.text;
  EXPECT_TRUE(said.text.starts_with("pizarra: no plan was found in ")) << said.text;
}

TEST(Plan, IsInterruptedByCtrlC) {
  const Said said =
      shell(fmt::format("timeout --preserve-status --signal=INT 1 {} plan {} 2>&1", PIZARRA_PLAN, endless()));
  EXPECT_EQ(said.status, 130) << said.text;
  EXPECT_TRUE(said.text.starts_with("pizarra: interrupted")) << said.text;
}

// That nobody writes to.
std::string pipe_called(const std::string& name) {
  const std::string path = scratch_folder() + name;
  EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
  return path;
}

TEST(Plan, GivesUpInTimeWhereAFileCannotBeReadToItsEnd) {
  const std::string pipe = pipe_called("silent");
  const auto in_time = [&](const std::string& files, const std::string& options) {
    return shell(fmt::format("timeout -s KILL 5 {} plan {} --time 0.2 {} 2>&1", PIZARRA_PLAN, files, options));
  };
  for (const std::string& files : {pipe + " " + problem("(on a b)"), domain() + " " + pipe}) {
    const Said said = in_time(files, "");
    EXPECT_EQ(said.status, 1) << said.text;
    // The time that it took: what was asked for, and on a busy machine a little more.
    EXPECT_TRUE(
        std::regex_match(said.text, std::regex(R"(pizarra: no plan was found in 0\.[2-9] s; there may be one\n)")))
        << said.text;
    EXPECT_TRUE(in_time(files, "--json").text.starts_with("{\"error\"")) << in_time(files, "--json").text;
  }
}

TEST(Plan, IsInterruptedWhileFilesAreRead) {
  const std::string pipe = pipe_called("mute");
  for (const char* signal : {"INT", "TERM"}) {
    const Said said = shell(fmt::format("timeout --preserve-status -k 5 --signal={} 0.5 {} plan {} {} 2>&1", signal,
                                        PIZARRA_PLAN, domain(), pipe));
    EXPECT_EQ(said.status, 130) << said.text;
    EXPECT_EQ(said.text, "pizarra: interrupted before a plan was found\n");
  }
}

TEST(Plan, SaysWhatItCostsAndThatItWasMadeShortNotCheap) {
  const std::string costs = file("costs.pddl", R"((define (domain ways) (:requirements :strips :action-costs)
    (:predicates (at ?x)) (:constants a b c) (:functions (total-cost))
    (:action fly :parameters () :precondition (at a) :effect (and (not (at a)) (at c) (increase (total-cost) 9)))
    (:action walk :parameters () :precondition (at a) :effect (and (not (at a)) (at b) (increase (total-cost) 1)))
    (:action ride :parameters () :precondition (at b) :effect (and (not (at b)) (at c) (increase (total-cost) 1)))))");
  const std::string way = file("way.pddl", R"((define (problem way) (:domain ways) (:init (at a) (= (total-cost) 0))
    (:goal (at c)) (:metric minimize (total-cost))))");
  for (const char* mode : {"--optimal", "--fast"}) {
    const Said said = shell(fmt::format("{} plan {} {} {} 2>&1", PIZARRA_PLAN, costs, way, mode));
    EXPECT_EQ(said.status, 0) << said.text;
    EXPECT_NE(said.text.find("1 action, cost 9 (made short, not cheap)"), std::string::npos) << said.text;
  }
}

// So many that the tables of the search for fewest steps take tens of megabytes.
Said plan_for_many_blocks(const std::string& options) {
  constexpr int blocks = 130;
  std::string names, facts, goals;
  for (int i = 0; i < blocks; ++i) {
    names += fmt::format(" b{}", i);
    facts += fmt::format(" (on-table b{0}) (clear b{0})", i);
    if (i > 0) goals += fmt::format(" (on b{} b{})", i, i - 1);
  }
  const std::string problem =
      file("many.pddl", fmt::format("(define (problem many) (:domain blocks) (:objects{}) (:init (arm-empty){}) "
                                    "(:goal (and{})))",
                                    names, facts, goals));
  return shell(fmt::format("{} plan {} {} {} 2>&1", PIZARRA_PLAN, domain(), problem, options));
}

// Under AddressSanitizer a program ends where it is given no more memory.
#ifdef __SANITIZE_ADDRESS__
constexpr bool outlives_lack_of_memory = false;
#else
constexpr bool outlives_lack_of_memory = true;
#endif

TEST(Plan, EndsInASentenceWhereMemoryIsTooLittle) {
  if (!outlives_lack_of_memory) GTEST_SKIP() << "its memory cannot be limited under AddressSanitizer";
  for (const auto& [mode, memory_mb] :
       {std::pair{"--optimal", 20}, std::pair{"--optimal", 1}, std::pair{"--fast", 1}}) {
    const Said said = plan_for_many_blocks(fmt::format("{} --memory {}", mode, memory_mb));
    EXPECT_EQ(said.status, 1) << mode << said.text;
    EXPECT_NE(said.text.find(fmt::format("no plan was found within {} MB of memory", memory_mb)), std::string::npos)
        << mode << said.text;
  }
}

TEST(Plan, SaysWhereMoreMemoryMightMakeItShorter) {
  if (!outlives_lack_of_memory) GTEST_SKIP() << "its memory cannot be limited under AddressSanitizer";
  constexpr std::string_view more = "; with more memory it might be shorter\n";
  const Said little = plan_for_many_blocks("--fast --memory 30 --time 3");
  EXPECT_EQ(little.status, 0) << little.text;
  EXPECT_TRUE(little.text.ends_with(more)) << little.text;
  const Said much = plan_for_many_blocks("--fast --memory 200");
  EXPECT_EQ(much.status, 0) << much.text;
  EXPECT_EQ(much.text.find(more), much.text.npos) << much.text;
}

}  // namespace
}  // namespace pizarra::programs
