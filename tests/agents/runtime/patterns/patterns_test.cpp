// The communication patterns of the thesis' Table 4.4, on both walls that agents stand on.

#include <gtest/gtest.h>

#include "agents/runtime/patterns/event_pattern.hpp"
#include "agents/runtime/patterns/heavy_light.hpp"
#include "agents/runtime/patterns/push.hpp"
#include "agents/runtime/patterns/query_pattern.hpp"
#include "agents/runtime/patterns/send.hpp"
#include "agents/runtime/patterns/wiring.hpp"
#include "blackboard/streams/remote_streams.hpp"
#include "tests/agents/runtime/member.hpp"

namespace pizarra::runtime {
namespace {

class PatternTest : public testing::TestWithParam<WallKind> {
 protected:
  PatternTest() : wall(GetParam().make()) {}

  std::unique_ptr<Member> member(const std::string& name, const std::string& host = "here") {
    auto made = std::make_unique<Member>(*wall, name, "server", host);
    made->enter();
    return made;
  }
  Time in(Duration time) { return wall->executor().now() + time; }
  bool wait_until(const std::function<bool()>& holds) {
    for (int i = 0; i < 200 && !holds(); ++i) wall->pass(10ms);
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

TEST_P(PatternTest, QueryWaitsForTheAnswer) {
  const auto client = member("client");
  const auto server = member("server", "bench");
  EXPECT_EQ(client->run(query(client->caller, "server", read("(where)"), 2s)).value(), list("bench"));
  EXPECT_EQ(client->run(query(client->caller, "nobody", read("(where)"), 50ms)).error().symbol, "timeout");
}

TEST_P(PatternTest, PushReachesEverySubscriberInOrderAndPullGivesTheNewest) {
  const auto source = member("source");
  const auto one = member("one");
  const auto two = member("two");
  Publisher news(source->context, source->service, "weather");
  Subscriber first = one->run(Subscriber::to(one->context, "weather")).value();
  Subscriber second = two->run(Subscriber::to(two->context, "weather")).value();
  EXPECT_EQ(one->run(pull(one->context, "weather", in(20ms))).error().symbol, "timeout");
  for (int i = 1; i <= 20; ++i) ASSERT_TRUE(source->run(news.push(to_datum(i * i))).has_value());
  for (Subscriber* subscriber : {&first, &second}) {
    for (int i = 1; i <= 20; ++i) {
      const Push push = one->run(subscriber->next()).value();
      EXPECT_EQ(push.number, i);
      EXPECT_EQ(push.data, to_datum(i * i));
    }
  }
  EXPECT_EQ(two->run(pull(two->context, "weather", in(2s))).value().data, to_datum(400));
}

TEST_P(PatternTest, AnEventReachesItsClientOnceAlsoWhenItWasAway) {
  const auto server = member("server");
  const auto other = member("other");
  Notifier notifier(server->context, server->service);
  EXPECT_TRUE(server->run(notifier.notify("client", read("(limit-reached axis-1)"))).has_value());
  EXPECT_TRUE(server->run(notifier.notify("client", read("(limit-reached axis-2)"))).has_value());
  const auto client = member("client");
  EXPECT_EQ(other->run(next_event(other->context, in(20ms))).error().symbol, "timeout");
  EXPECT_EQ(client->run(next_event(client->context, in(2s))).value(), read("(limit-reached axis-1)"));
  EXPECT_EQ(client->run(next_event(client->context, in(2s))).value(), read("(limit-reached axis-2)"));
  EXPECT_EQ(client->run(next_event(client->context, in(20ms))).error().symbol, "timeout");
}

TEST_P(PatternTest, AClientIsWiredToAnotherServerWhileAllRun) {
  const auto master = member("master");
  const auto client = member("client");
  const auto bench = member("eyes-1", "bench");
  const auto desk = member("eyes-2", "desk");
  Wired eyes(client->context, client->caller, "eyes");
  EXPECT_EQ(client->run(eyes.call(read("(where)"), 20ms)).error().symbol, "not-wired");
  master->run(wire(master->context.board, "client", "eyes", "eyes-1")).value();
  EXPECT_EQ(client->run(eyes.call(read("(where)"), 2s)).value(), list("bench"));
  // What is under way stays where it is.
  std::optional<Result<Datum>> slow;
  const auto call = [&]() -> Task<void> {
    Datum operation = list("slow"_sym);
    Result<Datum> answer = co_await eyes.call(operation, 2s);
    slow.emplace(std::move(answer));
  };
  const Job calling = wall->executor().spawn(call());
  wall->pass(50ms);
  master->run(wire(master->context.board, "client", "eyes", "eyes-2")).value();
  EXPECT_EQ(client->run(eyes.call(read("(where)"), 2s)).value(), list("desk"));
  EXPECT_TRUE(wait_until([&] { return slow.has_value(); }));
  EXPECT_EQ(slow->value(), list("bench"));
  master->run(unwire(master->context.board, "client", "eyes")).value();
  EXPECT_EQ(client->run(eyes.call(read("(where)"), 20ms)).error().symbol, "not-wired");
}

class HeavyLightTest : public PatternTest {
 protected:
  // Of one process, or each of its own.
  Streams& streams_of(Member& who) {
    if (GetParam().name == "memory") return local_;
    remote_.push_back(streams::RemoteStreams::open(wall->executor(), who.context.board).value());
    return *remote_.back();
  }
  static StreamFrame frame(std::uint64_t number, std::uint8_t grey) {
    return {number, {}, std::make_shared<Image>(Image{100, 100, 1, std::vector<std::uint8_t>(10'000, grey)})};
  }

 private:
  LocalStreams local_;
  std::vector<std::unique_ptr<Streams>> remote_;
};

INSTANTIATE_TEST_SUITE_P(Walls, HeavyLightTest, testing::ValuesIn(agent_walls()),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(HeavyLightTest, OneFrameIsAnsweredByEveryServerThatLives) {
  const auto client = member("client");
  const auto mean = member("mean");
  const auto size = member("size");
  auto mute = member("mute");
  HeavyAsker asker(client->context, client->service, streams_of(*client), "scene");
  ASSERT_TRUE(client->run(asker.announce()).has_value());
  const auto first_pixel = [](StreamFrame seen) -> Task<Datum> { co_return to_datum(seen.image->pixels[0]); };
  const auto count = [](StreamFrame seen) -> Task<Datum> { co_return to_datum(seen.image->pixels.size()); };
  const auto never = [this](StreamFrame) -> Task<Datum> {
    co_await sleep(wall->executor(), 3600s);
    co_return Datum();
  };
  HeavyServer one(mean->context, mean->service, streams_of(*mean), "scene", first_pixel);
  HeavyServer two(size->context, size->service, streams_of(*size), "scene", count);
  HeavyServer three(mute->context, mute->service, streams_of(*mute), "scene", never);
  const auto serve = [](HeavyServer& server) -> Task<void> {
    const Result<void> ended = co_await server.serve();
    EXPECT_TRUE(ended.has_value());
  };
  const Job jobs[] = {wall->executor().spawn(serve(one)), wall->executor().spawn(serve(two)),
                      wall->executor().spawn(serve(three))};
  wall->pass(100ms);
  const std::vector<LightAnswer> both{{"mean", to_datum(7)}, {"size", to_datum(10'000)}};
  EXPECT_EQ(client->run(asker.ask(frame(1, 7), 600ms)).value(), both);
  const std::vector<LightAnswer> next{{"mean", to_datum(8)}, {"size", to_datum(10'000)}};
  EXPECT_EQ(client->run(asker.ask(frame(2, 8), 600ms)).value(), next);
  // Whose presence was lost, as with a board that began anew, is ready again.
  for (Member* lost : {client.get(), mean.get()}) {
    ASSERT_TRUE(lost->run(lost->context.board.release(lost->service.presence())).has_value());
  }
  wall->pass(1500ms);
  EXPECT_EQ(client->run(asker.ask(frame(3, 8), 600ms)).value(), next);
}

TEST_P(HeavyLightTest, WithoutServersThereAreNoAnswers) {
  const auto client = member("client");
  HeavyAsker asker(client->context, client->service, streams_of(*client), "scene");
  ASSERT_TRUE(client->run(asker.announce()).has_value());
  EXPECT_TRUE(client->run(asker.ask(frame(1, 7), 100ms)).value().empty());
}

}  // namespace
}  // namespace pizarra::runtime
