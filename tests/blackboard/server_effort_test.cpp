// A client that makes the board work hard gets its share, and nobody else waits for it.

#include <algorithm>

#include "blackboard/limits.hpp"
#include "blackboard/server/workload.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "tests/blackboard/server_fixture.hpp"

namespace pizarra {
namespace {

class ServerEffort : public ServerTest {
 protected:
  static constexpr int facts = 120'000;

  ServerEffort() {
    constexpr int a_transaction = 5000;
    for (int n = 0; n < facts; n += a_transaction) {
      Transaction some;
      for (int i = n; i < n + a_transaction; ++i) some.tell(list("note"_sym, i, i % 7));
      EXPECT_TRUE(board.transact("test", some).has_value());
    }
  }
  static std::string request(const std::string& session, int number, const std::string& body) {
    return "(request " + session + " " + std::to_string(number) + " " + body + ")";
  }
  // Every fact is looked at, and none fits.
  static constexpr const char* costly = "(ask (and (note ?n ?what) (/= ?what ?what)))";
  static std::string symbol_of(const Datum& reply) {
    if (!reply.is_form("reply")) return write(reply);
    return reply[2].is_form("ok") ? "ok" : std::string(reply[2][1].text());
  }
  // Somebody else asks, now and again and again.
  class Company {
   public:
    Company(Executor& executor, const std::string& address)
        : executor_(executor), client_(executor, address), session_(client_.join("company")) {
      go_on();
    }
    Company(const Company&) = delete;
    Company& operator=(const Company&) = delete;
    ~Company() { executor_.cancel(timer_); }

   private:
    void go_on() {
      client_.send(request(session_, ++asked_, "(ask (note 17 ?))"));
      timer_ = executor_.call_at(executor_.now() + 20ms, [this] { go_on(); });
    }

    Executor& executor_;
    Client client_;
    std::string session_;
    int asked_ = 0;
    Executor::TimerId timer_ = 0;
  };
  void keep_company() { company.emplace(executor, server->addresses().front()); }

