// What subscribers see, the same on every wall.

#include <gtest/gtest.h>
#include <ostream>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/streams/listen_address.hpp"
#include "blackboard/streams/remote_streams.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/blackboard/streams/frames.hpp"

namespace pizarra::streams {
namespace {

struct StreamWall {
  std::string name;
  bool remote;
  std::string listen;  // where frames go over the network
  bool by_network;     // take away the way that this machine alone has
};
void PrintTo(const StreamWall& wall, std::ostream* out) { *out << wall.name; }

class StreamsTest : public testing::TestWithParam<StreamWall> {
 protected:
  StreamsTest() : view_(board_.view("publisher")) {
    subscriber_ = GetParam().remote ? RemoteStreams::open(executor, *view_).value() : nullptr;
    EXPECT_TRUE(board_.declare("publisher", {stream_relation()}).has_value());
    tick();
  }

  // A publisher of a life of its own, as another process would be.
  std::unique_ptr<Streams> publisher() {
    if (!GetParam().remote) return nullptr;
    return RemoteStreams::open(executor, *view_, GetParam().listen).value();
  }
  Streams& subscriber() { return subscriber_ ? *subscriber_ : static_cast<Streams&>(local_); }
  Streams& publishing(const std::unique_ptr<Streams>& life) { return life ? *life : static_cast<Streams&>(local_); }

  void announce(const Streams& streams) {
    Datum fact = stream_fact("eyes", "left", streams);
    if (GetParam().by_network) fact = list(fact[0], fact[1], fact[2], list(fact[3][1]));
    Transaction transaction;
    transaction.tell(fact);
    EXPECT_TRUE(board_.transact("publisher", transaction).has_value());
  }
  bool wait_until(const std::function<bool()>& holds) {
    const Time end = executor.now() + 10s;
    executor.run_until([&] { return holds() || executor.now() > end; });
    return holds();
  }
  // Publishes until the subscriber has seen a frame.
  bool publish_until_seen(Streams& streams, std::uint64_t number, int side = 8) {
    return wait_until([&] {
      streams.publish("eyes", numbered_frame(number, side, side, 3));
      return !seen.empty() && seen.back() == number;
    });
  }
  std::unique_ptr<Streams::Subscription> subscribe() {
    return subscriber().subscribe("eyes", [this](const StreamFrame& frame) {
      EXPECT_TRUE(is_whole(frame));
      seen.push_back(frame.number);
    });
  }

  RealExecutor executor;
  std::vector<std::uint64_t> seen;

 private:
  // The condition is looked at again even where nothing happens by itself.
  void tick() {
    executor.call_at(executor.now() + 1ms, [this] { tick(); });
  }

