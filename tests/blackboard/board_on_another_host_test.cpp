// A board on another host, as far as the network can tell: in a network namespace of its own, at the far end of a link
// that is cut, silent or slow.

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/blackboard/board_fixture.hpp"
#include "tests/blackboard/child_program.hpp"
#include "tests/scratch.hpp"

namespace pizarra {
namespace {

bool does(const std::string& command) { return std::system((command + " >/dev/null 2>&1").c_str()) == 0; }

// The link, and the namespace at its far end. Both go with it.
class Link {
 public:
  Link() : number_(std::to_string(getpid() % 250 + 1)), host_("pizarra-" + number_), near_("piz-near-" + number_) {
    made_ = does("ip netns add " + host_) && does("ip link add " + near_ + " type veth peer name far netns " + host_) &&
            does("ip address add 10.231." + number_ + ".1/24 dev " + near_) && does("ip link set " + near_ + " up") &&
            does(there() + "ip address add " + far_address() + "/24 dev far") && does(there() + "ip link set far up");
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  ~Link() {
    does("ip link del " + near_);
    does("ip netns del " + host_);
  }

  bool made() const { return made_; }
  std::string far_address() const { return "10.231." + number_ + ".2"; }
  std::vector<std::string> command_there(std::vector<std::string> words) const {
    words.insert(words.begin(), {"ip", "netns", "exec", host_});
    return words;
  }
  // Whatever is sent is gone, and nobody is told.
  void silence() { ASSERT_TRUE(does(there() + "ip link set far down")); }
  void restore() { ASSERT_TRUE(does(there() + "ip link set far up")); }
  // This host's own end goes: the system says so to who sends.
  void unplug() { ASSERT_TRUE(does("ip link set " + near_ + " down")); }
  void plug_in() { ASSERT_TRUE(does("ip link set " + near_ + " up")); }
  bool slow_down() {
    const std::string slow = " root tbf rate 200kbit burst 4kb latency 2s";
    return does("tc qdisc add dev " + near_ + slow) && does(there() + "tc qdisc add dev far" + slow);
  }

 private:
  std::string there() const { return "ip netns exec " + host_ + " "; }
  const std::string number_;
  const std::string host_;
  const std::string near_;
  bool made_ = false;
};

class NetworkTest : public testing::Test, public Wall {
 protected:
  void SetUp() override {
    if (!link_.made()) GTEST_SKIP() << "network namespaces and links are root's to make, and the kernel's to allow";
    board_.emplace(link_.command_there({PIZARRA_BOARD_PROGRAM, "--insecure", "--listen", address()}));
    ASSERT_TRUE(board_->line().starts_with("pizarra-board: ready")) << board_->rest();
    writer_ = connect("writer");
    watcher_ = connect("watcher");
    ASSERT_EQ(symbol_of(run(writer_->declare({relation("(relation count ((n integer) (padding string)) (key))")}))),
              "ok");
  }
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override { return connect(teller); }
  std::string address() const { return "tcp://" + link_.far_address() + ":7800"; }
  std::unique_ptr<client::RemoteBoard> connect(const std::string& teller) {
    return client::RemoteBoard::connect(executor_, address(), teller).value();
  }
  bool wait_until(const std::function<bool()>& holds, Duration patience = 15s) {
    const Time end = executor_.now() + patience;
    executor_.run_until([&] { return holds() || executor_.now() > end; });
    return holds();
  }

  // Each number once: it is told where its predecessor stands.
  Transaction counting(std::int64_t n) const {
    Transaction transaction;
    const Transaction::Precondition after_the_last = Transaction::Present{list("count"_sym, n - 1, "?"_sym)};
    if (n > 1) transaction.require(after_the_last);
    transaction.tell(list("count"_sym, n, padding_));
    return transaction;
  }
  Task<void> count() {
    for (std::int64_t n = 1;; ++n) {
      Transaction transaction = counting(n);
      const Result<Revision> told = co_await writer_->transact(std::move(transaction));
      if (told) counted_ = n;
      const bool given_up = !told && told.error().symbol == "unreachable";
      if (!told && !given_up) twice_ = n;
      // What was given up may have been done: it goes on from what stands.
      if (given_up) n = co_await standing();
    }
  }
  Task<std::int64_t> standing() {
    const Datum any = list("count"_sym, "?"_sym, "?"_sym);
    while (true) {
      const Result<std::vector<Fact>> facts = co_await writer_->facts(any);
      if (facts && facts->empty()) co_return 0;
      if (facts) co_return facts->front().datum[1].integer();
    }
  }
  // Follows the count: every number comes, or it is said that some may not have.
  Task<void> follow() {
    Query counts = query("(count ?n ?)");
    const Result<std::unique_ptr<Watch>> watch = co_await watcher_->watch(counts);
    while (watch) {
      const Result<Change> change = co_await (*watch)->next();
      if (!change) co_return;
      resynchronised_ += change->resynchronised ? 1 : 0;
      if (change->added.empty()) continue;
      const std::int64_t n = change->added.front().facts.front().datum[1].integer();
      if (!change->resynchronised && n != followed_ + 1) missed_ = n;
      if (n < followed_) missed_ = n;
      followed_ = n;
    }
  }