  std::optional<Company> company;
};

// Of all that wait each client has its turn; what is not costly waits for none.
TEST_F(ServerEffort, ManyConnectionsOfOneClientThatAskCostlyQuestionsDelayNobody) {
  constexpr int connections = 24;
  constexpr int requests = 2;  // of each
  std::vector<std::unique_ptr<Client>> greedy;
  std::vector<std::string> sessions;
  for (int i = 0; i < connections; ++i) {
    greedy.push_back(std::make_unique<Client>(executor, server->addresses().front()));
    sessions.push_back(greedy.back()->join("greedy"));
  }
  Client polite = client();
  const std::string own = polite.join("polite");
  const Datum lease = polite.ask(request(own, 1, "(lease 2000000)"))[2][1];
  const Revision begun = board.store().revision();
  // So the revision says how many were done.
  const std::string costly_change = "(transact ((absent (note ? (f ?x)))) ((tell (note -1 x) 0)))";
  for (int n = 1; n <= requests; ++n) {
    for (std::size_t i = 0; i < greedy.size(); ++i) greedy[i]->send(request(sessions[i], n, costly_change));
  }
  pass(executor, 1ms);
  EXPECT_EQ(symbol_of(polite.ask(request(own, 2, "(renew " + write(lease) + ")"))), "ok");
  const Revision before = board.store().revision();
  EXPECT_EQ(symbol_of(polite.ask(request(own, 3, costly))), "ok");
  EXPECT_LE(board.store().revision() - before, 4U) << "the next turn but one is the polite client's";
  EXPECT_LT(board.store().revision() - begun, Revision{connections * requests / 2});
  for (const auto& each : greedy) {
    for (int n = 1; n <= requests; ++n) EXPECT_EQ(symbol_of(each->receive()), "ok");
  }
  EXPECT_TRUE(refusals("greedy").empty());
}

// Costly retractions, conditions and takings wait as well as questions.
TEST_F(ServerEffort, WhatIsCostlyWaitsWhileOthersAskAndWhatIsNotIsDoneAtOnce) {
  Client greedy = client();
  Client another = client();
  const std::string own = greedy.join("greedy");
  const std::string others = another.join("another");
  keep_company();
  another.send(request(others, 1, costly));
  int number = 0;
  for (const std::string body : {costly, "(transact () ((retract (note ? (f ?x)))))",
                                 "(transact ((absent (note ? (f ?x)))) ())", "(take (note ? (f ?x)) 0)"}) {
    EXPECT_EQ(symbol_of(greedy.ask(request(own, ++number, body))), "ok") << body;
    another.send(request(others, 1 + number, "(ask (note 17 ?what))"));
    EXPECT_EQ(symbol_of(another.receive()), "ok");
  }
}

TEST_F(ServerEffort, WhoAsksACostlyQuestionNowAndThenIsServed) {
  Client lone = client();
  const std::string own = lone.join("lone");
  for (int n = 1; n <= 6; ++n) {
    EXPECT_EQ(symbol_of(lone.ask(request(own, n, costly))), "ok");
    pass(executor, 150ms);
  }
  EXPECT_TRUE(refusals("lone").empty());
}

// Whoever else asks is answered before the rest of them.
TEST_F(ServerEffort, TheMessagesOfAFrameTakeTurnsWithOthers) {
  constexpr int questions = 40;
  Client greedy = client();
  const std::string session = greedy.join("greedy");
  Client polite = client();
  const std::string own = polite.join("polite");
  const Datum lease = polite.ask(request(own, 1, "(lease 2000000)"))[2][1];
  pass(executor, 200ms);
  std::string frame;
  for (int n = 1; n <= questions; ++n) frame += request(session, n, costly);
  greedy.send(frame);
  pass(executor, 1ms);
  EXPECT_EQ(symbol_of(polite.ask(request(own, 2, "(renew " + write(lease) + ")"))), "ok");
  int answered = 0;
  const auto hear = [&](Duration patience) {
    for (Datum reply = greedy.receive(patience); reply != Datum(); reply = greedy.receive(patience)) {
      ASSERT_EQ(reply[1], to_datum(++answered)) << "in order";
    }
  };
  hear(1us);
  EXPECT_LE(answered, questions / 2);
  hear(1s);
  EXPECT_EQ(answered, questions);
}

TEST_F(ServerEffort, ALoneClientHasAllMessagesOfItsFramesDoneInOrder) {
  Client lone = client();
  const std::string own = lone.join("lone");
  // As many replies as may be under way to who does not read them.
  constexpr int frames = 3;
  constexpr int of_a_frame = 64;
  for (int f = 0; f < frames; ++f) {
    std::string frame;
    for (int i = 0; i < of_a_frame; ++i) {
      const int number = f * of_a_frame + i + 1;
      const std::string told = std::to_string(1'000'000 + number);
      frame += request(
          own, number,
          i % 4 == 0 ? "(ask (query (note ?n ?) (limit 200)))" : "(transact () ((tell (note " + told + " x) 0)))");
    }
    lone.send(frame);
  }
  for (int n = 1; n <= frames * of_a_frame; ++n) {
    const Datum reply = lone.receive();
    ASSERT_TRUE(reply.is_form("reply"));
    ASSERT_EQ(reply[1], to_datum(n));
    ASSERT_EQ(symbol_of(reply), "ok");
  }
}

// Whatever waits of a client, the next turn is another's.
TEST(Workload, GivesEachClientATurnAfterAnotherAndItsSessionsTakeThemInTurn) {
  VirtualExecutor executor;
  server::Workload workload(executor);
  for (const wire::SessionId session : {11U, 12U, 13U, 12U}) workload.wait("greedy", session);
  workload.wait("polite", 21);
  std::vector<wire::SessionId> order;
  for (; !workload.empty(); order.push_back(workload.next())) EXPECT_LE(workload.clients(), 2U);
  EXPECT_EQ(order, (std::vector<wire::SessionId>{11, 21, 12, 13}));
}

TEST(Workload, HearsOthersAfterATurnForAsLongAsItTook) {
  VirtualExecutor executor;
  server::Workload workload(executor);
  std::optional<Time> turn;
  workload.on_turn = [&] { turn = executor.now(); };
  const Time begun = executor.now();
  workload.took(1, limits::examined);
  workload.heard(1);
  EXPECT_TRUE(workload.is_free()) << "nobody else speaks";
  workload.heard(2);
  executor.run_for(24ms);
  EXPECT_TRUE(workload.is_resting());
  EXPECT_FALSE(workload.is_free());
  workload.wait("greedy", 1);
  executor.run_for(1ms);
  EXPECT_FALSE(workload.is_resting());
  EXPECT_FALSE(workload.is_free()) << "another waits";
  EXPECT_EQ(turn, begun + 25ms);
  workload.next();
  EXPECT_TRUE(workload.is_free());
}

TEST(Workload, NeedsNoRestAfterWhatLooksAtLittle) {
  VirtualExecutor executor;
  server::Workload workload(executor);
  workload.took(1, server::Workload::out_of_turn);
  workload.heard(2);
  EXPECT_FALSE(workload.is_resting());
}

}  // namespace
}  // namespace pizarra
