// A served board answers with a durable fact only when its disk has that fact.

#include <condition_variable>
#include <gtest/gtest.h>
#include <mutex>

#include "blackboard/journal/journal_writer.hpp"
#include "tests/blackboard/server_fixture.hpp"

namespace pizarra {
namespace {

// A disk that writes nothing until it is let go on.
class HeldLog : public journal::Log {
 public:
  const std::string& path() const override { return path_; }
  Result<std::vector<journal::RememberedReply>> recover(store::Store&) override { return {}; }
  Result<void> append(const journal::JournalGroup&, bool) override {
    std::unique_lock lock(mutex_);
    goes_on_.wait(lock, [this] { return !is_held_; });
    return {};
  }
  journal::JournalRoom room() override { return {.for_all = 1 << 20, .for_removals = 1 << 20}; }
  Result<std::size_t> compact(Time) override { return 0; }
  Result<journal::PlayedBack> read(store::Store&, const Moment&) const override { return journal::PlayedBack{}; }

  void hold() { set(true); }
  void go_on() { set(false); }

 private:
  void set(bool held) {
    const std::lock_guard lock(mutex_);
    is_held_ = held;
    goes_on_.notify_all();
  }

  const std::string path_ = "held";
  std::mutex mutex_;
  std::condition_variable goes_on_;
  bool is_held_ = false;
};

class UnwrittenFacts : public ServerTest {
 protected:
  UnwrittenFacts() {
    server.reset();
    board.set_journal([this](std::string_view line) { writer_.append(line); });
    const Relation goal = relation("(relation goal ((n integer)) (durable))");
    EXPECT_TRUE(board.declare("test", {goal}).has_value());
    server::BoardServerOptions options;
    options.addresses = {"tcp://127.0.0.1:*"};
    options.journal = &writer_;
    server = server::BoardServer::open(executor, board, options).value();
  }
  ~UnwrittenFacts() override {
    log_->go_on();
    server.reset();
  }

  std::shared_ptr<HeldLog> log_ = std::make_shared<HeldLog>();
  journal::JournalWriter writer_{executor, log_};
};

TEST_F(UnwrittenFacts, AreInNoAnswerBeforeTheDiskHasThem) {
  Client alice = client();
  Client bob = client();
  const std::string of_alice = alice.join("alice");
  const std::string of_bob = bob.join("bob");
  log_->hold();
  alice.send("(request " + of_alice + " 1 (transact () ((tell (goal 1) 0))))");
  alice.send("(request " + of_alice + " 2 (ask (note ?n ?text)))");
  EXPECT_EQ(alice.receive()[1], to_datum(2)) << "what concerns no durable fact is answered";
  bob.send("(request " + of_bob + " 1 (ask (goal ?n)))");
  bob.send("(request " + of_bob + " 2 (ask (query (and (note ?n ?text) (not (goal ?n))) (limit 1))))");
  bob.send("(request " + of_bob + " 3 (ask (note ?n ?text)))");
  EXPECT_EQ(bob.receive()[1], to_datum(3));
  log_->go_on();
  EXPECT_EQ(alice.receive()[1], to_datum(1));
  const Datum goals = bob.receive();
  EXPECT_EQ(goals[1], to_datum(1));
  EXPECT_NE(write(goals).find("(goal 1)"), std::string::npos) << write(goals);
  EXPECT_EQ(bob.receive()[1], to_datum(2));
}

TEST_F(UnwrittenFacts, DoNotKeepAQuestionWaitingOnceTheDiskHasThem) {
  Client alice = client();
  const std::string session = alice.join("alice");
  EXPECT_TRUE(alice.ask("(request " + session + " 1 (transact () ((tell (goal 1) 0))))")[2].is_form("ok"));
  log_->hold();
  EXPECT_TRUE(alice.ask("(request " + session + " 2 (transact () ((tell (note 1 x) 0))))")[2].is_form("ok"));
  EXPECT_TRUE(alice.ask("(request " + session + " 3 (ask (goal ?n)))")[2].is_form("ok"));
}

}  // namespace
}  // namespace pizarra