  Link link_;
  RealExecutor executor_;
  std::optional<ChildProgram> board_;
  std::unique_ptr<client::RemoteBoard> writer_;
  std::unique_ptr<client::RemoteBoard> watcher_;
  std::string padding_;
  std::int64_t counted_ = 0;  // acknowledged
  std::int64_t twice_ = 0;    // refused, because it had happened already
  std::int64_t followed_ = 0;
  std::int64_t missed_ = 0;  // came after another than its predecessor, and nothing was said
  int resynchronised_ = 0;
};

// A host with a file of names: a board listens at a name of that file, and what it says is read there.
class NamedHostTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!link_.made()) GTEST_SKIP() << "network namespaces and links are root's to make, and the kernel's to allow";
  }
  std::string said_where(const std::string& names, const std::string& host) {
    const std::string file = scratch_folder() + "names";
    std::ofstream(file) << names;
    ChildProgram board(
        link_.command_there({"unshare", "--mount", "sh", "-c", "mount --bind \"$1\" /etc/hosts && shift && exec \"$@\"",
                             "sh", file, PIZARRA_BOARD_PROGRAM, "--insecure", "--listen", "tcp://" + host + ":7800"}));
    return board.line();
  }
  Link link_;
};

TEST_F(NamedHostTest, ListensAtTheAddressThatItsMachinesNameStandsFor) {
  const std::string names = "127.0.0.1 localhost\n" + link_.far_address() + " bench\n";
  EXPECT_EQ(said_where(names, "bench"), "pizarra-board: ready on tcp://" + link_.far_address() + ":7800");
  EXPECT_EQ(said_where(names, "far"), "pizarra-board: ready on tcp://" + link_.far_address() + ":7800")
      << "a network interface";
}

TEST_F(NamedHostTest, IsToldThatNobodyElseReachesANameOfLoopbackOrThatNobodyKnowsIt) {
  const std::string loopback = said_where("127.0.0.1 localhost\n127.0.1.1 bench\n", "bench");
  EXPECT_TRUE(loopback.contains("the name bench stands for 127.0.1.1, where no other machine reaches it")) << loopback;
  const std::string unknown = said_where("127.0.0.1 localhost\n", "bench.invalid");
  EXPECT_TRUE(unknown.contains("the name bench.invalid is not known here: ")) << unknown;
}

TEST_F(NetworkTest, AfterACutAndASilenceEveryNumberWasCountedOnceAndFollowed) {
  const Job counting = executor_.spawn(count());
  const Job following = executor_.spawn(follow());
  ASSERT_TRUE(wait_until([&] { return followed_ > 100; }));
  link_.unplug();
  pass(600ms);
  link_.plug_in();
  std::int64_t before = counted_;
  ASSERT_TRUE(wait_until([&] { return followed_ > before + 100; })) << "after it was unplugged";
  link_.silence();
  EXPECT_TRUE(wait_until([&] { return !watcher_->connected(); }, 4s)) << "a silent board is as good as none";
  link_.restore();
  before = counted_;
  ASSERT_TRUE(wait_until([&] { return followed_ > before + 100; })) << "after it was silent";
  EXPECT_EQ(twice_, 0);
  EXPECT_EQ(missed_, 0);
}

// Longer than ZeroMQ keeps the connection: neither end is told, and each finds out by itself.
TEST_F(NetworkTest, AHalfOpenConnectionIsNoticedAndReplaced) {
  const Job following = executor_.spawn(follow());
  ASSERT_EQ(symbol_of(run(writer_->tell(read("(count 1 \"\")")))), "ok");
  ASSERT_TRUE(wait_until([&] { return followed_ == 1; }));
  link_.silence();
  const Time silenced = executor_.now();
  EXPECT_EQ(symbol_of(run(writer_->tell(read("(count 2 \"\")")))), "unreachable");
  EXPECT_LT(executor_.now() - silenced, 6s);
  EXPECT_FALSE(writer_->connected());
  pass(silenced + 7s - executor_.now());
  link_.restore();
  const Time restored = executor_.now();
  ASSERT_TRUE(wait_until([&] { return writer_->connected() && watcher_->connected(); }));
  EXPECT_LT(executor_.now() - restored, 5s);
  ASSERT_EQ(symbol_of(run(writer_->tell(read("(count 3 \"\")")))), "ok");
  EXPECT_TRUE(wait_until([&] { return followed_ == 3; }));
}

TEST_F(NetworkTest, OnASlowLinkNothingIsLostOrDoneTwice) {
  if (!link_.slow_down()) GTEST_SKIP() << "the kernel has no token buckets";
  padding_ = std::string(2000, 'x');
  const Job counting = executor_.spawn(count());
  const Job following = executor_.spawn(follow());
  ASSERT_TRUE(wait_until([&] { return followed_ >= 10; }));
  EXPECT_EQ(twice_ + missed_, 0);
  EXPECT_EQ(resynchronised_, 1) << "once, to begin with";
}

}  // namespace
}  // namespace pizarra
