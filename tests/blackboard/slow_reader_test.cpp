// What a client learns that reads slowly: less often, but in the end all that holds, and of no gap without a word.

#include <map>

#include "tests/blackboard/server_fixture.hpp"

namespace pizarra {
namespace {

class SlowReader : public ServerTest {
 protected:
  static constexpr std::int64_t watches = 3;
  static constexpr int questions = 3000;

  SlowReader() {
    Transaction transaction;
    transaction.tell(list("note"_sym, 0, std::string(3500, 'x')));
    EXPECT_TRUE(board.transact("fast", transaction).has_value());
    for (std::int64_t watch = 1; watch <= watches; ++watch) {
      ask("(watch " + std::to_string(watch) + " (note 1 ?text))");
      EXPECT_TRUE(slow.receive()[2].is_form("ok"));
      hear(slow.receive());
    }
  }
  void ask(const std::string& body) {
    slow.send("(request " + session + " " + std::to_string(++asked) + " " + body + ")");
  }
  // The changes that it does not read fill its connection, and the board's queue to it.
  void ask_and_read_nothing() {
    for (int i = 1; i <= questions; ++i) {
      ask("(ask (note 0 ?text))");
      if (i % 50 == 0) pass(executor, 1ms);
    }
  }
  void tell(int text) {
    Transaction transaction;
    transaction.tell(list("note"_sym, 1, text));
    ASSERT_TRUE(board.transact("fast", transaction).has_value());
  }
  void hear(const Datum& message) {
    if (message.is_form("reply")) ++replies;
    if (!message.is_form("change")) return;
    const std::int64_t watch = message[1].integer();
    EXPECT_EQ(message[2].integer(), ++sequences[watch]) << "nothing is lost without a word";
    if (!message[5].items().empty()) known[watch] = message[5][0][0][4];
    slow.send("(ack " + session + " " + std::to_string(watch) + " " + write(message[2]) + ")");
  }
  // And says that it lives.
  void hear_all() {
    slow.send("(ping " + session + ")");
    for (Datum message = slow.receive(200ms); message != Datum(); message = slow.receive(200ms)) hear(message);
  }

  Client slow{executor, server->addresses().front(), 1, 4096};
  const std::string session = slow.join("slow");
  int asked = 0;
  int replies = 0;
  std::map<std::int64_t, std::int64_t> sequences;
  std::map<std::int64_t, Datum> known;
};

TEST_F(SlowReader, LearnsAllThatHoldsWhereChangesFoundNoRoom) {
  ask_and_read_nothing();
  constexpr int many = 100;
  for (int i = 1; i <= many; ++i) {
    tell(i);
    slow.send("(ping " + session + ")");
    pass(executor, 1ms);
  }
  hear_all();
  ASSERT_LT(replies, questions) << "its queue was full";
  hear_all();
  for (std::int64_t watch = 1; watch <= watches; ++watch) EXPECT_EQ(known[watch], list("note"_sym, 1, many)) << watch;
  tell(many + 1);
  hear_all();
  for (std::int64_t watch = 1; watch <= watches; ++watch) EXPECT_EQ(known[watch], list("note"_sym, 1, many + 1));
}

}  // namespace
}  // namespace pizarra
