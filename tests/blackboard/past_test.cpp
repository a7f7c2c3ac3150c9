// The order in which questions about the past are answered when many ask.

#include "blackboard/journal/past.hpp"

#include "tests/blackboard/journal_fixture.hpp"

namespace pizarra {
namespace {

class PastTest : public JournalFileTest {
 protected:
  PastTest() {
    EXPECT_TRUE(life_.board->declare("alice", relations_).has_value());
    life_.tell("(goal 1 (on a b))");
  }
  void ask(const std::string& client) {
    past_.ask(client, query("(query (goal ?n ?) (at 1))"), [this, client](const Result<Answers>& answers) {
      answered_.push_back(client + (answers ? " ok" : " " + answers.error().symbol));
    });
  }

  Life life_{path_};
  journal::Past past_{life_.executor, *life_.writer, [this] { return life_.board->store().revision(); }};
  std::vector<std::string> answered_;
};

TEST_F(PastTest, AClientThatAsksMuchKeepsNobodyElseFromAsking) {
  for (std::size_t i = 0; i <= journal::Past::max_waiting; ++i) ask("flood");
  EXPECT_EQ(answered_, std::vector<std::string>(1 + journal::Past::max_waiting - journal::Past::max_waiting_of_a_client,
                                                "flood too-many"));
  answered_.clear();
  ask("alice");
  ask("alice");
  EXPECT_TRUE(answered_.empty()) << "hers wait";
  life_.executor.run_for(10s);
  ASSERT_EQ(answered_.size(), 2 + journal::Past::max_waiting_of_a_client);
  answered_.resize(5);
  EXPECT_EQ(answered_, (std::vector<std::string>{"flood ok", "alice ok", "flood ok", "alice ok", "flood ok"}));
  answered_.clear();
  ask("flood");
  life_.executor.run_for(10s);
  EXPECT_EQ(answered_, std::vector<std::string>{"flood ok"}) << "there is room again";
}

TEST_F(PastTest, ARelationThatWasYetToBeDeclaredIsSaidNotToHaveBeenThereThen) {
  life_.tell("(goal 2 (on b c))");
  EXPECT_TRUE(life_.board->declare("alice", {relation("(relation later ((n integer)) (key n))")}).has_value());
  life_.tell("(later 1)");
  std::vector<std::string> said;
  for (const char* typed : {"(query (later ?n) (at 0))", "(query (later ?n) (at 1))", "(query (later ?n) (at 2))"}) {
    past_.ask("alice", query(typed),
              [&](const Result<Answers>& answers) { said.push_back(answers ? "ok" : answers.error().sentence); });
    life_.executor.run_for(1s);
  }
  ASSERT_EQ(said.size(), 3U);
  EXPECT_TRUE(said[0].starts_with("at revision 0, before the first change of all, no relation is called later"))
      << said[0];
  EXPECT_TRUE(said[1].starts_with("at revision 1, no relation is called later")) << said[1];
  EXPECT_EQ(said[2], "ok");
}

TEST_F(PastTest, AReasonThatHasGoneSinceStoodThen) {
  Transaction because;
  because.tell(read("(goal 2 (on b c))"), {1});
  ASSERT_TRUE(life_.board->transact("alice", because).has_value());
  ASSERT_TRUE(life_.board->transact("alice", Transaction().retract(read("(goal 1 ?)"))).has_value());
  std::vector<Datum> reasons;
  for (const char* typed :
       {"(query (provenance 2 ?id ?fact ? ? ?) (at 2))", "(query (provenance 2 ?id ?fact ? ? ?) (at 3))"}) {
    past_.ask("alice", query(typed), [&](const Result<Answers>& answers) {
      ASSERT_TRUE(answers.has_value()) << answers.error().sentence;
      for (const Answer& answer : answers->answers) reasons.push_back(*answer.bindings.find("?fact"));
    });
    life_.executor.run_for(1s);
  }
  EXPECT_EQ(reasons,
            (std::vector<Datum>{read("(goal 2 (on b c))"), read("(goal 1 (on a b))"), read("(goal 2 (on b c))")}));
}

TEST_F(PastTest, AllClientsTogetherHaveABound) {
  for (std::size_t i = 0; i < journal::Past::max_waiting; ++i) ask("client-" + std::to_string(i));
  EXPECT_TRUE(answered_.empty());
  ask("one-more");
  EXPECT_EQ(answered_, std::vector<std::string>{"one-more too-many"});
}

}  // namespace
}  // namespace pizarra
