// The clients of a board that cannot know whether another one leads by now: what waits for it, what is refused, and
// what they still learn.

#include "blackboard/client/remote_board.hpp"
#include "blackboard/wire/gated_transport.hpp"
#include "tests/blackboard/simulated/simulated_server.hpp"
#include "tests/run_task.hpp"

namespace pizarra::simulated {
namespace {

using client::RemoteBoard;

class InDoubtClientTest : public SimulatedServer {
 protected:
  InDoubtClientTest() {
    server.reset();
    server::BoardServerOptions options;
    options.addresses = {address};
    options.transport = &gated;
    server = server::BoardServer::open(process_, board, options).value();
    EXPECT_TRUE(board.transact("test", Transaction().tell(read("(note 1 a)"))).has_value());
  }
  ~InDoubtClientTest() override { server.reset(); }
  std::unique_ptr<RemoteBoard> remote(Duration timeout) {
    return RemoteBoard::connect(process_, address, "alice", timeout, {}, *alices_wires).value();
  }
  std::size_t notes() { return board.ask(query("(note ?n ?text)"))->answers.size(); }

  static constexpr Duration age = 700ms;
  bool leads = true;
  const std::unique_ptr<wire::Transport> alices_wires = network_.plug("alice", process_);
  wire::GatedTransport gated{*wires_, [this] { return leads; },
                             [this](const std::string& sender_key, std::string_view frame) {
                               return server->answer_in_doubt(sender_key, frame, age);
                             }};
};

TEST_F(InDoubtClientTest, AClientWaitsForAQuorumAndLearnsThatNothingWasDone) {
  const auto alice = remote(3s);
  ASSERT_TRUE(run(time_, alice->tell(read("(note 2 b)"))).has_value());
  EXPECT_EQ(run(time_, alice->recall(query("(note ?n ?text)")))->age, Duration::zero());
  leads = false;
  const Result<RemoteBoard::Recalled> recalled = run(time_, alice->recall(query("(note ?n ?text)")));
  ASSERT_TRUE(recalled.has_value()) << describe(recalled.error());
  EXPECT_EQ(recalled->age, age);
  EXPECT_EQ(recalled->answers.answers.size(), 2u);
  const Result<Revision> sent = run(time_, alice->tell(read("(note 3 c)")));
  ASSERT_FALSE(sent.has_value());
  EXPECT_EQ(sent.error().symbol, "unavailable");
  EXPECT_TRUE(sent.error().sentence.contains("not known")) << sent.error().sentence;
  EXPECT_FALSE(alice->connected());
  EXPECT_GT(alice->silence(), 2s) << "what is said in doubt is no sign of life";
  EXPECT_EQ(run(time_, alice->recall(query("(note ?n ?text)")))->age, age) << "without a session too";
  const Result<Revision> waited = run(time_, alice->tell(read("(note 3 c)")));
  ASSERT_FALSE(waited.has_value());
  EXPECT_TRUE(waited.error().sentence.contains("not done")) << waited.error().sentence;
  leads = true;
  EXPECT_TRUE(run(time_, alice->tell(read("(note 4 d)"))).has_value());
  EXPECT_FALSE(alice->in_doubt_since());
  EXPECT_EQ(notes(), 3u);
}

// Else a jog would be held again whose owner let go, or died, meanwhile.
TEST_F(InDoubtClientTest, LeasesLapseAtTheirTimeAndTheirOwnersLearnIt) {
  const auto alice = remote(10s);
  const LeaseId lease = run(time_, alice->lease(300ms)).value();
  ASSERT_TRUE(run(time_, alice->transact(Transaction().tell(read("(note 2 held)"), {}, lease))).has_value());
  const auto recalled = [&] { return run(time_, alice->recall(query("(note ?n ?text)")))->answers.answers.size(); };
  leads = false;
  EXPECT_EQ(recalled(), 2u);
  for (int looks = 0; looks < 200 && recalled() == 2; ++looks) pass(50ms);
  EXPECT_EQ(recalled(), 1u);
  leads = true;
  const Result<void> renewed = run(time_, alice->renew(lease));
  ASSERT_FALSE(renewed.has_value());
  EXPECT_EQ(renewed.error().symbol, "unknown-lease");
  EXPECT_EQ(notes(), 1u);
}

TEST_F(InDoubtClientTest, AClientThatDoesNotWaitIsRefusedAtOnce) {
  const auto alice = remote(10s);
  alice->refuse_without_quorum();
  leads = false;
  const Time begun = time_.now();
  const Result<Revision> told = run(time_, alice->tell(read("(note 2 b)")));
  ASSERT_FALSE(told.has_value());
  EXPECT_EQ(told.error().symbol, "unavailable");
  EXPECT_FALSE(run(time_, alice->ask(query("(note ?n ?text)"))).has_value());
  EXPECT_LT(time_.now() - begun, 5s);
  EXPECT_TRUE(run(time_, alice->recall(query("(note ?n ?text)"))).has_value());
  leads = true;
  for (int waits = 0; waits < 1000 && !alice->connected(); ++waits) pass(10ms);
  EXPECT_TRUE(run(time_, alice->tell(read("(note 2 b)"))).has_value());
  EXPECT_EQ(notes(), 2u);
}

}  // namespace
}  // namespace pizarra::simulated
