// What a client learns that reads slowly: less often, but in the end all that holds, and of no gap without a word.

#include <algorithm>
#include <map>

#include "tests/blackboard/server_fixture.hpp"

namespace pizarra {
namespace {

class SlowReader : public ServerTest {
 protected:
  using Known = std::map<std::int64_t, Datum>;  // the fact, by the watch
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
  // Whether each watch learns this text, while the client says that it lives.
  bool learns(int text) {
    const auto learned = [&] {
      return std::ranges::count(known, list("note"_sym, 1, text), &Known::value_type::second) == watches;
    };
    for (int silences = 0; silences < 25 && !learned();) {
      const Datum message = slow.receive(200ms);
      hear(message);
      if (message != Datum()) continue;
      ++silences;
      slow.send("(ping " + session + ")");
    }
    return learned();
  }

  Client slow{executor, server->addresses().front(), 1, 4096};
  const std::string session = slow.join("slow");
  int asked = 0;
  int replies = 0;
  std::map<std::int64_t, std::int64_t> sequences;
  Known known;
};

TEST_F(SlowReader, LearnsAllThatHoldsWhereChangesFoundNoRoom) {
  ask_and_read_nothing();
  constexpr int many = 100;
  for (int i = 1; i <= many; ++i) {
    tell(i);
    slow.send("(ping " + session + ")");
    pass(executor, 1ms);
  }
  EXPECT_TRUE(learns(many));
  ASSERT_LT(replies, questions) << "its queue was full";
  tell(many + 1);
  EXPECT_TRUE(learns(many + 1));
}

}  // namespace
}  // namespace pizarra
