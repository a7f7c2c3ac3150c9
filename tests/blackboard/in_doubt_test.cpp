// A board that cannot know whether another one leads by now: it says so to who asks, tells how things stood, and does
// nothing else.

#include "blackboard/wire/gated_transport.hpp"
#include "tests/blackboard/server_fixture.hpp"

namespace pizarra {
namespace {

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

}  // namespace
}  // namespace pizarra
