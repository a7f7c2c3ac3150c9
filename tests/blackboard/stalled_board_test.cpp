// A message that came in time counts, also where the board's thread was held up until after the deadline.

#include <thread>

#include "blackboard/store/store.hpp"
#include "tests/blackboard/server_fixture.hpp"

namespace pizarra {
namespace {

// Long beside what a busy machine takes for a message.
constexpr Duration length = 2s;
constexpr Duration held_up = 2500ms;

class StalledBoard : public ServerTest {
 protected:
  struct Holder {
    Client client;
    std::string session;
    LeaseId lease;
  };

  // Nothing that is sent meanwhile is heard, and all of it is in the socket.
  void stall() const {
    const Time end = executor.now() + held_up;
    while (executor.now() < end) std::this_thread::sleep_for(1ms);
  }
  Holder holder() {
    Client client = this->client();
    const std::string session = client.join("alice");
    const std::string micros = std::to_string(length.count());
    const Datum granted = client.ask("(request " + session + " 1 (lease " + micros + "))");
    return {std::move(client), session, static_cast<LeaseId>(granted[2][1].integer())};
  }
  static std::string renewal(const Holder& holder, int number) {
    return "(request " + holder.session + " " + std::to_string(number) + " (renew " + std::to_string(holder.lease) +
           "))";
  }
  // They have the board look at what is due, over and over.
  void crowd_in_front() {
    for (std::size_t i = 0; i < 4; ++i) {
      crowd_.push_back(std::make_unique<Client>(executor, server->addresses().front()));
      const std::string session = crowd_.back()->join("crowd");
      for (int n = 1; n <= 50; ++n) {
        const std::string number = std::to_string(n);
        crowd_.back()->send("(request " + session + " " + number + " (transact () ((tell (note 99 " + number +
                            ") 0))))");
      }
    }
  }
  bool lapses(const std::function<bool()>& lapsed) {
    const Time deadline = executor.now() + 5 * length;
    while (!lapsed() && executor.now() < deadline) pass(executor, 10ms);
    return lapsed();
  }
  bool stands(const std::string& fact) { return !board.ask(query_for(read(fact)))->answers.empty(); }

  std::vector<std::unique_ptr<Client>> crowd_;
};

TEST_F(StalledBoard, ALeaseStandsThatWasRenewedInTimeAndLapsesLaterWhereItIsNot) {
  Holder alice = holder();
  ASSERT_TRUE(board.transact("alice", Transaction().tell(read("(note 1 here)"), {}, alice.lease)).has_value());
  crowd_in_front();
  alice.client.send(renewal(alice, 2));
  stall();
  EXPECT_EQ(alice.client.receive(), read("(reply 2 (ok ()))"));
  EXPECT_TRUE(stands("(note 1 here)"));
  EXPECT_TRUE(lapses([&] { return !stands("(note 1 here)"); }));
  EXPECT_TRUE(alice.client.ask(renewal(alice, 3))[2].is_form("fail"));
}

TEST_F(StalledBoard, WhatIsHeldUnderALeaseThatWasRenewedInTimeIsNotPutBack) {
  Holder alice = holder();
  ASSERT_TRUE(board.transact("bob", Transaction().tell(read("(note 1 work)"))).has_value());
  const FactId taken = board.take("alice", read("(note 1 ?)"), alice.lease).value()->id;
  crowd_in_front();
  alice.client.send(renewal(alice, 2));
  stall();
  EXPECT_EQ(alice.client.receive(), read("(reply 2 (ok ()))"));
  EXPECT_NE(board.store().held(taken), nullptr);
  EXPECT_FALSE(stands("(note 1 work)"));
  EXPECT_TRUE(lapses([&] { return stands("(note 1 work)"); }));
}

TEST_F(StalledBoard, ASessionThatWasHeardFromInTimeIsNotForgotten) {
  serve(length);
  Client client = this->client();
  const std::string session = client.join("alice");
  client.send("(ping " + session + ")");
  stall();
  EXPECT_EQ(client.receive().head(), "pong");
  EXPECT_EQ(server->sessions(), 1U);
  EXPECT_TRUE(lapses([&] { return server->sessions() == 0; }));
}

}  // namespace
}  // namespace pizarra
