// A client that does not run for longer than it waits for an answer.

#include "blackboard/client/remote_board.hpp"
#include "tests/blackboard/simulated/simulated_server.hpp"
#include "tests/run_task.hpp"

namespace pizarra::simulated {
namespace {

class HeldUpClient : public SimulatedServer {
 protected:
  // The client asks, and then does not run for 10 s: how its question ends.
  std::string outcome() {
    std::optional<Result<Answers>> answers;
    const auto ask = [](client::RemoteBoard& board, std::optional<Result<Answers>>& result) -> Task<void> {
      Result<Answers> heard = co_await board.ask(query("(note ?n ?text)"));
      result.emplace(std::move(heard));
    };
    const Job job = alice_.spawn(ask(*board_, answers));
    pass(frame_delay / 2);
    alice_.pause();
    pass(10s);
    EXPECT_FALSE(answers.has_value());
    alice_.resume();
    pass(1s);
    if (!answers) return "none";
    return answers->has_value() ? "ok" : answers->error().symbol;
  }

  Process alice_{time_, {}};
  const std::unique_ptr<wire::Transport> wires_of_alice_ = network_.plug("alice", alice_);
  const std::unique_ptr<client::RemoteBoard> board_ =
      client::RemoteBoard::connect(alice_, address, "alice", 3s, {}, *wires_of_alice_).value();
};

TEST_F(HeldUpClient, HearsTheAnswerThatCameMeanwhile) {
  pass(1s);
  EXPECT_EQ(outcome(), "ok");
}

TEST_F(HeldUpClient, IsAnsweredWhereItHadNotJoinedYet) { EXPECT_EQ(outcome(), "ok"); }

TEST_F(HeldUpClient, LearnsThatTheBoardIsGone) {
  pass(1s);
  server.reset();
  EXPECT_EQ(outcome(), "unreachable");
}

}  // namespace
}  // namespace pizarra::simulated
