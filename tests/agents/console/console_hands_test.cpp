// The arm in a page's hands: how the age of what it says is known, and what it makes of a jog.

#include <fmt/format.h>

#include "agents/console/pulse.hpp"
#include "agents/runtime/hold_deadlines.hpp"
#include "lisp/reader.hpp"
#include "tests/agents/console/console_fixture.hpp"

namespace pizarra::console {
namespace {

TEST(PulseOfAPage, KnowsHowOldAStampIs) {
  Pulse pulse;
  const Time begun(10s);
  const std::int64_t first = pulse.beat(begun);
  const std::int64_t second = pulse.beat(begun + 50ms);
  EXPECT_TRUE(pulse.is_fresh(first, begun + 249ms, 250ms));
  EXPECT_FALSE(pulse.is_fresh(first, begun + 250ms, 250ms));
  EXPECT_TRUE(pulse.is_fresh(second, begun + 250ms, 250ms));
  EXPECT_FALSE(pulse.is_fresh(second + 1, begun + 50ms, 250ms)) << "one that was never sent";
  EXPECT_FALSE(pulse.is_fresh(0, begun + 50ms, 250ms));
}

TEST(PulseOfAPage, ForgetsWhatIsOlderThanAnyDeadline) {
  Pulse pulse;
  const std::int64_t first = pulse.beat(Time(0s));
  for (int i = 1; i <= 1000; ++i) pulse.beat(Time(i * 50ms));
  EXPECT_FALSE(pulse.is_fresh(first, Time(1ms), 600ms));
}

TEST(PulseOfAPage, LetsASilenceLastAsTheLineIsLong) {
  const auto deadline_at = [](Duration round_trip) {
    Pulse pulse;
    for (int i = 0; i < 100; ++i) {
      const Time sent(i * 1s);
      pulse.came_back(pulse.beat(sent), sent + round_trip);
    }
    return pulse.deadline();
  };
  EXPECT_EQ(Pulse().deadline(), 600ms) << "nobody knows yet";
  EXPECT_EQ(deadline_at(1ms), 250ms);
  EXPECT_EQ(deadline_at(100ms), 400ms);
  EXPECT_EQ(deadline_at(160ms), 550ms);
  EXPECT_EQ(deadline_at(2s), 600ms);
}

class HeldPage : public ConsoleTest {
 protected:
  HeldPage() {
    declare("(relation hold ((robot symbol) (client symbol) (count integer)) (key robot client))");
    declare("(relation commander ((robot symbol) (client symbol)) (key robot client))");
    declare("(relation agent ((name symbol) (kind symbol) (host string)) (key name))");
    declare("(relation request ((id symbol) (agent symbol) (operation datum)) (key id))");
    EXPECT_TRUE(run(executor_, here_->tell(list("agent"_sym, "robot"_sym, "robot"_sym, "localhost"))));
  }
  std::size_t how_many(const std::string& pattern) {
    const auto found = run(executor_, here_->facts(read_one(pattern).value()));
    return found ? found->size() : 0;
  }
  std::int64_t stamp(RawClient& client) {
    return serve([&] { return client.read_stamp(); });
  }
};

TEST_F(HeldPage, HoldsOnWhileThePageSaysSoAndLetsGoWhenItDoes) {
  const auto client = page(cookie());
  const std::int64_t newest = stamp(*client);
  serve([&] { client->send_frame(RawClient::text, fmt::format("(jog 7 robot left {})", newest)); });
  executor_.run_until([&] { return how_many("(request ? robot (jog left ?))") == 1; });
  EXPECT_EQ(how_many("(hold robot console-1 1)"), 1u);
  serve([&] { client->send_frame(RawClient::text, fmt::format("(hold-on 7 {})", newest)); });
  executor_.run_until([&] { return how_many("(hold robot console-1 2)") == 1; });
  serve([&] { client->send_frame(RawClient::text, "(release 7)"); });
  executor_.run_until([&] { return how_many("(hold robot ? ?)") == 0; });
}

TEST_F(HeldPage, MovesNothingForAJogThatItsReleaseComesWith) {
  const auto client = page(cookie());
  const std::int64_t newest = stamp(*client);
  const std::string jog = RawClient::frame_of(RawClient::text, fmt::format("(jog 7 robot left {})", newest));
  const std::string release = RawClient::frame_of(RawClient::text, "(release 7)");
  const std::string answer = serve([&] {
    client->send(jog + release);
    return client->read_frame()->payload;
  });
  EXPECT_NE(answer.find("\"reply\":7"), std::string::npos) << answer;
  EXPECT_EQ(how_many("(request ? ? ?)"), 0u);
  EXPECT_EQ(how_many("(hold ? ? ?)"), 0u);
}

// Each way loses packets of its own.
TEST_F(HeldPage, TakesAJogFromWhicheverWayBringsItFirstAndOnce) {
  const std::string own = cookie();
  const auto client = page(own);
  const auto beside = lane(own);
  const std::int64_t newest = stamp(*client);
  const auto say = [&](RawClient& on, const std::string& form) {
    serve([&] { on.send_frame(RawClient::text, form); });
  };
  const std::string jog = fmt::format("(jog 7 robot left {})", newest);
  say(*beside, jog);
  executor_.run_until([&] { return how_many("(request ? robot (jog left ?))") == 1; });
  say(*client, jog);
  say(*client, fmt::format("(hold-on 7 {})", newest));
  executor_.run_until([&] { return how_many("(hold robot console-1 2)") == 1; });
  say(*beside, "(release 7)");
  executor_.run_until([&] { return how_many("(hold robot ? ?)") == 0; });
  // The slower way brings the same when the jog has ended; an answer shows that it was taken in.
  say(*client, fmt::format("(hold-on 7 {})", newest));
  say(*client, "(release 6)");
  EXPECT_NE(said(*client, "(stop 8 \"x\")").find("\"reply\":8"), std::string::npos);
  EXPECT_EQ(how_many("(hold robot ? ?)"), 0u);
  EXPECT_EQ(how_many("(request ? robot (jog left ?))"), 1u);
}

TEST_F(HeldPage, TakesAStopFromWhicheverWayBringsItFirstAndOnce) {
  declare("(relation stop ((who symbol) (reason string)) (key who) (durable))");
  const std::string own = cookie();
  const auto client = page(own);
  const auto beside = lane(own);
  serve([&] { beside->send_frame(RawClient::text, "(stop 5 \"a hand\")"); });
  const auto confirmed = serve([&] { return client->read_frame(); });
  ASSERT_TRUE(confirmed);
  EXPECT_EQ(confirmed->payload, "{\"reply\":5,\"values\":[]}");
  EXPECT_EQ(how_many("(stop console-1 \"a hand\")"), 1u);
  ASSERT_TRUE(run(executor_, here_->retract(read_one("(stop ? ?)").value())));
  serve([&] { client->send_frame(RawClient::text, "(stop 5 \"a hand\")"); });
  EXPECT_NE(said(*client, "(let-go 6 robot)").find("\"reply\":6"), std::string::npos) << "the slower way was taken in";
  EXPECT_EQ(how_many("(stop ? ?)"), 0u) << "what somebody cleared is not told anew";
  EXPECT_NE(said(*client, "(stop 7 \"again\")").find("\"reply\":7"), std::string::npos);
  EXPECT_EQ(how_many("(stop ? ?)"), 1u);
}

TEST_F(HeldPage, MovesNothingForWhatComesLate) {
  const auto client = page(cookie());
  const std::int64_t newest = stamp(*client);
  const Time late = executor_.now() + runtime::longest_hold_deadline;
  executor_.run_until([&] { return executor_.now() > late || tick(); });
  EXPECT_NE(said(*client, fmt::format("(jog 7 robot left {})", newest)).find("\"late\""), std::string::npos);
  EXPECT_EQ(how_many("(request ? ? ?)"), 0u);
  EXPECT_EQ(how_many("(hold ? ? ?)"), 0u);
}

TEST_F(HeldPage, OneThatGoesAwayHoldsOnNoMore) {
  auto client = page(cookie());
  const std::int64_t newest = stamp(*client);
  serve([&] { client->send_frame(RawClient::text, fmt::format("(jog 7 robot left {})", newest)); });
  executor_.run_until([&] { return how_many("(hold robot ? ?)") == 1; });
  client.reset();
  executor_.run_until([&] { return how_many("(hold robot ? ?)") == 0; });
}

}  // namespace
}  // namespace pizarra::console
