// The client in C, on this machine and at a real door: also where bytes come one at a time, and lines break.

#include <climits>

#include "blackboard/c/pizarra_device.h"
#include "blackboard/time/random.hpp"
#include "drivers/line/tcp_port.hpp"
#include "tests/agents/door/door_fixture.hpp"

namespace pizarra::door {
namespace {

std::string text_of(pizarra_text text) { return {text.at, static_cast<std::size_t>(text.size)}; }

// A device, and what it was told since: "joined", "came 1 (turned one 10)".
class SmallDevice {
 public:
  SmallDevice(std::function<int()> connect, const std::string& name, std::string token, int at_a_time = INT_MAX)
      : connect_(std::move(connect)), name_(name), token_(std::move(token)), at_a_time_(at_a_time) {
    pizarra_begin(&device, &calls_, name_.c_str(), token_.c_str(), 60'000);
  }
  SmallDevice(const SmallDevice&) = delete;
  SmallDevice& operator=(const SmallDevice&) = delete;
  ~SmallDevice() { cut(); }

  // Runs until it was told this, since the last time; or, which is not so, until there is enough.
  bool told(
      Executor& executor, const std::string& beginning, const std::function<bool()>& enough = [] { return false; }) {
    bool was_told = false;
    run_until(executor, [&] {
      const auto now = std::chrono::duration_cast<std::chrono::milliseconds>(executor.now().time_since_epoch());
      pizarra_run(&device, static_cast<std::uint32_t>(now.count() + ahead));
      while (!news.empty()) {
        last = news.front();
        news.erase(news.begin());
        if (last.starts_with(beginning)) return was_told = true;
      }
      return enough();
    });
    return was_told;
  }
  void cut() {
    if (file_ >= 0) ::close(std::exchange(file_, -1));
  }

  pizarra_device device;
  std::vector<std::string> news;
  std::string last;
  std::int64_t ahead = 0;  // of its clock, milliseconds

 private:
  static SmallDevice& of(void* user) { return *static_cast<SmallDevice*>(user); }
  static int open(void* user) {
    of(user).cut();
    of(user).file_ = of(user).connect_();
    return of(user).file_ >= 0 ? 1 : 0;
  }
  static int send(void* user, const char* bytes, int count) {
    const int some = std::min(count, of(user).at_a_time_);
    const ssize_t sent = ::send(of(user).file_, bytes, static_cast<std::size_t>(some), MSG_DONTWAIT | MSG_NOSIGNAL);
    return sent < 0 && errno == EAGAIN ? 0 : static_cast<int>(sent);
  }
  static int receive(void* user, char* into, int room) {
    const int some = std::min(room, of(user).at_a_time_);
    const ssize_t count = ::recv(of(user).file_, into, static_cast<std::size_t>(some), MSG_DONTWAIT);
    if (count < 0 && errno == EAGAIN) return 0;
    return count == 0 ? -1 : static_cast<int>(count);
  }
  static void heard(void* user, const pizarra_news* told) {
    constexpr const char* words[] = {"joined", "leased", "ok", "fail", "anew", "came", "went", "now", "lost", "gone"};
    of(user).news.push_back(std::string(words[told->kind]) + " " + std::to_string(told->number) + " " +
                            text_of(pizarra_nth(told->text, 0)) + (told->cut != 0 ? " cut" : ""));
  }

  std::function<int()> connect_;
  const std::string name_;
  const std::string token_;
  const int at_a_time_;
  int file_ = -1;
  const pizarra_calls calls_ = {this, &SmallDevice::open, &SmallDevice::send, &SmallDevice::receive,
                                &SmallDevice::heard};
};

class SmallDeviceTest : public DoorTest {
 protected:
  std::function<int()> to_door() {
    return [this] { return door_ ? connect_to(door_->port()) : -1; };
  }
};

TEST_F(SmallDeviceTest, TellsWatchesAndKeepsItsLeaseAlsoOneByteAtATime) {
  for (const int at_a_time : {INT_MAX, 1}) {
    SmallDevice table(to_door(), "table", tokens_.at("table"), at_a_time);
    EXPECT_EQ(pizarra_tell(&table.device, "(turned one 1)"), 0);
    ASSERT_TRUE(table.told(executor_, "joined"));
    ASSERT_TRUE(table.told(executor_, "leased"));
    EXPECT_NE(pizarra_watch(&table.device, 7, "(turned ?t ?d)"), 0);
    ASSERT_TRUE(table.told(executor_, "now 7"));
    const int told = pizarra_tell_leased(&table.device, "(turned one 10) (turned two -20)");
    ASSERT_TRUE(table.told(executor_, "ok " + std::to_string(told)));
    ASSERT_TRUE(table.told(executor_, "came 7 (turned two -20)"));
    EXPECT_EQ(count("(turned ? ?)"), 2U);
    const int refused = pizarra_tell(&table.device, "(blocked one)");
    ASSERT_TRUE(table.told(executor_, "fail " + std::to_string(refused) + " not-permitted"));
    ASSERT_NE(pizarra_retract(&table.device, "(turned two ?)"), 0);
    ASSERT_TRUE(table.told(executor_, "went 7 (turned two -20)"));
    const int asked = pizarra_ask(&table.device, "(turned ?t ?d)");
    ASSERT_TRUE(table.told(executor_, "ok " + std::to_string(asked) + " (turned one 10)"));
    ASSERT_NE(pizarra_unwatch(&table.device, 7), 0);
    ASSERT_NE(pizarra_retract(&table.device, "(turned ? ?)"), 0);
    ASSERT_TRUE(table.told(executor_, "ok"));
    ASSERT_TRUE(table.told(executor_, "ok"));
  }
}

TEST_F(SmallDeviceTest, ComesAgainWhenItsLineBreaksAndItsFactsStandMeanwhile) {
  SmallDevice barrier(to_door(), "barrier", tokens_.at("barrier"));
  ASSERT_TRUE(barrier.told(executor_, "leased"));
  ASSERT_NE(pizarra_tell_leased(&barrier.device, "(blocked one)"), 0);
  ASSERT_TRUE(barrier.told(executor_, "ok"));
  barrier.cut();
  ASSERT_TRUE(barrier.told(executor_, "gone"));
  EXPECT_EQ(pizarra_joined(&barrier.device), 0);
  EXPECT_EQ(count("(blocked one)"), 1U);
  ASSERT_TRUE(barrier.told(executor_, "joined"));
  ASSERT_TRUE(barrier.told(executor_, "leased"));
  // The door dies, and another one comes.
  door_.reset();
  ASSERT_TRUE(barrier.told(executor_, "gone"));
  open_door({.tcp = TcpPlace{"127.0.0.1", 0}});
  ASSERT_TRUE(barrier.told(executor_, "leased"));
  EXPECT_EQ(count("(blocked one)"), 1U);
}

TEST_F(SmallDeviceTest, LearnsThatItsLeaseIsLost) {
  SmallDevice barrier(to_door(), "barrier", tokens_.at("barrier"));
  ASSERT_TRUE(barrier.told(executor_, "leased"));
  ASSERT_NE(pizarra_tell_leased(&barrier.device, "(blocked one)"), 0);
  ASSERT_TRUE(barrier.told(executor_, "ok"));
  const LeaseId lease =
      board_.store().lease_of(run(executor_, here_->facts(list("blocked"_sym, "one"_sym)))->front().id);
  ASSERT_TRUE(board_.release(lease));
  EXPECT_EQ(count("(blocked one)"), 0U);
  barrier.ahead += 30'000;  // it is time to renew it
  ASSERT_TRUE(barrier.told(executor_, "leased"));
}

TEST_F(SmallDeviceTest, GivesUpALineThatSaysNothingMore) {
  // Somebody else listens there, who welcomes it and never answers.
  const line::Listening deaf = line::listen_at("127.0.0.1", 0).value();
  bool at_door = false;
  SmallDevice barrier([&] { return connect_to(at_door ? door_->port() : deaf.port); }, "barrier",
                      tokens_.at("barrier"));
  int accepted = -1;
  EXPECT_FALSE(barrier.told(executor_, "joined", [&] {
    if (accepted < 0) accepted = ::accept(deaf.file, nullptr, nullptr);
    return accepted >= 0;
  }));
  barrier.ahead += 11'000;  // said hello, and is not answered
  accepted = -1;
  EXPECT_FALSE(barrier.told(executor_, "joined", [&] {
    if (accepted < 0) accepted = ::accept(deaf.file, nullptr, nullptr);
    return accepted >= 0;
  }));
  constexpr std::string_view welcome = "(welcome barrier)\n";
  ASSERT_EQ(::send(accepted, welcome.data(), welcome.size(), MSG_NOSIGNAL), static_cast<ssize_t>(welcome.size()));
  ASSERT_TRUE(barrier.told(executor_, "joined"));
  barrier.ahead += 11'000;  // has asked for a lease
  ASSERT_TRUE(barrier.told(executor_, "gone"));
  at_door = true;
  ASSERT_TRUE(barrier.told(executor_, "leased"));
  ::close(accepted);
  ::close(deaf.file);
}

TEST_F(SmallDeviceTest, IsToldWhyItIsNotLetIn) {
  SmallDevice barrier(to_door(), "barrier", tokens_.at("table"));
  ASSERT_TRUE(barrier.told(executor_, "gone 0 not-permitted"));
  EXPECT_EQ(pizarra_joined(&barrier.device), 0);
}

TEST_F(SmallDeviceTest, RefusesWhatHasNoRoomWholeAndHearsTheBeginningOfWhatIsTooLong) {
  SmallDevice table(to_door(), "table", tokens_.at("table"));
  ASSERT_TRUE(table.told(executor_, "leased"));
  EXPECT_EQ(pizarra_tell(&table.device, ("(turned " + std::string(PIZARRA_QUEUE, 'x') + " 1)").c_str()), 0);
  int room = 0;
  while (pizarra_ask(&table.device, "(turned ?t ?d)") != 0) ++room;
  EXPECT_EQ(room, PIZARRA_ASKED);
  for (int i = 0; i < room; ++i) ASSERT_TRUE(table.told(executor_, "ok"));
  for (int i = 0; i < 40; ++i) tell("(turned table-" + std::to_string(i) + " 10)");
  ASSERT_NE(pizarra_ask(&table.device, "(turned ?t ?d)"), 0);
  ASSERT_TRUE(table.told(executor_, "ok"));
  EXPECT_TRUE(table.last.ends_with("(turned table-0 10) cut")) << table.last;
  ASSERT_NE(pizarra_ask(&table.device, "(turned table-7 ?d)"), 0);
  ASSERT_TRUE(table.told(executor_, "ok"));
  EXPECT_TRUE(table.last.ends_with(" (turned table-7 10)")) << table.last;
}

// A line that says what a damaged door might, and what the client made of it.
struct Nonsense {
  std::string comes;
  std::size_t read = 0;
  int told = 0;
  const pizarra_device* device = nullptr;

