// What each key permits: to tell, read, take and declare.

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>

#include "blackboard/limits.hpp"
#include "tests/blackboard/security_fixture.hpp"

namespace pizarra {
namespace {

TEST_F(SecurityTest, SaysToAClientWhatItsOwnKeyPermitsAndCountsNoRefusal) {
  serve();
  const auto permissions_of = [&](Board& board) {
    std::vector<std::string> said;
    const Result<std::vector<Fact>> permissions = run(board.facts(read("(own-permission ?verb ?relation)")));
    EXPECT_TRUE(permissions) << permissions.error().sentence;
    for (const Fact& fact : *permissions) said.push_back(write(fact.datum));
    std::ranges::sort(said);
    return fmt::format("{}", fmt::join(said, " "));
  };
  const auto robot = view("robot");
  EXPECT_EQ(permissions_of(*robot),
            "(own-permission read arm*) (own-permission read job) (own-permission take job) "
            "(own-permission tell agent) (own-permission tell arm)");
  EXPECT_EQ(permissions_of(*view("boss")), "(own-permission read *) (own-permission take *) (own-permission tell *)");
  EXPECT_EQ(permissions_of(*board_.view("here")),
            "(own-permission override *) (own-permission read *) (own-permission take *) (own-permission tell *)");
  EXPECT_EQ(refusals("robot").size(), 0U);
  EXPECT_EQ(ask(*robot, "(and (own-permission tell ?x) (job ?n))"), "bad-query") << "it is asked for alone";
  EXPECT_EQ(tell(*robot, "(own-permission tell goal)"), "not-permitted");
}

TEST_F(SecurityTest, OfAFactsReasonsAClientHearsThoseThatItMayRead) {
  serve();
  const auto boss = view("boss");
  ASSERT_EQ(tell(*boss, "(goal 1)"), "ok");
  const auto id_of = [&](const char* pattern) {
    const Result<std::vector<Fact>> facts = run(boss->facts(read(pattern)));
    return facts->front().id;
  };
  const FactId goal = id_of("(goal ?n)");
  ASSERT_TRUE(run(boss->tell(read("(job 1)"), std::vector<FactId>(1, goal))).has_value());
  const Query why = query(fmt::format("(provenance {} ?id ?fact ?teller ?when ?because)", id_of("(job ?n)")));
  EXPECT_EQ(run(boss->ask(why))->answers.size(), 2U);
  const Result<Answers> heard = run(view("robot")->ask(why));
  ASSERT_TRUE(heard) << heard.error().sentence;
  ASSERT_EQ(heard->answers.size(), 1U);
  EXPECT_EQ(*heard->answers.front().bindings.find("?fact"), read("(job 1)"));
}

TEST_F(SecurityTest, WhoMayDeclareWhatBeginsWithANameLeavesTheBoardRoomForOthers) {
  serve();
  const auto robot = view("robot");
  const auto declare = [&](Board& board, int number) {
    return symbol_of(run(board.declare({relation(fmt::format("(relation arm-{} ((n integer)))", number))})));
  };
  std::string said = "ok";
  int declared = 0;
  for (; said == "ok" && declared < 1000; ++declared) said = declare(*robot, declared);
  EXPECT_EQ(said, "too-large");
  EXPECT_LE(declared, 260);
  std::vector<Relation> at_once;
  for (int i = 0; i < 300; ++i) at_once.push_back(relation(fmt::format("(relation arm-at-once-{} ((n integer)))", i)));
  EXPECT_EQ(symbol_of(run(robot->declare(at_once))), "too-large");
  EXPECT_EQ(declare(*robot, 0), "ok") << "it is there";
  EXPECT_EQ(declare(*view("boss"), declared), "ok");
}

TEST_F(SecurityTest, NobodyTellsReadsOrTakesWhatItsKeyDoesNotAllow) {
  serve();
  const auto boss = view("boss");
  const auto robot = view("robot");
  for (const char* fact : {"(goal 1)", "(arm idle)", "(job 1)"}) ASSERT_EQ(tell(*boss, fact), "ok") << fact;
  const Result<Revision> refused = run(robot->tell(read("(goal 2)")));
  ASSERT_EQ(symbol_of(refused), "not-permitted");
  EXPECT_EQ(refused.error().sentence, "the key robot may not tell facts of goal");
  EXPECT_EQ(refused.error().subject, read("(goal 2)"));
  EXPECT_EQ(retract(*robot, "(goal ?)"), "not-permitted");
  EXPECT_EQ(ask(*robot, "(goal ?n)"), "not-permitted");
  EXPECT_EQ(ask(*robot, "(and (arm ?s) (not (goal ?n)))"), "not-permitted");
  EXPECT_EQ(symbol_of(run(robot->watch(query("(goal ?n)")))), "not-permitted");
  EXPECT_EQ(symbol_of(run(robot->take(read("(arm ?)"), 0))), "not-permitted");
  Transaction curious;
  curious.require(Transaction::Present{read("(goal 1)")}).tell(read("(arm moving)"));
  EXPECT_EQ(symbol_of(run(robot->transact(curious))), "not-permitted");
  const std::vector<Relation> own_idea = {relation("(relation plan ((n integer)))")};
  EXPECT_EQ(symbol_of(run(robot->declare(own_idea))), "not-permitted");
  // A client does not learn the declarations of relations that it has no right to.
  const std::string guesses[] = {"(relation goal ((n integer)) (key n))", "(relation goal ((n symbol)))"};
  for (const std::string& guess : guesses) {
    const Result<void> learned = run(robot->declare({relation(guess)}));
    ASSERT_EQ(symbol_of(learned), "not-permitted") << guess;
    EXPECT_EQ(learned.error().sentence, "the key robot may not declare goal");
    EXPECT_EQ(learned.error().subject, relation_to_datum(relation(guess))) << "no more than what it said";
  }
  EXPECT_EQ(symbol_of(run(robot->declare({relation("(relation job ((n integer)) (key n))")}))), "ok");

  EXPECT_EQ(tell(*robot, "(arm moving)"), "ok");
  EXPECT_EQ(ask(*robot, "(arm ?s)"), "ok");
  EXPECT_EQ(ask(*robot, "(arm-pose ?x)"), "ok") << "a beginning with a star";
  EXPECT_EQ(symbol_of(run(robot->take(read("(job ?)"), 0))), "ok");
  const std::vector<Fact> told = refusals("robot");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told.front().datum[3].integer(), 10);
  const auto hand = view("robot", "prompt-17");
  EXPECT_EQ(ask(*hand, "(goal ?n)"), "not-permitted");
  EXPECT_EQ(refusals("robot").front().datum[3].integer(), 11) << "it is the key that was refused";
  EXPECT_TRUE(refusals("robot/prompt-17").empty());
}

TEST_F(SecurityTest, WhatAnotherToldUnderItsLeaseIsLeftToItUnlessThatIsPermitted) {
  ASSERT_TRUE(wire::make_keys(folder_, "warden", {{"agent"}, {}, {}, {"agent"}}).has_value());
  serve();
  const auto boss = view("boss");
  const auto robot = view("robot");
  const LeaseId lease = run(boss->lease(60s)).value();
  ASSERT_EQ(tell(*boss, "(agent boss)", lease), "ok");
  ASSERT_EQ(tell(*boss, "(agent loose)"), "ok");
  EXPECT_EQ(retract(*robot, "(agent ?)"), "not-permitted");
  EXPECT_EQ(tell(*robot, "(agent boss)"), "not-permitted") << "it would take the lease away";
  EXPECT_EQ(tell(*robot, "(agent robot)", lease), "not-permitted");
  const Result<void> renewed = run(robot->renew(lease));
  ASSERT_EQ(symbol_of(renewed), "not-permitted");
  EXPECT_EQ(renewed.error().sentence, "the key robot may not use the lease of another");
  EXPECT_EQ(symbol_of(run(robot->release(lease))), "not-permitted");
  EXPECT_EQ(retract(*robot, "(agent loose)"), "ok") << "nobody's lease";
  EXPECT_EQ(symbol_of(run(boss->renew(lease))), "ok");
  const auto warden = view("warden");
  EXPECT_EQ(retract(*warden, "(agent ?)"), "ok");
}

// To permit a transaction and to do it have one bound together.
TEST_F(SecurityTest, WhatAKeyRetractsIsLookedAtWithinTheBoundOfATransaction) {
  serve();
  const std::vector<Relation> pairs = {relation("(relation arm-pair ((a integer) (b integer)))")};
  ASSERT_EQ(symbol_of(run(view("boss")->declare(pairs))), "ok");
  constexpr std::size_t many = limits::examined * 3 / 5;
  Transaction all;
  for (std::size_t i = 0; i < many; ++i) {
    all.tell(list("arm-pair"_sym, i, i + 1));
    if (all.steps.size() < limits::steps / 2 && i + 1 < many) continue;
    ASSERT_EQ(symbol_of(board_.transact("robot", std::exchange(all, {}))), "ok");
  }
  ASSERT_TRUE(wire::make_keys(folder_, "arm", {{"arm*"}, {}, {}, {}}).has_value());
  ASSERT_TRUE(wire::make_keys(folder_, "warden", {{"arm*"}, {}, {}, {"arm*"}}).has_value());
  EXPECT_EQ(retract(*view("arm"), "(arm-pair ?x ?x)"), "too-costly") << "looked at twice";
  EXPECT_EQ(retract(*view("warden"), "(arm-pair ?x ?x)"), "ok") << "looked at once";
  Transaction flood;
  for (int i = 0; i < 200; ++i) flood.retract(read("(arm-pair ?x ?x)"));
  const auto arm = view("arm");
  ASSERT_EQ(symbol_of(run(arm->ask(query("(arm-pair 1 ?)")))), "not-permitted") << "it is met";
  const Time before = executor_.now();
  EXPECT_EQ(symbol_of(run(arm->transact(flood))), "too-costly");
  EXPECT_LT(executor_.now() - before, 1s) << "in which nobody else is served";
}

TEST_F(SecurityTest, WhatAnotherTookIsNotSettledForIt) {
  serve();
  const auto boss = view("boss");
  const auto robot = view("robot");
  ASSERT_EQ(tell(*boss, "(job 1)"), "ok");
  const LeaseId holder = run(boss->lease(60s)).value();
  const FactId taken = run(boss->take(read("(job ?)"), holder)).value()->id;
  Transaction steal;
  steal.settle(taken);
  EXPECT_EQ(symbol_of(run(robot->transact(steal))), "not-permitted");
  EXPECT_EQ(symbol_of(run(boss->transact(steal))), "ok");
}

TEST_F(SecurityTest, ChangedPermissionsHoldForSessionsThatStandAndTheirWatches) {
  serve();
  const auto robot = view("robot");
  const std::unique_ptr<Watch> watch = run(robot->watch(query("(job ?n)"))).value();
  ASSERT_TRUE(run(watch->next()).has_value());
  const std::string path = folder_ + "/robot.key";
  const wire::PublicKey key = wire::read_public_key(path).value();
  std::ofstream(path) << "(key robot \"" << key.key << "\" (tell goal))\n";
  const Result<Change> ended = run(watch->next());
  EXPECT_EQ(symbol_of(ended), "not-permitted");
  EXPECT_EQ(tell(*robot, "(goal 1)"), "ok");
  EXPECT_EQ(tell(*robot, "(arm idle)"), "not-permitted");
}

TEST_F(SecurityTest, NobodyHearsOfARelationThatIsNoneOfItsBusiness) {
  serve();
  const auto boss = view("boss");
  const auto robot = view("robot");
  ASSERT_EQ(symbol_of(run(boss->declare({relation("(relation xarm-plans ((n integer)) (key n))")}))), "ok");
  const auto told = [&](const auto& result) { return result.error().symbol + ": " + result.error().sentence; };
  const std::string without = "undeclared-relation: no relation is called arm-plans";
  EXPECT_EQ(told(run(robot->ask(query("(arm-plans ?n)")))), without);
  EXPECT_EQ(told(run(robot->watch(query("(arm-plans ?n)")))), without);
  const Transaction::Absent none{read("(arm-plans ?)")};
  EXPECT_EQ(told(run(robot->transact(Transaction().tell(read("(arm idle)")).require(none)))), without);
  EXPECT_EQ(told(run(boss->ask(query("(arm-plans ?n)")))), without + "; did you mean xarm-plans?");
  EXPECT_EQ(told(run(robot->ask(query("(arm-pos ?n)")))),
            "undeclared-relation: no relation is called arm-pos; did you mean arm-pose?");
}

}  // namespace
}  // namespace pizarra
