// Which images a page is sent, and on which connections.

#include <algorithm>
#include <fmt/format.h>

#include "agents/console/page_images.hpp"
#include "tests/agents/console/console_fixture.hpp"
#include "tests/blackboard/passing_board.hpp"

namespace pizarra::console {
namespace {

// As a board is for a key that may not read `stream`.
class NoStreams : public PassingBoard {
 public:
  using PassingBoard::PassingBoard;

  Task<Result<Answers>> ask(Query query) override {
    if (asks_for_streams(query)) co_return fail("not-permitted", "the key blind may not read facts of stream");
    co_return co_await PassingBoard::ask(std::move(query));
  }

  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override {
    if (asks_for_streams(query)) co_return fail("not-permitted", "the key blind may not read facts of stream");
    co_return co_await PassingBoard::watch(std::move(query));
  }

 private:
  static bool asks_for_streams(const Query& query) {
    return std::ranges::any_of(query.clauses, [](const Query::Clause& clause) {
      return clause.form.is_list() && clause.form.size() > 0 && clause.form.head() == "stream";
    });
  }
};

class ConsoleImagesTest : public ConsoleTest {
 protected:
  ConsoleImagesTest() {
    const std::vector<Relation> streams{stream_relation()};
    EXPECT_TRUE(run(executor_, here_->declare(streams)));
  }

  void look(RawClient& page) {
    page.send_frame(RawClient::text, "(look eyes)");
    executor_.run_until([&] { return streams_.watched("eyes") || tick(); });
  }

  void publish(std::uint64_t number) {
    auto image = std::make_shared<Image>();
    image->width = 64;
    image->height = 48;
    image->channels = 3;
    image->pixels.assign(64 * 48 * 3, 90);
    streams_.publish("eyes", {.number = number, .captured = executor_.now(), .image = image});
  }

  // So many milliseconds apart, none of which is drawn meanwhile.
  void publish(std::uint64_t first, std::uint64_t last) {
    for (std::uint64_t number = first; number <= last; ++number) {
      publish(number);
      run(executor_, [](Executor& executor) -> Task<bool> {
        co_await sleep(executor, 2ms);
        co_return true;
      }(executor_));
    }
  }

  // The number of the image that comes next there.
  std::int64_t next_image(RawClient& lane) {
    const auto frame = serve([&] { return lane.read_frame(); });
    if (!frame || frame->kind != RawClient::binary) return -1;
    const std::size_t end = frame->payload.find('\n');
    EXPECT_EQ(frame->payload.substr(end + 1, 2), "\xff\xd8") << "a JPEG";
    return read_one(frame->payload.substr(0, end)).value()[2].integer();
  }

