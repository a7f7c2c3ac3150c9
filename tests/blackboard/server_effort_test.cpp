// What a client that has the board look at much gets, and that nobody else waits for it.

#include <algorithm>

#include "blackboard/limits.hpp"
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
  // Makes an index, which takes a third of a second to pay for.
  static constexpr const char* owing = "(ask (note ?n (f 1)))";
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

TEST_F(ServerEffort, ManyConnectionsOfOneClientThatAskCostlyQuestionsDelayNobody) {
  constexpr int connections = 24;
  constexpr int questions = 2;  // of each
  std::vector<std::unique_ptr<Client>> greedy;
  std::vector<std::string> sessions;
  for (int i = 0; i < connections; ++i) {
    greedy.push_back(std::make_unique<Client>(executor, server->addresses().front()));
    sessions.push_back(greedy.back()->join("greedy"));
  }
  Client polite = client();
  const std::string own = polite.join("polite");
  const Datum lease = polite.ask(request(own, 1, "(lease 2000000)"))[2][1];
  for (int n = 1; n <= questions; ++n) {
    for (std::size_t i = 0; i < greedy.size(); ++i) greedy[i]->send(request(sessions[i], n, costly));
  }
  pass(executor, 1ms);
  EXPECT_EQ(symbol_of(polite.ask(request(own, 2, "(renew " + write(lease) + ")"))), "ok");
  std::map<std::string, int> before;
  const auto hear = [&](Duration patience) {
    for (const auto& each : greedy) {
      for (Datum reply = each->receive(patience); reply != Datum(); reply = each->receive(patience)) {
        ++before[symbol_of(reply)];
      }
    }
  };
  hear(50ms);
  EXPECT_GE(before["ok"], 1);
  EXPECT_LE(before["ok"], connections * questions / 2);
  EXPECT_EQ(before["ok"] + before["too-many"], connections * questions);
  EXPECT_EQ(refusals("greedy"), std::vector<Datum>{list("too-many"_sym, before["too-many"])});
  EXPECT_TRUE(refusals("polite").empty());
  EXPECT_EQ(symbol_of(polite.ask(request(own, 3, costly))), "ok") << "what others owe is not its own";
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

TEST_F(ServerEffort, WhoIsAloneIsServedWhateverItOwesUntilAnotherAsks) {
  Client lone = client();
  const std::string own = lone.join("lone");
  EXPECT_EQ(symbol_of(lone.ask(request(own, 1, owing))), "ok");
  int number = 1;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(symbol_of(lone.ask(request(own, ++number, costly))), "ok");
  keep_company();
  for (int i = 0; i < 5; ++i) lone.send(request(own, ++number, costly));
  std::map<std::string, int> symbols;
  for (int i = 0; i < 5; ++i) ++symbols[symbol_of(lone.receive())];
  EXPECT_GE(symbols["too-many"], 3);
  EXPECT_EQ(symbols["ok"] + symbols["too-many"], 5);
  pass(executor, 400ms);
  EXPECT_EQ(symbol_of(lone.ask(request(own, ++number, costly))), "ok") << "of what it owed alone, little was left";
}

// Of all that wait for the board each has its turn.
TEST_F(ServerEffort, WhoAsksOnSeveralConnectionsIsNotAlone) {
  constexpr int connections = 12;
  std::vector<std::unique_ptr<Client>> greedy;
  for (int i = 0; i < connections; ++i) {
    greedy.push_back(std::make_unique<Client>(executor, server->addresses().front()));
  }
  std::vector<std::string> sessions;
  for (const auto& each : greedy) sessions.push_back(each->join("greedy"));
  EXPECT_EQ(symbol_of(greedy[0]->ask(request(sessions[0], 1, owing))), "ok");
  for (std::size_t i = 0; i < greedy.size(); ++i) greedy[i]->send(request(sessions[i], 2, costly));
  std::map<std::string, int> symbols;
  for (const auto& each : greedy) ++symbols[symbol_of(each->receive())];
  EXPECT_GE(symbols["too-many"], connections / 2);
  EXPECT_EQ(symbols["ok"] + symbols["too-many"], connections);
}

// Costly retractions, conditions and takings are no other.
TEST_F(ServerEffort, WhoOwesIsRefusedWhatIsCostlyAloneAndServedWhatIsNot) {
  Client greedy = client();
  const std::string own = greedy.join("greedy");
  keep_company();
  int number = 0;
  const auto ask = [&](const std::string& body) { return symbol_of(greedy.ask(request(own, ++number, body))); };
  EXPECT_EQ(ask(owing), "ok");
  for (const std::string body :
       {"(transact () ((retract (note ? (f ?x)))))", "(transact ((absent (note ? (f ?x)))) ())",
        "(take (note ? (f ?x)) 0)", "(ask (note ?n 3))"}) {
    EXPECT_EQ(ask(body), "too-many") << body;
  }
  EXPECT_EQ(ask("(lease 2000000)"), "ok");
  EXPECT_EQ(ask("(ask (note 17 ?what))"), "ok");
  EXPECT_EQ(ask("(transact ((present (note 17 ?))) ((tell (note 17 x) 0) (retract (note 18 ?))))"), "ok");
  EXPECT_EQ(ask("(take (note 19 ?) 0)"), "ok");
  const Result<Answers> clients = board.ask(query("(client-stats \"greedy\" ? ?refused ?)"));
  EXPECT_GE(clients->answers.front().bindings.find("?refused")->integer(), 4);
  pass(executor, 600ms);
  EXPECT_EQ(ask(costly), "ok") << "it is paid by time";
}

// It begins, and what holds comes when that is paid for.
TEST_F(ServerEffort, AWatchOfWhoOwesWaits) {
  Client greedy = client();
  const std::string own = greedy.join("greedy");
  keep_company();
  EXPECT_EQ(symbol_of(greedy.ask(request(own, 1, owing))), "ok");
  const std::string nothing = "(and (note ?n ?what) (note ?n ?other) (/= ?what ?other) (< ?n 100))";
  EXPECT_EQ(symbol_of(greedy.ask(request(own, 2, "(watch 1 " + nothing + ")"))), "ok");
  EXPECT_EQ(greedy.receive(5ms), Datum());
  EXPECT_TRUE(greedy.receive().is_form("change"));
}

TEST_F(ServerEffort, AnIndexIsChargedToWhoHadItMade) {
  Client greedy = client();
  const std::string own = greedy.join("greedy");
  keep_company();
  EXPECT_EQ(symbol_of(greedy.ask(request(own, 1, owing))), "ok");
  EXPECT_EQ(symbol_of(greedy.ask(request(own, 2, costly))), "too-many");
  EXPECT_EQ(symbol_of(greedy.ask(request(own, 3, owing))), "ok") << "what is made finds it";
  Client other = client();
  EXPECT_EQ(symbol_of(other.ask(request(other.join("other"), 1, costly))), "ok");
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

// Each has its turn, and its other questions, pings and tells do not wait with them.
TEST_F(ServerEffort, WhoOwesNothingIsServedInItsTurnWhateverManyOthersOwe) {
  std::vector<std::unique_ptr<Client>> greedy;
  std::vector<std::string> sessions;
  for (int i = 0; i < 4; ++i) {
    greedy.push_back(std::make_unique<Client>(executor, server->addresses().front()));
    sessions.push_back(greedy.back()->join("greedy-" + std::to_string(i)));
    EXPECT_EQ(symbol_of(greedy.back()->ask(request(sessions.back(), 1, "(declare)"))), "ok");
  }
  const auto owe = [&](int number) {
    for (std::size_t i = 0; i < greedy.size(); ++i) greedy[i]->send(request(sessions[i], number, costly));
    for (const auto& each : greedy) EXPECT_TRUE(each->receive().is_form("reply"));
  };
  constexpr int questions = 8;
  for (int n = 2; n < 2 + questions; ++n) owe(n);
  std::vector<std::unique_ptr<Client>> modest;
  std::vector<std::string> own;
  for (int i = 0; i < 3; ++i) {
    modest.push_back(std::make_unique<Client>(executor, server->addresses().front()));
    own.push_back(modest.back()->join("modest-" + std::to_string(i)));
  }
  owe(2 + questions);
  for (std::size_t i = 0; i < modest.size(); ++i) {
    modest[i]->send(request(own[i], 1, costly));
    modest[i]->send(request(own[i], 2, "(ask (note 17 ?))"));
    modest[i]->send("(ping " + own[i] + ")");
  }
  for (const auto& each : modest) {
    std::vector<std::string> heard;
    for (int i = 0; i < 3; ++i) {
      const Datum said = each->receive();
      if (said.is_form("reply")) heard.push_back(write(said[1]) + " " + symbol_of(said));
    }
    EXPECT_EQ(heard, (std::vector<std::string>{"1 ok", "2 ok"}));
  }
  for (std::size_t i = 0; i < modest.size(); ++i) EXPECT_TRUE(refusals("modest-" + std::to_string(i)).empty());
}

// Of a board that many ask at any time.
class CrowdedQuota {
 public:
  server::LookQuota::Standing standing(const std::string& client, Time now) {
    be_asked(now);
    return quota_.standing(client, now);
  }
  bool is_spent(const std::string& client, Time now) {
    return standing(client, now) == server::LookQuota::Standing::spent;
  }
  void looked(const std::string& client, std::size_t examined, Time now) {
    be_asked(now);
    quota_.looked(client, examined, now);
  }

 private:
  void be_asked(Time now) {
    quota_.asked(1, "this one", now);
    quota_.asked(2, "that one", now);
  }

  server::LookQuota quota_;
};

TEST(LookQuota, WhoOwesIsSpentUntilItIsPaidAndSharesTheTimeWithOthersThatOwe) {
  CrowdedQuota quota;
  const Time begun(3600s);
  constexpr std::size_t a_second = 1000 * server::LookQuota::paid_a_millisecond;
  quota.looked("much", 2 * a_second, begun);
  quota.looked("less", a_second, begun);
  EXPECT_TRUE(quota.is_spent("much", begun));
  EXPECT_TRUE(quota.is_spent("less", begun));
  EXPECT_FALSE(quota.is_spent("other", begun));
  EXPECT_TRUE(quota.is_spent("less", begun + 1800ms));
  EXPECT_FALSE(quota.is_spent("less", begun + 2s));
  EXPECT_TRUE(quota.is_spent("much", begun + 2900ms));
  EXPECT_FALSE(quota.is_spent("much", begun + 3s));
  quota.looked("much", server::LookQuota::most_owed, begun + 3s);
  EXPECT_FALSE(quota.is_spent("much", begun + 4s));
}

bool is_spent(server::LookQuota& quota, const std::string& client, Time now) {
  return quota.standing(client, now) == server::LookQuota::Standing::spent;
}

TEST(LookQuota, WhoIsAloneIsNotSpentUntilAnotherAsksAndOwesLittleThen) {
  server::LookQuota quota;
  const Time begun(3600s);
  quota.asked(1, "lone", begun);
  quota.looked("lone", 40 * server::LookQuota::most_owed, begun);
  EXPECT_FALSE(is_spent(quota, "lone", begun));
  quota.asked(2, "other", begun + 10ms);
  EXPECT_TRUE(is_spent(quota, "lone", begun + 10ms));
  EXPECT_FALSE(is_spent(quota, "other", begun + 10ms));
  quota.asked(1, "lone", begun + 90ms);
  EXPECT_TRUE(is_spent(quota, "lone", begun + 90ms));
  EXPECT_FALSE(is_spent(quota, "lone", begun + 110ms));
}

TEST(LookQuota, WhoAsksOnAnotherConnectionTooIsNotAlone) {
  server::LookQuota quota;
  const Time begun(3600s);
  quota.asked(1, "lone", begun);
  quota.asked(2, "lone", begun + 10ms);
  quota.looked("lone", server::LookQuota::most_owed, begun + 20ms);
  EXPECT_TRUE(is_spent(quota, "lone", begun + 20ms));
}

// What is made for one that waits for it is looked at while others ask.
TEST(LookQuota, WhoWaitsWhileAnotherAsksIsNotAlone) {
  server::LookQuota quota;
  const Time begun(3600s);
  quota.asked(1, "waits", begun);
  quota.asked(2, "other", begun + 1s);
  quota.looked("waits", 40 * server::LookQuota::most_owed, begun + 1s);
  EXPECT_TRUE(is_spent(quota, "waits", begun + 1s));
  EXPECT_FALSE(is_spent(quota, "waits", begun + 2s)) << "for nobody else asks";
  quota.asked(2, "other", begun + 2s);
  EXPECT_TRUE(is_spent(quota, "waits", begun + 2s));
}

TEST(LookQuota, WhoIsAlonePaysByTimeToo) {
  server::LookQuota quota;
  const Time begun(3600s);
  quota.asked(1, "lone", begun);
  quota.looked("lone", server::LookQuota::most_owed, begun);
  EXPECT_FALSE(is_spent(quota, "lone", begun + 1s));
  quota.looked("lone", server::LookQuota::uncounted + 1, begun + 1s);
  quota.asked(2, "other", begun + 1s);
  EXPECT_FALSE(is_spent(quota, "lone", begun + 1s));
}

TEST(LookQuota, TheTimeThatCostlyLookingTakesPaysForNothing) {
  CrowdedQuota quota;
  const Time begun(3600s);
  quota.looked("slow", server::LookQuota::most_owed, begun);
  EXPECT_TRUE(quota.is_spent("slow", begun));
  quota.looked("other", server::LookQuota::most_owed, begun + 10s);
  EXPECT_TRUE(quota.is_spent("slow", begun + 10s));
}

TEST(LookQuota, WhileManyOweWhoOwesNothingHasATurnAfterAnother) {
  using Standing = server::LookQuota::Standing;
  CrowdedQuota quota;
  const Time begun(3600s);
  for (int i = 0; i < 4; ++i) quota.looked(std::to_string(i), 40 * server::LookQuota::most_owed, begun);
  EXPECT_EQ(quota.standing("0", begun), Standing::spent);
  EXPECT_EQ(quota.standing("one more", begun), Standing::free);
  quota.looked("one more", limits::examined, begun);
  const Duration paid = std::chrono::milliseconds(limits::examined / server::LookQuota::paid_a_millisecond);
  for (const std::string client : {"one more", "another"}) {
    EXPECT_EQ(quota.standing(client, begun + paid - 1ms), Standing::waits);
    EXPECT_EQ(quota.standing(client, begun + paid), Standing::free);
  }
  EXPECT_EQ(quota.standing("0", begun + paid), Standing::spent);
}

}  // namespace
}  // namespace pizarra
