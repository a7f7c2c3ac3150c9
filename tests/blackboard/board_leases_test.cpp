#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {
namespace {

class BoardLeases : public BoardTest {
 protected:
  LeaseId lease(Board& board, Duration length) { return wall->run(board.lease(length)).value_or(0); }
  void tell_under(Board& board, const std::string& fact, LeaseId lease) {
    Transaction transaction;
    transaction.tell(read(fact), {}, lease);
    EXPECT_EQ(symbol_of(transact(board, std::move(transaction))), "ok");
  }
  std::optional<Fact> take(Board& board, const std::string& pattern, LeaseId holder) {
    Result<std::optional<Fact>> taken = wall->run(board.take(read(pattern), holder));
    EXPECT_TRUE(taken.has_value()) << taken.error().sentence;
    return taken.value_or(std::nullopt);
  }
};

TEST_P(BoardLeases, AFactGoesWhenItsLeaseLapses) {
  tell_under(*alice, "(on a b)", lease(*alice, 500ms));
  tell(*alice, "(on c d)");
  EXPECT_TRUE(holds(*bob, "(on a b)"));
  EXPECT_TRUE(lapses(*bob, "(on a b)"));
  EXPECT_TRUE(holds(*bob, "(on c d)"));
}

TEST_P(BoardLeases, RenewingKeepsALeaseAndALapsedOneIsUnknown) {
  const LeaseId held = lease(*alice, 500ms);
  tell_under(*alice, "(on a b)", held);
  for (int i = 0; i < 4; ++i) {
    wall->pass(150ms);
    EXPECT_EQ(symbol_of(wall->run(alice->renew(held))), "ok");
  }
  EXPECT_TRUE(holds(*bob, "(on a b)"));
  EXPECT_TRUE(lapses(*bob, "(on a b)"));
  EXPECT_EQ(symbol_of(wall->run(alice->renew(held))), "unknown-lease");
  EXPECT_EQ(symbol_of(wall->run(alice->release(held))), "unknown-lease");
  EXPECT_EQ(symbol_of(wall->run(alice->take(read("(on ? ?)"), held))), "unknown-lease");
  Transaction late;
  late.tell(read("(on a b)"), {}, held);
  EXPECT_EQ(symbol_of(transact(*alice, late)), "unknown-lease");
}

TEST_P(BoardLeases, ReleasingALeaseLapsesItAtOnce) {
  const LeaseId held = lease(*alice, 60s);
  tell_under(*alice, "(on a b)", held);
  EXPECT_EQ(symbol_of(wall->run(alice->release(held))), "ok");
  EXPECT_FALSE(holds(*bob, "(on a b)"));
}

TEST_P(BoardLeases, ALapseIsOneRevisionToldByTheBoard) {
  const LeaseId held = lease(*alice, 60s);
  tell_under(*alice, "(on a b)", held);
  tell_under(*alice, "(on c d)", held);
  const std::unique_ptr<Watch> seen = watch(*bob, "(on ?x ?y)");
  EXPECT_EQ(next(*seen).added.size(), 2U);
  ASSERT_EQ(symbol_of(wall->run(alice->release(held))), "ok");
  const Change change = next(*seen);
  EXPECT_EQ(change.removed.size(), 2U);
  EXPECT_FALSE(change.resynchronised);
}

TEST_P(BoardLeases, TellingAgainSetsTheLeaseAnew) {
  const LeaseId first = lease(*alice, 60s);
  const LeaseId second = lease(*bob, 60s);
  tell_under(*alice, "(on a b)", first);
  tell_under(*bob, "(on a b)", second);
  ASSERT_EQ(symbol_of(wall->run(alice->release(first))), "ok");
  EXPECT_TRUE(holds(*bob, "(on a b)"));
  tell(*alice, "(on a b)");
  ASSERT_EQ(symbol_of(wall->run(bob->release(second))), "ok");
  EXPECT_TRUE(holds(*bob, "(on a b)")) << "told without a lease it stays";
}

TEST_P(BoardLeases, AnImpossibleLeaseIsRefused) {
  EXPECT_EQ(symbol_of(wall->run(alice->lease(0us))), "wrong-shape");
  EXPECT_EQ(symbol_of(wall->run(alice->lease(-1s))), "wrong-shape");
}

TEST_P(BoardLeases, TakeRemovesTheOldestFactThatFits) {
  tell(*alice, "(note 2 late)");
  tell(*alice, "(note 1 early)");
  const LeaseId holder = lease(*bob, 60s);
  EXPECT_EQ(take(*bob, "(note ?n ?)", holder)->datum, read("(note 2 late)"));
  EXPECT_FALSE(holds(*alice, "(note 2 ?)"));
  EXPECT_EQ(take(*bob, "(note 2 ?)", holder), std::nullopt);
  EXPECT_EQ(take(*bob, "(note ?n ?)", holder)->datum, read("(note 1 early)"));
}

TEST_P(BoardLeases, OfTwoTakersOneGetsTheFact) {
  const LeaseId for_alice = lease(*alice, 60s);
  const LeaseId for_bob = lease(*bob, 60s);
  for (int round = 0; round < 20; ++round) {
    tell(*alice, "(note " + std::to_string(round) + " work)");
    std::vector<Result<std::optional<Fact>>> results;
    const auto attempt = [&](Board& board, LeaseId holder) {
      return [](Board& b, LeaseId h, auto& out) -> Task<void> {
        Datum pattern = read_one("(note ?n work)").value();
        Result<std::optional<Fact>> taken = co_await b.take(pattern, h);
        out.push_back(std::move(taken));
      }(board, holder, results);
    };
    const Job first = wall->executor().spawn(attempt(*alice, for_alice));
    const Job second = wall->executor().spawn(attempt(*bob, for_bob));
    ASSERT_TRUE(wall->comes([&] { return results.size() == 2; }));
    ASSERT_TRUE(results[0].has_value());
    ASSERT_TRUE(results[1].has_value());
    EXPECT_NE(results[0]->has_value(), results[1]->has_value());
  }
}

TEST_P(BoardLeases, AHeldFactComesBackWhenItsHolderLapses) {
  tell(*alice, "(note 1 work)");
  const Fact taken = take(*bob, "(note ? ?)", lease(*bob, 500ms)).value();
  EXPECT_FALSE(holds(*alice, "(note ? ?)"));
  ASSERT_TRUE(comes_back(*alice, "(note 1 work)"));
  const std::vector<Answer> back = ask(*alice, "(note 1 work)");
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back.front().facts.front().teller, "alice");
  EXPECT_EQ(back.front().facts.front().when, taken.when);
  EXPECT_GT(back.front().facts.front().id, taken.id);
  Transaction late;
  late.settle(taken.id).tell(read("(mode done)"));
  EXPECT_EQ(symbol_of(transact(*bob, late)), "precondition-failed") << "it is no longer his to settle";
  EXPECT_FALSE(holds(*alice, "(mode done)"));
}

