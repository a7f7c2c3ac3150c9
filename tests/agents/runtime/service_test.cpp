#include "agents/runtime/service.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <optional>

#include "agents/runtime/caller.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/blackboard/passing_board.hpp"

namespace pizarra::runtime {
namespace {

constexpr std::string_view adder_contract =
    "(contract adder (offers (add (a number) (b number)) (slow) (refuse) (babble)))";

Datum form(std::string_view written) { return read_one(written).value(); }

// The board of an agent whose leases may lapse: no renewal comes through while it is held up.
class LaggingBoard : public PassingBoard {
 public:
  LaggingBoard(Executor& executor, std::unique_ptr<Board> board)
      : PassingBoard(std::move(board)), executor_(executor) {}

  Task<Result<void>> renew(LeaseId lease) override {
    while (held_up) co_await sleep(executor_, 10ms);
    co_return co_await PassingBoard::renew(lease);
  }

  bool held_up = false;

 private:
  Executor& executor_;
};

// One agent's life: destroying it is the agent's death.
class Life {
 public:
  Life(Executor& executor, memory::MemoryBoard& board, std::string name, std::string_view contract)
      : board_(executor, board.view(name)),
        context_{name, "localhost", executor, board_, Random(1)},
        service(context_, contract_from_text(contract).value()),
        caller(context_, service) {}

  void serve(Executor& executor) { job_ = executor.spawn(run(executor)); }
  void be_present(Executor& executor) { job_ = executor.spawn(start()); }

  void hold_up(bool held_up) { board_.held_up = held_up; }

  int handled = 0;

 private:
  Task<void> start() {
    const Result<void> started = co_await service.start();
    EXPECT_TRUE(started.has_value());
  }
  Task<void> run(Executor& executor) {
    const Result<void> started = co_await service.start();
    EXPECT_TRUE(started.has_value());
    const Handler handler = [this, &executor](Datum operation) { return handle(executor, std::move(operation)); };
    const Result<void> served = co_await service.serve(handler);
    EXPECT_TRUE(served.has_value());
  }
  Task<Result<Datum>> handle(Executor& executor, Datum operation) {
    ++handled;
    if (operation.is_form("slow")) co_await sleep(executor, 10s);
    if (operation.is_form("refuse")) co_return fail("unwilling", "not today", "refuse"_sym);
    if (operation.is_form("slow")) co_return list("slept"_sym);
    if (operation.is_form("babble")) co_return list("?variable"_sym);
    co_return list(operation[1].number() + operation[2].number());
  }

  LaggingBoard board_;
  AgentContext context_;

 public:
  Service service;
  Caller caller;

 private:
  Job job_;
};

class Runtime : public testing::Test {
 protected:
  std::optional<Result<Datum>> call(Life& from, std::string_view operation, Duration timeout = 30s) {
    std::optional<Result<Datum>> answer;
    const Job job = executor.spawn(ask(from, form(operation), timeout, answer));
    executor.run_until([&] { return job.done(); });
    return answer;
  }
  static Task<void> ask(Life& from, Datum operation, Duration timeout, std::optional<Result<Datum>>& answer) {
    answer = co_await from.caller.call("adder", operation, timeout);
  }
  std::size_t count(std::string_view pattern) {
    Query query = query_from_datum(form(pattern)).value();
    return board.ask(query).value().answers.size();
  }

  VirtualExecutor executor;
  memory::MemoryBoard board{executor};
  Life user{executor, board, "user", "(contract user)"};
  std::optional<Life> adder;