  memory::MemoryBoard board_{executor};
  std::unique_ptr<Board> view_;
  LocalStreams local_;
  std::unique_ptr<RemoteStreams> subscriber_;
};

INSTANTIATE_TEST_SUITE_P(Walls, StreamsTest,
                         testing::Values(StreamWall{"local", false, "", false}, StreamWall{"memory", true, "", false},
                                         StreamWall{"network", true, "tcp://127.0.0.1:*", true},
                                         StreamWall{"both", true, "tcp://127.0.0.1:*", false}),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(StreamsTest, FramesComeWhileSomebodyWatchesAndOnlyThen) {
  const auto life = publisher();
  Streams& streams = publishing(life);
  announce(streams);
  EXPECT_FALSE(streams.watched("eyes"));
  auto subscription = subscribe();
  EXPECT_TRUE(wait_until([&] { return streams.watched("eyes"); }));
  EXPECT_FALSE(streams.watched("ears"));
  EXPECT_TRUE(publish_until_seen(streams, 1));
  EXPECT_TRUE(publish_until_seen(streams, 2));
  EXPECT_TRUE(std::ranges::is_sorted(seen));
  subscription.reset();
  EXPECT_TRUE(wait_until([&] { return !streams.watched("eyes"); }));
  streams.publish("eyes", numbered_frame(3, 8, 8));
  EXPECT_EQ(seen.back(), 2U);
}

TEST_P(StreamsTest, FramesMayGrowAndShrink) {
  const auto life = publisher();
  Streams& streams = publishing(life);
  announce(streams);
  const auto subscription = subscribe();
  EXPECT_TRUE(publish_until_seen(streams, 1, 8));
  EXPECT_TRUE(publish_until_seen(streams, 2, 300));
  EXPECT_TRUE(publish_until_seen(streams, 3, 1));
  EXPECT_TRUE(publish_until_seen(streams, 4, 301));
}

TEST_P(StreamsTest, ASubscriberMayEndFromInsideItsReceiver) {
  const auto life = publisher();
  Streams& streams = publishing(life);
  announce(streams);
  std::unique_ptr<Streams::Subscription> subscription;
  int frames = 0;
  subscription = subscriber().subscribe("eyes", [&](const StreamFrame&) {
    ++frames;
    subscription.reset();
  });
  EXPECT_TRUE(wait_until([&] {
    streams.publish("eyes", numbered_frame(1, 8, 8));
    return frames > 0;
  }));
  EXPECT_TRUE(wait_until([&] { return !streams.watched("eyes"); }));
  EXPECT_EQ(frames, 1);
}

// A board that lets nobody watch.
class RefusingBoard : public Board {
 public:
  int tries = 0;
  Task<Result<void>> declare(std::vector<Relation>) override {
    ++tries;
    co_return fail("not-permitted", "not you");
  }
  Task<Result<Revision>> transact(Transaction) override { co_return 0U; }
  Task<Result<Answers>> ask(Query) override { co_return Answers(); }
  Task<Result<std::unique_ptr<Watch>>> watch(Query) override { co_return nullptr; }
  Task<Result<std::optional<Fact>>> take(Datum, LeaseId) override { co_return std::nullopt; }
  Task<Result<LeaseId>> lease(Duration) override { co_return 1U; }
  Task<Result<void>> renew(LeaseId) override { co_return Result<void>(); }
  Task<Result<void>> release(LeaseId) override { co_return Result<void>(); }
};

TEST_P(StreamsTest, ASubscriptionThatIsRefusedSaysWhyAndAsksMoreAndMoreSeldom) {
  if (!GetParam().remote || GetParam().by_network) GTEST_SKIP() << "it is the same however frames come";
  RefusingBoard board;
  const auto streams = RemoteStreams::open(executor, board).value();
  const auto subscription = streams->subscribe("eyes", [](const StreamFrame&) {});
  const Time begun = executor.now();
  EXPECT_TRUE(wait_until([&] { return executor.now() > begun + 1300ms; }));
  ASSERT_TRUE(subscription->trouble());
  EXPECT_EQ(subscription->trouble()->symbol, "not-permitted");
  EXPECT_GE(board.tries, 2);
  EXPECT_LE(board.tries, 3);
}

TEST_P(StreamsTest, ASubscriptionGoesOnWithTheNextPublisherUnderTheName) {
  if (!GetParam().remote) GTEST_SKIP() << "publishers of one process share their streams";
  const auto subscription = subscribe();
  auto first = publisher();
  announce(*first);
  EXPECT_TRUE(publish_until_seen(*first, 1));
  first.reset();
  const auto second = publisher();
  announce(*second);
  EXPECT_TRUE(publish_until_seen(*second, 2));
}

TEST_P(StreamsTest, AFrameForManySubscribersReachesEach) {
  const auto life = publisher();
  Streams& streams = publishing(life);
  announce(streams);
  constexpr std::size_t many = 64;
  std::vector<std::uint64_t> newest(many, 0);
  std::vector<std::unique_ptr<Streams::Subscription>> subscriptions;
  for (std::size_t i = 0; i < many; ++i) {
    subscriptions.push_back(
        subscriber().subscribe("eyes", [&newest, i](const StreamFrame& frame) { newest[i] = frame.number; }));
  }
  const auto all_at = [&](std::uint64_t number) {
    return std::ranges::all_of(newest, [&](std::uint64_t seen_number) { return seen_number == number; });
  };
  for (std::uint64_t number = 1; number <= 3; ++number) {
    EXPECT_TRUE(wait_until([&] {
      streams.publish("eyes", numbered_frame(number, 8, 8));
      return all_at(number);
    }));
  }
}

TEST(StreamTickets, AForgedOneShowsNothing) {
  RealExecutor executor;
  const auto broadcast = StreamBroadcast::open(executor, "tcp://127.0.0.1:*").value();
  const auto other = StreamBroadcast::open(executor, "tcp://127.0.0.1:*").value();
  const Datum& ticket = broadcast->ticket();
  const Datum& strange = other->ticket();
  const Datum forged = list(ticket[0], ticket[1], ticket[2], strange[3], strange[4]);
  zmq::context_t context(1);
  int frames = 0;
  const auto count = [&](const StreamFrame&) { ++frames; };
  const auto refused = StreamListener::come(executor, context, forged, "eyes", count);
  ASSERT_TRUE(refused.has_value());
  bool passed = false;
  executor.call_at(executor.now() + 300ms, [&] { passed = true; });
  executor.run_until([&] { return passed; });
  EXPECT_FALSE(broadcast->watched("eyes"));
  const auto admitted = StreamListener::come(executor, context, ticket, "eyes", count);
  executor.run_until([&] { return broadcast->watched("eyes"); });
  broadcast->publish("eyes", numbered_frame(1, 8, 8));
  executor.run_until([&] { return frames > 0; });
  EXPECT_EQ(frames, 1);
}

TEST(StreamAddress, MayBeOneOfIpv6) {
  RealExecutor executor;
  const auto broadcast = StreamBroadcast::open(executor, "tcp://[::1]:*");
  if (!broadcast) GTEST_SKIP() << "this machine has no IPv6: " << describe(broadcast.error());
  zmq::context_t context(1);
  int frames = 0;
  const auto listener =
      StreamListener::come(executor, context, (*broadcast)->ticket(), "eyes", [&](const StreamFrame&) { ++frames; });
  ASSERT_TRUE(listener.has_value()) << describe(listener.error());
  bool late = false;
  executor.call_at(executor.now() + 10s, [&] { late = true; });
  executor.run_until([&] { return (*broadcast)->watched("eyes") || late; });
  (*broadcast)->publish("eyes", numbered_frame(1, 8, 8));
  executor.run_until([&] { return frames > 0 || late; });
  EXPECT_EQ(frames, 1);
}

TEST(StreamAddress, IsOneOfThisMachineWhereOthersComeToTheBoardAndNoneElsewhere) {
  EXPECT_EQ(stream_listen_address("ipc:///tmp/board"), "");
  EXPECT_EQ(stream_listen_address("tcp://127.0.0.1:7800"), "");
  EXPECT_EQ(stream_listen_address("tcp://[::1]:7800"), "");
  EXPECT_EQ(stream_listen_address("no address"), "");
  const std::string out = stream_listen_address("tcp://*:7800");
  if (out.empty()) GTEST_SKIP() << "this machine has no network";
  RealExecutor executor;
  EXPECT_TRUE(StreamBroadcast::open(executor, out).has_value()) << out;
}

TEST(StreamTickets, WhatIsNoneIsRefused) {
  RealExecutor executor;
  zmq::context_t context(1);
  const auto come = [&](const Datum& ticket) {
    return StreamListener::come(executor, context, ticket, "eyes", [](const StreamFrame&) {}).has_value();
  };
  EXPECT_FALSE(come({}));
  EXPECT_FALSE(come(list("tcp"_sym, "tcp://127.0.0.1:1", "short", "keys", "here")));
  EXPECT_FALSE(come(list("tcp"_sym, "udp://127.0.0.1:1", std::string(40, 'a'), std::string(40, 'a'), "")));
  EXPECT_EQ(StreamBroadcast::open(executor, "tcp://*:*").error().symbol, "bad-address");
  EXPECT_EQ(StreamBroadcast::open(executor, "ipc:///tmp/x").error().symbol, "bad-address");
}

}  // namespace
}  // namespace pizarra::streams