TEST_P(BoardLeases, ASettledFactDoesNotComeBack) {
  tell(*alice, "(note 1 work)");
  const LeaseId holder = lease(*bob, 60s);
  const Fact taken = take(*bob, "(note ? ?)", holder).value();
  Transaction done;
  done.settle(taken.id).tell(read("(mode done)"));
  ASSERT_EQ(symbol_of(transact(*bob, done)), "ok");
  EXPECT_EQ(symbol_of(transact(*bob, done)), "precondition-failed");
  ASSERT_EQ(symbol_of(wall->run(bob->release(holder))), "ok");
  EXPECT_FALSE(holds(*alice, "(note ? ?)"));
  EXPECT_TRUE(holds(*alice, "(mode done)"));
}

TEST_P(BoardLeases, AHeldFactGivesWayToANewerOneWithItsKey) {
  tell(*alice, "(note 1 old)");
  const LeaseId holder = lease(*bob, 60s);
  take(*bob, "(note ? ?)", holder);
  tell(*alice, "(note 1 new)");
  ASSERT_EQ(symbol_of(wall->run(bob->release(holder))), "ok");
  EXPECT_EQ(values(ask(*alice, "(note 1 ?what)"), "?what"), std::vector<Datum>{"new"_sym});
}

INSTANTIATE_TEST_SUITE_P(Walls, BoardLeases, testing::ValuesIn(all_walls()), wall_name);

}  // namespace
}  // namespace pizarra