  void SetUp() override {
    user.be_present(executor);
    begin();
    executor.run_for(1s);
  }
  void begin() {
    adder.emplace(executor, board, "adder", adder_contract);
    adder->serve(executor);
  }
};

TEST_F(Runtime, AnswersARequestOnceAndLeavesNothingBehind) {
  const auto answer = call(user, "(add 1 2)");
  ASSERT_TRUE(answer && answer->has_value());
  EXPECT_EQ(**answer, list(3.0));
  EXPECT_EQ(adder->handled, 1);
  EXPECT_EQ(count("(request ? ? ?)"), 0u);
  EXPECT_EQ(count("(reply ? ?)"), 0u);
}

TEST_F(Runtime, PassesTheAgentsFailureOn) {
  const auto answer = call(user, "(refuse)");
  ASSERT_TRUE(answer && !answer->has_value());
  EXPECT_EQ(answer->error().symbol, "unwilling");
  EXPECT_EQ(answer->error().sentence, "not today");
}

TEST_F(Runtime, RefusesWhatTheContractDoesNotOfferBeforeTheAgentSeesIt) {
  EXPECT_EQ(call(user, "(subtract 1 2)")->error().symbol, "unknown-operation");
  EXPECT_EQ(call(user, "(add 1 two)")->error().symbol, "wrong-shape");
  EXPECT_EQ(adder->handled, 0);
}

// A journal of an earlier version may hold such a client's.
TEST_F(Runtime, ARequestOfWhomNoAgentCanSpeakByNameIsAnsweredBeforeTheAgentSeesIt) {
  board.transact("my script", Transaction().tell(form("(request r1 adder (add 1 2))"))).value();
  executor.run_for(1s);
  EXPECT_EQ(count("(reply r1 (fail bad-name ? ?))"), 1u);
  EXPECT_EQ(adder->handled, 0);
}

TEST_F(Runtime, AnAnswerThatTheBoardRefusesBecomesAFailureAtOnce) {
  const Time asked = executor.now();
  const auto answer = call(user, "(babble)");
  ASSERT_TRUE(answer && !answer->has_value());
  EXPECT_EQ(answer->error().symbol, "bad-reply");
  EXPECT_LT(executor.now(), asked + 1s);
}

TEST_F(Runtime, ServesManyAtOnce) {
  std::optional<Result<Datum>> slow;
  const Job job = executor.spawn(ask(user, form("(slow)"), 30s, slow));
  executor.run_for(1s);
  const auto quick = call(user, "(add 1 1)");
  EXPECT_TRUE(quick && quick->has_value());
  EXPECT_FALSE(slow.has_value());
  executor.run_for(10s);
  EXPECT_TRUE(slow && slow->has_value());
}

TEST_F(Runtime, WithdrawsARequestThatIsNotAnsweredInTime) {
  adder.reset();
  const auto answer = call(user, "(add 1 2)", 1s);
  ASSERT_TRUE(answer && !answer->has_value());
  EXPECT_EQ(answer->error().symbol, "timeout");
  EXPECT_EQ(count("(request ? ? ?)"), 0u);
}

TEST_F(Runtime, ARequestWaitsForAnAgentThatStartsLater) {
  adder.reset();
  executor.run_for(5s);
  std::optional<Result<Datum>> answer;
  const Job job = executor.spawn(ask(user, form("(add 2 2)"), 30s, answer));
  executor.run_for(5s);
  EXPECT_FALSE(answer.has_value());
  begin();
  executor.run_for(5s);
  ASSERT_TRUE(answer && answer->has_value());
  EXPECT_EQ(**answer, list(4.0));
}

TEST_F(Runtime, AnAgentThatDiesInTheMiddleLeavesItsRequestToItsSuccessor) {
  std::optional<Result<Datum>> answer;
  const Job job = executor.spawn(ask(user, form("(slow)"), 60s, answer));
  executor.run_for(2s);
  EXPECT_EQ(adder->handled, 1);
  begin();
  executor.run_for(5s);
  EXPECT_EQ(adder->handled, 1) << "the successor takes the request once the dead one's lease lapsed";
  executor.run_for(10s);
  ASSERT_TRUE(answer && answer->has_value());
}

TEST_F(Runtime, ARequestThatComesWhileTheAgentsLeaseHasLapsedIsAnsweredOnceItIsBack) {
  adder->hold_up(true);
  executor.run_for(4s);
  ASSERT_EQ(count("(agent adder ? ?)"), 0u);
  std::optional<Result<Datum>> answer;
  const Job job = executor.spawn(ask(user, form("(add 2 2)"), 60s, answer));
  executor.run_for(1s);
  EXPECT_FALSE(answer.has_value());
  adder->hold_up(false);
  executor.run_for(2s);
  ASSERT_TRUE(answer && answer->has_value());
  EXPECT_EQ(**answer, list(4.0));
}

TEST_F(Runtime, AReplyThatWasReadyWhileTheAgentsLeaseHadLapsedIsToldOnceItIsBack) {
  for (const Duration back_after : {6s, 15s}) {
    const int handled = adder->handled;
    std::optional<Result<Datum>> answer;
    const Job job = executor.spawn(ask(user, form("(slow)"), 60s, answer));
    executor.run_for(1s);
    adder->hold_up(true);
    executor.run_for(back_after);
    EXPECT_EQ(count("(agent adder ? ?)"), 0u);
    EXPECT_FALSE(answer.has_value());
    adder->hold_up(false);
    executor.run_for(10s);
    ASSERT_TRUE(answer && answer->has_value()) << back_after.count();
    EXPECT_EQ(adder->handled, handled + 1) << "it is done once";
  }
}

TEST_F(Runtime, PresenceGoesWithinTheLeaseOfADeathAndFreesTheName) {
  EXPECT_EQ(count("(agent adder adder ?)"), 1u);
  EXPECT_EQ(count("(contract adder ?)"), 1u);
  adder.reset();
  executor.run_for(Presence::lease_length + 100ms);
  EXPECT_EQ(count("(agent adder ? ?)"), 0u);
  EXPECT_EQ(count("(contract adder ?)"), 0u);
  begin();
  executor.run_for(1s);
  EXPECT_EQ(count("(agent adder adder ?)"), 1u);
}

TEST_F(Runtime, ASecondAgentOfTheSameNameWaitsUntilTheFirstIsGone) {
  Life second(executor, board, "adder", adder_contract);
  second.serve(executor);
  executor.run_for(10s);
  call(user, "(add 1 1)");
  EXPECT_EQ(second.handled, 0);
  adder.reset();
  executor.run_for(5s);
  call(user, "(add 1 1)");
  EXPECT_EQ(second.handled, 1);
}

TEST_F(Runtime, ARequestToldTwiceIsDoneOnce) {
  const Datum request = form("(request again adder (add 1 2))");
  Transaction first;
  first.tell(request);
  board.transact("user", first).value();
  executor.run_for(1s);
  EXPECT_EQ(count("(reply again (ok 3.0))"), 1u);
  board.transact("user", Transaction().retract(form("(reply again ?)"))).value();
  board.transact("user", first).value();
  executor.run_for(1s);
  EXPECT_EQ(count("(reply again (ok 3.0))"), 1u);
  EXPECT_EQ(adder->handled, 1);
}

TEST_F(Runtime, WhoLivesStaysPresentWhateverIsRetracted) {
  board.transact("stranger", Transaction().retract(form("(agent adder ? ?)"))).value();
  EXPECT_EQ(count("(agent adder ? ?)"), 0u);
  executor.run_for(1s);
  EXPECT_EQ(count("(agent adder adder ?)"), 1u);
}

TEST_F(Runtime, ARequestToldAgainWhileItIsBeingDoneIsDoneOnce) {
  const Datum request = form("(request again adder (slow))");
  board.transact("user", Transaction().tell(request)).value();
  executor.run_for(1s);
  board.transact("user", Transaction().tell(request)).value();
  executor.run_for(1s);
  EXPECT_EQ(count("(request again ? ?)"), 0u);
  executor.run_for(10s);
  EXPECT_EQ(count("(reply again (ok slept))"), 1u);
  EXPECT_EQ(adder->handled, 1);
}

TEST_F(Runtime, ACallerWhoseRequestAndPresenceWereForgottenAsksAgain) {
  adder.reset();
  executor.run_for(3s);
  std::optional<Result<Datum>> answer;
  const Job job = executor.spawn(ask(user, form("(add 2 3)"), 60s, answer));
  executor.run_for(1s);
  ASSERT_EQ(count("(request ? adder ?)"), 1u);
  // What a restarted board leaves: no request, no presence and no lease.
  board.release(user.service.presence()).value();
  EXPECT_EQ(count("(request ? adder ?)"), 0u);
  executor.run_for(4s);
  EXPECT_EQ(count("(request ? adder ?)"), 1u);
  begin();
  executor.run_for(3s);
  ASSERT_TRUE(answer && answer->has_value());
}

TEST_F(Runtime, RequestsOfADeadCallerGo) {
  adder.reset();
  {
    Life other(executor, board, "other", "(contract other)");
    other.be_present(executor);
    executor.run_for(1s);
    std::optional<Result<Datum>> answer;
    const Job job = executor.spawn(ask(other, form("(add 1 1)"), 60s, answer));
    executor.run_for(1s);
    EXPECT_EQ(count("(request ? adder ?)"), 1u);
  }
  executor.run_for(3s);
  EXPECT_EQ(count("(request ? adder ?)"), 0u);
}

}  // namespace
}  // namespace pizarra::runtime
