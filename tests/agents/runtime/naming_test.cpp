// The thesis' naming service as facts: its operations, the scenarios that it must survive, and its pitfalls.

#include "agents/runtime/naming.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/agents/runtime/member.hpp"

namespace pizarra::runtime {
namespace {

class NamingTest : public testing::TestWithParam<WallKind> {
 protected:
  NamingTest() : wall(GetParam().make()) {}

  std::unique_ptr<Member> member(const std::string& name, const std::string& kind = "robot",
                                 const std::string& host = "here") {
    auto made = std::make_unique<Member>(*wall, name, kind, host);
    made->enter();
    return made;
  }
  // Without the names under which agents bind themselves.
  static std::vector<NamedEntry> others_of(const Result<Listing>& listing) {
    std::vector<NamedEntry> others = listing.value().entries;
    std::erase_if(others, [](const NamedEntry& entry) { return entry.path.front() == "cell"; });
    return others;
  }
  static std::string symbol_of(const auto& result) { return result.has_value() ? "ok" : result.error().symbol; }

  std::unique_ptr<Wall> wall;
};

INSTANTIATE_TEST_SUITE_P(Walls, NamingTest, testing::ValuesIn(agent_walls()),
                         [](const auto& tested) { return tested.param.name; });

const Path robots{"robots"};
const Path crs{"robots", "crs-f3"};
const Path left{"robots", "crs-f3", "left"};
const Path right{"robots", "crs-f3", "right"};

TEST_P(NamingTest, WhatIsBoundIsResolvedListedReboundAndUnbound) {
  const auto one = member("robot-1");
  const auto two = member("robot-2");
  Naming& naming = one->naming;
  EXPECT_EQ(symbol_of(one->run(naming.make_context(crs))), "ok");
  EXPECT_EQ(symbol_of(one->run(naming.make_context(crs))), "ok");
  EXPECT_EQ(symbol_of(one->run(naming.bind(left, {"robot", "robot-1"}))), "ok");
  EXPECT_EQ(two->run(two->naming.resolve(left)).value(), (Reference{"robot", "robot-1"}));
  EXPECT_EQ(others_of(one->run(naming.list({}))), (std::vector<NamedEntry>{{robots, std::nullopt}}));
  EXPECT_EQ(one->run(naming.list(robots)).value().entries, (std::vector<NamedEntry>{{crs, std::nullopt}}));
  EXPECT_EQ(one->run(naming.list(crs)).value().entries,
            (std::vector<NamedEntry>{{left, Reference{"robot", "robot-1"}}}));
  EXPECT_EQ(symbol_of(two->run(two->naming.bind(left, {"robot", "robot-2"}))), "already-bound");
  EXPECT_EQ(symbol_of(two->run(two->naming.rebind(left, {"robot", "robot-2"}))), "ok");
  EXPECT_EQ(one->run(naming.resolve(left)).value().agent, "robot-2");
  EXPECT_EQ(symbol_of(two->run(two->naming.unbind(left))), "ok");
  EXPECT_EQ(symbol_of(two->run(two->naming.unbind(left))), "ok");
  EXPECT_EQ(symbol_of(one->run(naming.resolve(left))), "unbound");
}

TEST_P(NamingTest, WhoOffersSomethingIsBoundByItsNameAndKind) {
  const auto client = member("client", "person");
  auto server = member("robot-1");
  const NamedEntry own{{"cell", "arms", "robot-1"}, Reference{"robot", "robot-1"}};
  const auto found = [&] { return client->run(client->naming.find("robot")).value().entries; };
  EXPECT_EQ(found(), std::vector<NamedEntry>{own});
  // Whoever retracts it does not live under that name.
  client->run(client->naming.unbind(own.path)).value();
  wall->pass(1s);
  EXPECT_EQ(found(), std::vector<NamedEntry>{own});
  server.reset();
  wall->pass(3s);
  EXPECT_TRUE(found().empty());
}

// Scenario (a).
TEST_P(NamingTest, AClientMayStartBeforeItsServerAndOutliveIt) {
  const auto client = member("client", "person");
  client->run(client->naming.make_context(crs)).value();
  std::optional<Result<Reference>> found;
  const auto look = [&](Duration patience) -> Task<void> {
    const Time deadline = wall->executor().now() + patience;
    Result<Reference> reference = co_await client->naming.await(left, deadline);
    found.emplace(std::move(reference));
  };
  const Job waiting = wall->executor().spawn(look(10s));
  wall->pass(20ms);
  EXPECT_FALSE(found.has_value());
  auto server = member("robot-1");
  server->run(server->naming.bind(left, {"robot", "robot-1"})).value();
  wall->pass(20ms);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->value().agent, "robot-1");
  EXPECT_TRUE(client->ask("robot-1", "(where)").has_value());

