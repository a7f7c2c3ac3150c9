// A board that cannot know whether another one leads by now: it says so to who asks, tells how things stood, and does
// nothing else.

#include "blackboard/client/remote_board.hpp"
#include "blackboard/wire/gated_transport.hpp"
#include "tests/blackboard/server_fixture.hpp"
#include "tests/run_task.hpp"

namespace pizarra {
namespace {

using client::RemoteBoard;

class InDoubtTest : public ServerTest {
 protected:
  InDoubtTest() {
    server.reset();
    server::BoardServerOptions options;
    options.addresses = {"tcp://127.0.0.1:*"};
    options.transport = &gated;
    server = server::BoardServer::open(executor, board, options).value();
    EXPECT_TRUE(board.transact("test", Transaction().tell(read("(note 1 a)"))).has_value());
  }
  ~InDoubtTest() override { server.reset(); }
  std::unique_ptr<RemoteBoard> remote(Duration timeout) {
    return RemoteBoard::connect(executor, server->addresses().front(), "alice", timeout).value();
  }
  std::size_t notes() { return board.ask(query("(note ?n ?text)"))->answers.size(); }

  static constexpr Duration age = 700ms;
  bool leads = true;
  wire::GatedTransport gated{wire::zeromq(), [this] { return leads; },
                             [this](const std::string& sender_key, std::string_view frame) {
                               return server->answer_in_doubt(sender_key, frame, age);
                             }};
};

TEST_F(InDoubtTest, ItSaysNothingToThoseWhoDoNotDoubtAndChangesNothing) {
  Client client = this->client();
  const std::string session = client.join("alice");
  leads = false;
  for (const std::string& text :
       {"(ping " + session + ")", "(request " + session + " 1 (ask (note ?n ?text)))",
        "(request " + session + " 2 (transact () ((tell (note 2 b) 0))))", std::string("(hello \"alice\" 0 2)")}) {
    client.send(text);
    EXPECT_TRUE(client.receive(100ms).items().empty()) << text;
  }
  leads = true;
  EXPECT_TRUE(client.ask("(ping " + session + ")").is_form("pong")) << "nor later to what it did not hear";
  EXPECT_EQ(notes(), 1u);
}

TEST_F(InDoubtTest, ItSaysSoToWhoDoubtsAndForHowLong) {
  leads = false;
  EXPECT_EQ(client().ask("(hello \"alice\" 0 2 doubts)"), read("(unavailable 700000)"));
  leads = true;
  EXPECT_TRUE(client().ask("(hello \"alice\" 0 2 doubts)").is_form("welcome"));
}

TEST_F(InDoubtTest, ItTellsHowThingsStoodAndHowOldThatIsWhateverTheSession) {
  leads = false;
  Client client = this->client();
  client.send("(request 77 3 (recall (note ?n ?text)))(request 77 4 (recall (nothing ?n)))");
  const std::vector<Datum> said = client.receive_frame();
  ASSERT_EQ(said.size(), 3u);
  EXPECT_EQ(said[0], read("(unavailable 700000)"));
  ASSERT_TRUE(said[1][2].is_form("ok")) << write(said[1]);
  const Datum& value = said[1][2][1];
  EXPECT_EQ(value[0].integer(), 700000);
  EXPECT_TRUE(value[1].is_symbol("yes"));
  EXPECT_EQ(value[3][0][4], read("(note 1 a)"));
  EXPECT_EQ(said[2][2][1], "undeclared-relation"_sym);
}

TEST_F(InDoubtTest, AClientWaitsForAQuorumAndLearnsThatNothingWasDone) {
  const auto alice = remote(3s);
  ASSERT_TRUE(run(executor, alice->tell(read("(note 2 b)"))).has_value());
  EXPECT_EQ(run(executor, alice->recall(query("(note ?n ?text)")))->age, Duration::zero());
  leads = false;
  const Result<RemoteBoard::Recalled> recalled = run(executor, alice->recall(query("(note ?n ?text)")));
  ASSERT_TRUE(recalled.has_value()) << describe(recalled.error());
  EXPECT_EQ(recalled->age, age);
  EXPECT_EQ(recalled->answers.answers.size(), 2u);
  const Result<Revision> sent = run(executor, alice->tell(read("(note 3 c)")));
  ASSERT_FALSE(sent.has_value());
  EXPECT_EQ(sent.error().symbol, "unavailable");
  EXPECT_TRUE(sent.error().sentence.contains("not known")) << sent.error().sentence;
  EXPECT_FALSE(alice->connected());
  EXPECT_GT(alice->silence(), 2s) << "what is said in doubt is no sign of life";
  EXPECT_EQ(run(executor, alice->recall(query("(note ?n ?text)")))->age, age) << "without a session too";
  const Result<Revision> waited = run(executor, alice->tell(read("(note 3 c)")));
  ASSERT_FALSE(waited.has_value());
  EXPECT_TRUE(waited.error().sentence.contains("not done")) << waited.error().sentence;
  leads = true;
  EXPECT_TRUE(run(executor, alice->tell(read("(note 4 d)"))).has_value());
  EXPECT_FALSE(alice->in_doubt_since());
  EXPECT_EQ(notes(), 3u);
}

// Else a jog would be held again whose owner let go, or died, meanwhile.
TEST_F(InDoubtTest, LeasesLapseAtTheirTimeAndTheirOwnersLearnIt) {
  const auto alice = remote(10s);
  const LeaseId lease = run(executor, alice->lease(300ms)).value();
  ASSERT_TRUE(run(executor, alice->transact(Transaction().tell(read("(note 2 held)"), {}, lease))).has_value());
  const auto recalled = [&] { return run(executor, alice->recall(query("(note ?n ?text)")))->answers.answers.size(); };
  leads = false;
  EXPECT_EQ(recalled(), 2u);
  for (int looks = 0; looks < 200 && recalled() == 2; ++looks) pass(executor, 50ms);
  EXPECT_EQ(recalled(), 1u);
  leads = true;
  const Result<void> renewed = run(executor, alice->renew(lease));
  ASSERT_FALSE(renewed.has_value());
  EXPECT_EQ(renewed.error().symbol, "unknown-lease");
  EXPECT_EQ(notes(), 1u);
}

TEST_F(InDoubtTest, AClientThatDoesNotWaitIsRefusedAtOnce) {
  const auto alice = remote(10s);
  alice->refuse_without_quorum();
  leads = false;
  const Time begun = executor.now();
  const Result<Revision> told = run(executor, alice->tell(read("(note 2 b)")));
  ASSERT_FALSE(told.has_value());
  EXPECT_EQ(told.error().symbol, "unavailable");
  EXPECT_FALSE(run(executor, alice->ask(query("(note ?n ?text)"))).has_value());
  EXPECT_LT(executor.now() - begun, 5s);
  EXPECT_TRUE(run(executor, alice->recall(query("(note ?n ?text)"))).has_value());
  leads = true;
  while (!alice->connected()) pass(executor, 10ms);
  EXPECT_TRUE(run(executor, alice->tell(read("(note 2 b)"))).has_value());
  EXPECT_EQ(notes(), 2u);
}

}  // namespace
}  // namespace pizarra