  std::int64_t drawn_and_next_image(RawClient& lane) {
    lane.send_frame(RawClient::text, "(drawn 5)");
    return next_image(lane);
  }
};

TEST_F(ConsoleImagesTest, ShowTheNewestAndNoMoreThanTwoThatWereNotDrawn) {
  const std::string own = cookie();
  const auto client = page(own);
  const auto first = lane(own);
  const auto second = lane(own);
  const auto third = lane(own);
  look(*client);
  // The first picture of a process takes as long as it takes to load what encodes it.
  publish(1);
  EXPECT_EQ(next_image(*first), 1);
  publish(2, 100);
  EXPECT_LT(next_image(*second), 100);
  first->send_frame(RawClient::text, "(drawn 5)");
  EXPECT_EQ(next_image(*third), 100) << "the third got none before, and the first was slow";
  client->send_frame(RawClient::text, "(look-away eyes)");
  executor_.run_until([&] { return !streams_.watched("eyes") || tick(); });
}

TEST_F(ConsoleImagesTest, GoOnByOneLaneWhileAnotherIsHeldUp) {
  const std::string own = cookie();
  const auto client = page(own);
  const auto held_up = lane(own);
  const auto quick = lane(own);
  look(*client);
  publish(1);
  EXPECT_EQ(next_image(*held_up), 1);
  publish(2);
  EXPECT_EQ(next_image(*quick), 2);
  for (std::uint64_t number = 3; number < 20; ++number) {
    publish(number);
    EXPECT_EQ(drawn_and_next_image(*quick), static_cast<std::int64_t>(number));
  }
}

// A line of at least 60 ms there and back: so late the page answers the first stamp, which comes with the hello.
TEST_F(ConsoleImagesTest, HaveALaneOpenedAnewOnWhichOneTookAnotherRoundTripOfALongLine) {
  const std::string own = cookie();
  const auto client = page(own);
  const auto only = lane(own);
  const auto pass = [this](Duration duration) {
    run(executor_, [](Executor& executor, Duration length) -> Task<bool> {
      co_await sleep(executor, length);
      co_return true;
    }(executor_, duration));
  };
  pass(60ms);
  client->send_frame(RawClient::text, "(stamp 1)");
  look(*client);
  publish(1);
  EXPECT_EQ(next_image(*only), 1);
  pass(2s);
  only->send_frame(RawClient::text, "(drawn 5)");
  const auto told = serve([&] { return only->read_frame(); });
  ASSERT_TRUE(told);
  EXPECT_EQ(told->payload, "(renew)");
  publish(2);
  EXPECT_EQ(next_image(*only), 2) << "it serves until then";
}

TEST_F(ConsoleImagesTest, GoOnWhereALaneIsLost) {
  const std::string own = cookie();
  const auto client = page(own);
  auto lost = lane(own);
  look(*client);
  publish(1);
  EXPECT_EQ(next_image(*lost), 1);
  lost.reset();
  const auto other = lane(own);
  publish(2);
  EXPECT_EQ(next_image(*other), 2);
}

TEST_F(ConsoleImagesTest, HaveLanesOfTheirOwnPageAndSessionAloneAndSoManyOfThem) {
  const std::string own = cookie();
  const auto client = page(own);
  token_ = console_->address().substr(console_->address().find('#') + 1);
  const std::string foreign = cookie();
  EXPECT_TRUE(begins(head("GET", "/socket/1", upgrade_headers(foreign)), "HTTP/1.1 404"));
  EXPECT_TRUE(begins(head("GET", "/socket/1", upgrade_headers("none=x")), "HTTP/1.1 403"));
  EXPECT_TRUE(begins(head("GET", "/socket/2", upgrade_headers(own)), "HTTP/1.1 404"));
  std::vector<std::unique_ptr<RawClient>> lanes;
  for (std::size_t i = 0; i < PageImages::max_lanes; ++i) lanes.push_back(lane(own));
  EXPECT_TRUE(begins(head("GET", "/socket/1", upgrade_headers(own)), "HTTP/1.1 503"));
  look(*client);
  publish(1);
  EXPECT_EQ(next_image(*lanes.front()), 1);
}

TEST_F(ConsoleImagesTest, AreSentToNoPageThatMayNotReadTheirStream) {
  const Console::BoardMaker blind = [this](const std::string& name,
                                           const std::string&) -> Result<std::unique_ptr<Board>> {
    return std::make_unique<NoStreams>(board_.view(name));
  };
  reopen([&](Console::Setup& setup) { setup.board = blind; });
  const auto client = page(cookie());
  client->send_frame(RawClient::text, "(look eyes)");
  // It takes the same way to the board as the look before it.
  EXPECT_TRUE(has(said(*client, "(follow 7 (stream ?name ?kind ?place))"), "may not read facts of stream"));
  EXPECT_FALSE(streams_.watched("eyes"));
}

TEST_F(ConsoleImagesTest, EndALaneThatSaysWhatNoneSays) {
  const std::string own = cookie();
  const auto client = page(own);
  for (const char* message : {"(drawn 5)", "(clear-stops 1)", "(drawn", "(jog 7)"}) {
    const auto rude = lane(own);
    const auto frame = serve([&] {
      rude->send_frame(RawClient::text, message);
      return rude->read_frame();
    });
    ASSERT_TRUE(frame) << message;
    EXPECT_EQ(frame->close_code(), 1008) << message;
  }
}

}  // namespace
}  // namespace pizarra::console