  server.reset();
  const auto resolved = [&] { return symbol_of(client->run(client->naming.resolve(left))); };
  for (int looks = 0; looks < 200 && resolved() == "ok"; ++looks) wall->pass(50ms);
  EXPECT_EQ(resolved(), "unbound");
  const Time soon = wall->executor().now() + 20ms;
  EXPECT_EQ(symbol_of(client->run(client->naming.await(left, soon))), "timeout");
}

// Scenario (b).
TEST_P(NamingTest, AServerThatDiedWithoutUnbindingBindsItsNameAgain) {
  const auto client = member("client", "person");
  client->run(client->naming.make_context(crs)).value();
  {
    const auto server = member("robot-1", "robot", "first life");
    EXPECT_EQ(symbol_of(server->run(server->naming.bind(left, {"robot", "robot-1"}))), "ok");
  }
  // Its successor enters when the presence of the dead one has lapsed, and that took the binding along.
  const auto again = member("robot-1", "robot", "second life");
  EXPECT_EQ(symbol_of(again->run(again->naming.bind(left, {"robot", "robot-1"}))), "ok");
  const Reference found = client->run(client->naming.resolve(left)).value();
  EXPECT_EQ(client->ask(found.agent, "(where)").value(), list("second life"));
}

// Scenario (c).
TEST_P(NamingTest, AServerOfSeveralObjectsShutsDownInOrder) {
  const auto client = member("client", "person");
  auto server = member("robot-1");
  server->run(server->naming.make_context(crs)).value();
  server->run(server->naming.bind(left, {"robot", "robot-1"})).value();
  server->run(server->naming.bind(right, {"robot", "robot-1"})).value();
  server->run(server->naming.bind({"arm"}, {"robot", "robot-1"})).value();
  std::optional<Result<Datum>> answer;
  const auto call = [&]() -> Task<void> {
    Datum slow = list("slow"_sym);
    Result<Datum> result = co_await client->caller.call("robot-1", slow, 5s);
    answer.emplace(std::move(result));
  };
  const Job calling = wall->executor().spawn(call());
  wall->pass(100ms);
  EXPECT_EQ(symbol_of(server->run(server->naming.unbind_all())), "ok");
  EXPECT_TRUE(others_of(client->run(client->naming.find("robot"))).empty());
  EXPECT_EQ(symbol_of(server->run(server->service.leave(5s))), "ok");
  ASSERT_TRUE(wall->comes([&] { return answer.has_value(); }));
  EXPECT_TRUE(answer->has_value());
  server.reset();
  // Its name is free at once, long before a lease would lapse.
  const Time before = wall->executor().now();
  const auto next = member("robot-1");
  EXPECT_LT(wall->executor().now() - before, 1s);
}

// Scenario (d).
TEST_P(NamingTest, AWrongNameIsToldTheRightOneAndAChangedOneIsFoundByKind) {
  const auto server = member("robot-1");
  server->run(server->naming.make_context(crs)).value();
  server->run(server->naming.bind(left, {"robot", "robot-1"})).value();
  const Result<Reference> wrong = server->run(server->naming.resolve({"robots", "crs-f3", "lft"}));
  ASSERT_FALSE(wrong.has_value());
  EXPECT_EQ(wrong.error().sentence, "nothing is bound as robots/crs-f3/lft; did you mean left?");
  EXPECT_EQ(others_of(server->run(server->naming.find("robot"))),
            (std::vector<NamedEntry>{{left, Reference{"robot", "robot-1"}}}));
  // Of another type than was agreed: refused where it is bound.
  EXPECT_EQ(symbol_of(server->run(server->naming.bind(right, {"camera", "robot-1"}))), "absent");
}

TEST_P(NamingTest, NothingThatIsNotThereIsBound) {
  const auto server = member("robot-1");
  EXPECT_EQ(symbol_of(server->run(server->naming.bind({"arm"}, {"robot", "nobody"}))), "absent");
  EXPECT_EQ(symbol_of(server->run(server->naming.bind({"arm"}, {"", ""}))), "bad-name");
  EXPECT_EQ(symbol_of(server->run(server->naming.rebind({"arm"}, {"robot", "nobody"}))), "absent");
}

TEST_P(NamingTest, UnusualNamesAreRefusedEverywhere) {
  const auto server = member("robot-1");
  const std::vector<Path> odd = {
      {}, {""}, {"*"}, {"?x"}, {"a/b"}, {"a b"}, {"\n"}, {"7up"}, {std::string(65, 'a')}, Path(17, "deep"), {"\xff"}};
  for (const Path& path : odd) {
    EXPECT_EQ(symbol_of(server->run(server->naming.make_context(path))), "bad-name");
    EXPECT_EQ(symbol_of(server->run(server->naming.bind(path, {"robot", "robot-1"}))), "bad-name");
    EXPECT_EQ(symbol_of(server->run(server->naming.resolve(path))), "bad-name");
    EXPECT_EQ(symbol_of(server->run(server->naming.unbind(path))), "bad-name");
  }
  const Path longest(16, std::string(64, 'a'));
  EXPECT_EQ(symbol_of(server->run(server->naming.make_context(longest))), "ok");
}

TEST_P(NamingTest, NoContextIsOrphaned) {
  const auto server = member("robot-1");
  EXPECT_EQ(symbol_of(server->run(server->naming.bind(left, {"robot", "robot-1"}))), "no-context");
  server->run(server->naming.make_context(crs)).value();
  server->run(server->naming.bind(left, {"robot", "robot-1"})).value();
  EXPECT_EQ(symbol_of(server->run(server->naming.remove_context(robots))), "not-empty");
  EXPECT_EQ(symbol_of(server->run(server->naming.remove_context(crs))), "not-empty");
  server->run(server->naming.unbind(left)).value();
  EXPECT_EQ(symbol_of(server->run(server->naming.remove_context(crs))), "ok");
  EXPECT_EQ(symbol_of(server->run(server->naming.remove_context(robots))), "ok");
  EXPECT_TRUE(others_of(server->run(server->naming.list({}))).empty());
}

TEST_P(NamingTest, ANameIsAContextOrABindingAndNeverBoth) {
  const auto server = member("robot-1");
  server->run(server->naming.make_context(robots)).value();
  EXPECT_EQ(symbol_of(server->run(server->naming.rebind(robots, {"robot", "robot-1"}))), "already-bound");
  server->run(server->naming.bind({"arm"}, {"robot", "robot-1"})).value();
  EXPECT_EQ(symbol_of(server->run(server->naming.make_context({"arm", "left"}))), "already-bound");
}

// A listing is one value: there is no iterator that could pile up, or outlive the service.
TEST_P(NamingTest, AListingIsWholeWhateverHappensAfterIt) {
  const auto server = member("robot-1");
  server->run(server->naming.make_context(robots)).value();
  constexpr std::size_t many = 200;
  for (std::size_t i = 0; i < many; ++i) {
    server->run(server->naming.bind({"robots", fmt::format("r{}", i)}, {"robot", "robot-1"})).value();
  }
  const std::vector<NamedEntry> listed = server->run(server->naming.list(robots)).value().entries;
  server->run(server->naming.unbind_all()).value();
  EXPECT_EQ(listed.size(), many);
  EXPECT_TRUE(server->run(server->naming.list(robots)).value().entries.empty());
}

TEST_P(NamingTest, AListingThatIsCutSaysSo) {
  const auto one = member("robot-1");
  one->run(one->naming.make_context(robots)).value();
  one->run(one->naming.bind({"robots", "z"}, {"robot", "robot-1"})).value();
  const auto fill = [&]() -> Task<void> {
    Transaction transaction;
    for (std::size_t n = 0; n < Naming::max_listed - 1; ++n) {
      const std::string name = "c" + std::to_string(n);
      transaction.tell(list("context"_sym, list("robots"_sym), Datum::symbol(name)));
    }
    const Result<Revision> told = co_await one->context.board.transact(std::move(transaction));
    EXPECT_TRUE(told.has_value());
  };
  const Job filling = wall->executor().spawn(fill());
  wall->pass(100ms);
  const Listing whole = one->run(one->naming.list(robots)).value();
  EXPECT_EQ(whole.entries.size(), Naming::max_listed);
  EXPECT_FALSE(whole.cut);
  one->run(one->naming.make_context({"robots", "a"})).value();
  const Listing cut = one->run(one->naming.list(robots)).value();
  EXPECT_EQ(cut.entries.size(), Naming::max_listed);
  EXPECT_TRUE(cut.cut);
  EXPECT_EQ(one->run(one->naming.resolve({"robots", "z"})).value().agent, "robot-1");
}

TEST_P(NamingTest, ABackupTakesOverTheNameAndTheRequestInHand) {
  const auto client = member("client", "person");
  auto first = member("robot-1", "robot", "bench");
  Member backup(*wall, "robot-1", "robot", "desk");
  backup.begin();
  std::optional<Result<Datum>> answer;
  const auto call = [&]() -> Task<void> {
    Datum slow = list("slow"_sym);
    Result<Datum> result = co_await client->caller.call("robot-1", slow, 8s);
    answer.emplace(std::move(result));
  };
  const Job calling = wall->executor().spawn(call());
  wall->pass(100ms);
  EXPECT_FALSE(backup.is_in());
  first.reset();
  wall->pass(3500ms);
  EXPECT_TRUE(backup.is_in());
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->value(), list("desk"));
}