  static int open(void*) { return 1; }
  static int send(void*, const char*, int count) { return count; }
  static int receive(void* user, char* into, int room) {
    auto& self = *static_cast<Nonsense*>(user);
    const std::size_t count = self.comes.copy(into, static_cast<std::size_t>(room), self.read);
    self.read += count;
    return static_cast<int>(count);
  }
  static void heard(void* user, const pizarra_news* news) {
    auto& self = *static_cast<Nonsense*>(user);
    ++self.told;
    const char* const line = self.device->line;
    if (news->text.size == 0) return;
    EXPECT_GE(news->text.at, line);
    EXPECT_LE(news->text.at + news->text.size, line + PIZARRA_LINE);
    for (int i = 0; i < 4; ++i) {
      const pizarra_text element = pizarra_nth(news->text, i);
      EXPECT_LE(element.size, news->text.size);
      EXPECT_LE(pizarra_inside(element).size, element.size);
    }
  }
};

TEST(SmallDeviceText, NoLineThatComesLeadsItOutOfItsMemory) {
  const std::string_view lines[] = {"(welcome barrier)\n", "(ok new)\n",           "(ok (a \"b)\") (c 1))\n",
                                    "(fail no \"why\")\n", "(came 1 (on a b))\n",  "(anew 1)\n",
                                    "(now 1 7)\n",         "(closed it \"why\")\n"};
  Random random(7);
  int told = 0;
  for (int run = 0; run < 3000; ++run) {
    Nonsense door{.comes = "(welcome barrier)\n"};
    for (int i = 0; i < 12; ++i) door.comes += lines[random.below(std::size(lines))];
    for (int i = 0; i < 3; ++i) door.comes[random.below(door.comes.size())] = static_cast<char>(random.below(256));
    if (run % 7 == 0) door.comes.insert(random.below(door.comes.size()), std::string(PIZARRA_LINE, '('));
    const pizarra_calls calls = {&door, &Nonsense::open, &Nonsense::send, &Nonsense::receive, &Nonsense::heard};
    pizarra_device device;
    pizarra_begin(&device, &calls, "barrier", "token", 2000);
    door.device = &device;
    for (std::uint32_t now = 0; now < 60'000 && door.read < door.comes.size(); now += 400) {
      pizarra_run(&device, now);
      pizarra_ask(&device, "(on ?x ?y)");
    }
    EXPECT_EQ(door.read, door.comes.size());
    told += door.told;
  }
  EXPECT_GT(told, 3000);
}

pizarra_text as_text(const char* text) { return {text, static_cast<int>(std::string_view(text).size())}; }

TEST(SmallDeviceText, ElementsAreTakenApartAsTheyStand) {
  const pizarra_text line = as_text("came  -3 (on \"a ) b\\\" (\" (c d)) x");
  EXPECT_EQ(text_of(pizarra_nth(line, 0)), "came");
  EXPECT_EQ(text_of(pizarra_nth(line, 1)), "-3");
  const pizarra_text fact = pizarra_nth(line, 2);
  EXPECT_EQ(text_of(fact), "(on \"a ) b\\\" (\" (c d))");
  EXPECT_EQ(text_of(pizarra_nth(line, 3)), "x");
  EXPECT_EQ(pizarra_nth(line, 4).size, 0);
  EXPECT_EQ(text_of(pizarra_nth(pizarra_inside(fact), 1)), "\"a ) b\\\" (\"");
  EXPECT_EQ(text_of(pizarra_nth(pizarra_inside(fact), 2)), "(c d)");
  EXPECT_EQ(pizarra_inside(as_text("x")).size, 0);
  for (const char* broken : {"", ")", "(", "((", "\"", "(\"", "\"\\", "a\"", ")(", "(a))"}) {
    for (int i = 0; i < 4; ++i) {
      const pizarra_text element = pizarra_nth(as_text(broken), i);
      EXPECT_LE(element.size, as_text(broken).size) << broken;
    }
  }
}

TEST(SmallDeviceText, NumbersAreReadAndWrittenExactly) {
  for (const std::int32_t value : {0, 1, -1, 90, INT32_MAX, INT32_MIN}) {
    char digits[12] = "";
    EXPECT_NE(pizarra_add_integer(digits, sizeof digits, value), 0);
    EXPECT_EQ(digits, std::to_string(value));
    std::int32_t read = 7;
    EXPECT_NE(pizarra_integer(as_text(digits), &read), 0);
    EXPECT_EQ(read, value);
  }
  std::int32_t kept = 7;
  for (const char* none : {"", "-", "+", "1.5", "2147483648", "-2147483649", "99999999999", "x", "1x", "--1"}) {
    EXPECT_EQ(pizarra_integer(as_text(none), &kept), 0) << none;
  }
  EXPECT_EQ(kept, 7);
  char small[4] = "ab";
  EXPECT_EQ(pizarra_add(small, sizeof small, "cd"), 0);
  EXPECT_STREQ(small, "ab");
}

}  // namespace
}  // namespace pizarra::door
