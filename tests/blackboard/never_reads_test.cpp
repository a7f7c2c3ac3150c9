// The cost of a client that never reads to the board's program, and its effect on the others.

#include <gtest/gtest.h>
#include <zmq.hpp>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/blackboard/board_fixture.hpp"
#include "tests/blackboard/child_program.hpp"

namespace pizarra {
namespace {

constexpr int notes = 4;
constexpr int tells = 120;
constexpr std::size_t note_bytes = 100'000;

class NeverReads : public testing::Test, public Wall {
 protected:
  // Its network takes little, and hands on nothing.
  class Mute {
   public:
    explicit Mute(const std::string& address) : socket_(context_, zmq::socket_type::dealer) {
      socket_.set(zmq::sockopt::linger, 0);
      socket_.set(zmq::sockopt::rcvhwm, 1);
      socket_.set(zmq::sockopt::rcvbuf, 4096);
      socket_.connect(address);
      socket_.send(zmq::str_buffer("(hello \"mute\" 0)"));
      zmq::message_t welcome;
      EXPECT_TRUE(socket_.recv(welcome).has_value());
      session_ = std::to_string(read(welcome.to_string())[1].integer());
    }
    void request(const std::string& body) {
      const std::string frame = "(request " + session_ + " " + std::to_string(++requests_) + " " + body + ")";
      EXPECT_TRUE(socket_.send(zmq::buffer(frame)).has_value());
    }

   private:
    zmq::context_t context_{1};
    zmq::socket_t socket_;
    std::string session_;
    int requests_ = 0;
  };

  NeverReads() {
    EXPECT_EQ(symbol_of(run(alice_->declare({relation("(relation note ((n integer) (text string)) (key n))")}))), "ok");
    watch_ = std::move(run(bob_->watch(query("(note ?n ?text)"))).value());
    run(watch_->next());
  }

  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    return client::RemoteBoard::connect(executor_, address_, teller).value();
  }
  // The most memory that the program had meanwhile.
  double tell_and_see_all() {
    double most_mb = 0;
    for (int i = 0; i < tells; ++i) {
      const std::string text(note_bytes + static_cast<std::size_t>(++told_), 'x');
      EXPECT_EQ(symbol_of(run(alice_->tell(list("note"_sym, i % notes, text)))), "ok");
      const Result<Change> change = run(watch_->next());
      if (!change || change->resynchronised || change->added.size() != 1) ADD_FAILURE() << "bob misses tell " << i;
      most_mb = std::max(most_mb, program_.resident_mb());
    }
    return most_mb;
  }

  RealExecutor executor_;
  const std::string address_ = ipc_address();
  ChildProgram program_{{PIZARRA_BOARD_PROGRAM, "--listen", address_}};
  const std::string ready_ = program_.line();
  std::unique_ptr<Board> alice_ = view("alice");
  std::unique_ptr<Board> bob_ = view("bob");
  std::unique_ptr<Watch> watch_;
  int told_ = 0;
};

TEST_F(NeverReads, ItsWatchesAndQuestionsCostTheBoardLessThanTwentyMegabytes) {
  const double usual_mb = tell_and_see_all();
  Mute mute(address_);
  for (int i = 1; i <= 60; ++i) mute.request("(watch " + std::to_string(i) + " (note ?n ?text) kept)");
  for (int i = 1; i <= 200; ++i) mute.request("(ask (note ?n ?text))");
  EXPECT_LT(tell_and_see_all() - usual_mb, 20);
  const std::vector<Answer> waiting =
      run(alice_->ask(query("(watcher-stats \"mute\" ?watches ?queued ?bytes)")))->answers;
  ASSERT_EQ(waiting.size(), 1U);
  EXPECT_EQ(waiting[0].bindings.find("?watches"_sym)->integer(), 60);
  EXPECT_LE(waiting[0].bindings.find("?bytes"_sym)->integer(), std::int64_t{limits::pending_bytes});
}

}  // namespace
}  // namespace pizarra
