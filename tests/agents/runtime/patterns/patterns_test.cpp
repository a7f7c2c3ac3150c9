// The communication patterns of the thesis' Table 4.4, on both walls that agents stand on.

#include <gtest/gtest.h>

#include "agents/runtime/patterns/send.hpp"
#include "agents/runtime/roles.hpp"
#include "tests/agents/runtime/member.hpp"

namespace pizarra::runtime {
namespace {

class PatternTest : public testing::TestWithParam<WallKind> {
 protected:
  PatternTest() : wall(GetParam().make()) {}

  std::unique_ptr<Member> member(const std::string& name, const std::string& host = "here",
                                 const std::string& kind = "server") {
    auto made = std::make_unique<Member>(*wall, name, kind, host);
    made->enter();
    return made;
  }
  Time in(Duration time) { return wall->executor().now() + time; }
  bool wait_until(const std::function<bool()>& holds, Duration patience = 2s) {
    for (Time end = in(patience); !holds() && wall->executor().now() < end;) wall->pass(10ms);
    return holds();
  }

  std::unique_ptr<Wall> wall;
};

INSTANTIATE_TEST_SUITE_P(Walls, PatternTest, testing::ValuesIn(agent_walls()),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(PatternTest, SendIsDoneWithoutAnybodyWaiting) {
  const auto client = member("client");
  Sender sender(client->context, client->service);
  // Nobody is there yet.
  EXPECT_TRUE(client->run(sender.send("server", read("(take-note 1)"))).has_value());
  const auto server = member("server");
  EXPECT_TRUE(client->run(sender.send("server", read("(take-note 2)"))).has_value());
  EXPECT_TRUE(wait_until([&] { return server->notes.size() == 2; }));
  EXPECT_EQ(server->notes, (std::vector<Datum>{read("1"), read("2")}));
}

// A client with one role, for which two servers of one context compete.
class RolesTest : public PatternTest {
 protected:
  Role eyes() const { return {"eyes", "server", "server", "eyes-1"}; }
  static Result<Datum> ask(Member& client, Roles& roles, const std::string& operation) {
    return client.run(client.caller.call(roles.player("eyes"), read(operation), 2s));
  }
  bool served_by(Roles& roles, const std::string& server, const std::string& state) {
    return wait_until([&] { return roles.holder("eyes") == Holder{server, state}; }, 4s);
  }
};

INSTANTIATE_TEST_SUITE_P(Walls, RolesTest, testing::ValuesIn(agent_walls()),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(RolesTest, AClientIsServedByAnotherFromItsNextCallOn) {
  const auto client = member("client", "here", "client");
  const auto bench = member("eyes-1", "bench");
  const auto desk = member("eyes-2", "desk");
  Roles roles(client->context, client->service, {eyes()});
  roles.start();
  ASSERT_TRUE(served_by(roles, "eyes-1", "wired"));
  EXPECT_EQ(ask(*client, roles, "(where)").value(), list("bench"));
  std::optional<Result<Datum>> slow;
  const auto call = [&]() -> Task<void> {
    Datum operation = list("slow"_sym);
    Result<Datum> answer = co_await client->caller.call(roles.player("eyes"), operation, 2s);
    slow.emplace(std::move(answer));
  };
  const Job calling = wall->executor().spawn(call());
  wall->pass(50ms);
  ASSERT_TRUE(desk->run(desk->context.board.tell(read("(wired client eyes eyes-2)"))).has_value());
  ASSERT_TRUE(served_by(roles, "eyes-2", "wired"));
  EXPECT_EQ(ask(*client, roles, "(where)").value(), list("desk"));
  EXPECT_TRUE(wait_until([&] { return slow.has_value(); }));
  EXPECT_EQ(slow->value(), list("bench"));
  ASSERT_TRUE(desk->run(desk->context.board.retract(read("(wired client eyes ?)"))).has_value());
  EXPECT_TRUE(served_by(roles, "eyes-1", "wired"));
}

TEST_P(RolesTest, TheNextInLineStandsInForOneThatDiedAndGivesBack) {
  const auto client = member("client", "here", "client");
  auto bench = member("eyes-1", "bench");
  const auto other = member("eyes-3", "roof");
  const auto desk = member("eyes-2", "desk");
  Roles roles(client->context, client->service, {eyes()});
  roles.start();
  ASSERT_TRUE(served_by(roles, "eyes-1", "wired"));
  bench.reset();
  EXPECT_TRUE(served_by(roles, "eyes-2", "stands-in"));
  EXPECT_EQ(ask(*client, roles, "(where)").value(), list("desk"));
  const auto told = [&](const std::string& fact) {
    const Result<std::vector<Fact>> facts = client->run(client->context.board.facts(read(fact)));
    return facts && !facts->empty();
  };
  EXPECT_TRUE(wait_until([&] { return told("(holder client eyes eyes-2 stands-in)"); }));
  EXPECT_TRUE(told("(wired client eyes eyes-1)"));
  bench = member("eyes-1", "bench again");
  EXPECT_TRUE(served_by(roles, "eyes-1", "wired"));
  EXPECT_EQ(ask(*client, roles, "(where)").value(), list("bench again"));
}

TEST_P(RolesTest, ARequestToAServerThatDiedIsWithdrawnWhereAnotherStandsIn) {
  const auto client = member("client", "here", "client");
  auto bench = member("eyes-1", "bench");
  const auto desk = member("eyes-2", "desk");
  Roles roles(client->context, client->service, {eyes()});
  roles.start();
  ASSERT_TRUE(served_by(roles, "eyes-1", "wired"));
  std::optional<Result<Datum>> slow;
  const auto call = [&]() -> Task<void> {
    Datum operation = list("slow"_sym);
    Result<Datum> answer = co_await client->caller.call(roles.player("eyes"), operation, 60s);
    slow.emplace(std::move(answer));
  };
  const Job calling = wall->executor().spawn(call());
  wall->pass(50ms);
  bench.reset();
  ASSERT_TRUE(wait_until([&] { return slow.has_value(); }, 6s));
  EXPECT_EQ(slow->error().symbol, "replaced");
  EXPECT_TRUE(client->run(client->context.board.facts(read("(request ? ? ?)")))->empty());
}

TEST_P(RolesTest, WhoIsOfAnotherKindDoesNotServe) {
  const auto client = member("client", "here", "client");
  const auto bench = member("eyes-1", "bench");
  const auto arm = member("arm", "here", "robot");
  Roles roles(client->context, client->service, {eyes()});
  roles.start();
  ASSERT_TRUE(served_by(roles, "eyes-1", "wired"));
  ASSERT_TRUE(arm->run(arm->context.board.tell(read("(wired client eyes arm)"))).has_value());
  EXPECT_TRUE(served_by(roles, "eyes-1", "stands-in"));
}

TEST_P(RolesTest, AServerThatNobodyStandsInForIsAbsent) {
  const auto client = member("client", "here", "client");
  Roles roles(client->context, client->service, {eyes()});
  roles.start();
  EXPECT_FALSE(client->run(roles.wait_for("eyes", in(50ms))));
  EXPECT_EQ(roles.holder("eyes"), (Holder{"eyes-1", "absent"}));
  const auto bench = member("eyes-1", "bench");
  EXPECT_TRUE(client->run(roles.wait_for("eyes", in(2s))));
}

TEST_P(RolesTest, WhoAsksOnceIsToldTheSame) {
  const auto client = member("client", "here", "client");
  const auto holder = [&] { return client->run(holder_of(client->context.board, "client", eyes())).value(); };
  EXPECT_EQ(holder(), (Holder{"eyes-1", "absent"}));
  const auto desk = member("eyes-2", "desk");
  EXPECT_EQ(holder(), (Holder{"eyes-2", "stands-in"}));
  const auto bench = member("eyes-1", "bench");
  EXPECT_EQ(holder(), (Holder{"eyes-1", "wired"}));
}

}  // namespace
}  // namespace pizarra::runtime