TEST_P(NamingTest, AnAgentMovesToAnotherHostAndItsClientsNoticeAPauseAtMost) {
  const auto client = member("client", "person");
  client->run(client->naming.make_context(crs)).value();
  auto agent = member("robot-1", "robot", "bench");
  agent->run(agent->naming.bind(left, {"robot", "robot-1"})).value();
  std::vector<Result<Datum>> answers;
  bool enough = false;
  const auto call_often = [&]() -> Task<void> {
    while (!enough) {
      Datum where = list("where"_sym);
      Result<Datum> result = co_await client->caller.call("robot-1", where, 8s);
      answers.push_back(std::move(result));
      co_await sleep(wall->executor(), 10ms);
    }
  };
  const Job calling = wall->executor().spawn(call_often());
  wall->pass(200ms);
  EXPECT_EQ(symbol_of(agent->run(agent->service.leave(2s))), "ok");
  agent.reset();
  const auto moved = member("robot-1", "robot", "desk");
  moved->run(moved->naming.bind(left, {"robot", "robot-1"})).value();
  wall->pass(500ms);
  enough = true;
  wall->pass(100ms);
  ASSERT_FALSE(answers.empty());
  for (const Result<Datum>& answer : answers) EXPECT_TRUE(answer.has_value()) << answer.error().sentence;
  EXPECT_EQ(answers.front().value(), list("bench"));
  EXPECT_EQ(answers.back().value(), list("desk"));
  EXPECT_EQ(client->run(client->naming.resolve(left)).value().agent, "robot-1");
}

}  // namespace
}  // namespace pizarra::runtime
