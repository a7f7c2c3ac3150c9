#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"
#include "tests/drivers/arm/motoman/host_cell.hpp"

namespace pizarra::arm {
namespace {

// SOH, 01,000, STX, the text, ETX and their sum, as the manual has it.
std::string block(const std::string& header, const std::string& text) {
  std::string summed = header + "\x02" + text + "\x03";
  unsigned sum = 0;
  for (const char c : summed) sum += static_cast<unsigned char>(c);
  return "\x01" + summed + static_cast<char>(sum & 0xff) + static_cast<char>(sum >> 8);
}

class Bsc : public testing::Test, protected BscCell {
 protected:
  std::string heard_after(std::string_view typed, Duration wait = 50ms) {
    const std::size_t before = wire.far.written.size();
    EXPECT_TRUE(wire.near.write(typed));
    executor.run_for(wait);
    return wire.far.written.substr(before);
  }
};

TEST_F(Bsc, TheControllerAnswersSignBySignAsTheManualHasIt) {
  ASSERT_TRUE(ask(wire.near.open(executor.now() + 1s)));
  EXPECT_EQ(heard_after("\x05"), "\x10\x30");
  EXPECT_EQ(heard_after(block("01,000", "RSTATS\r")), "\x10\x31");
  EXPECT_EQ(heard_after("\x04"), "\x05") << "it begins to answer";
  EXPECT_EQ(heard_after("\x10\x30"), block("90,001", "196,0\r"));
  EXPECT_EQ(heard_after("\x10\x31"), "\x04");
}

TEST_F(Bsc, ADamagedBlockIsAskedForAgainAndOneThatComesTwiceIsOne) {
  ASSERT_TRUE(ask(wire.near.open(executor.now() + 1s)));
  std::string damaged = block("01,000", "SVON 1\r");
  damaged[10] ^= 4;
  EXPECT_EQ(heard_after("\x05"), "\x10\x30");
  EXPECT_EQ(heard_after(damaged), "\x15");
  EXPECT_EQ(heard_after(block("01,000", std::string("SVON 1\0\r", 8))), "\x15");
  EXPECT_EQ(heard_after("\x05"), "\x10\x30") << "the last answer again";
  EXPECT_EQ(heard_after(block("01,000", "SVON 1\r")), "\x10\x31");
  EXPECT_EQ(heard_after(block("01,000", "SVON 1\r")), "\x10\x31");
  EXPECT_EQ(heard_after("\x05"), "\x10\x31");
  EXPECT_EQ(heard_after("\x04"), "\x05");
  EXPECT_EQ(heard_after("\x10\x30"), block("90,000", "0000\r"));
}

TEST_F(Bsc, NothingIsCarriedOutThatWasNotEnded) {
  ASSERT_EQ(connect(), "");
  const std::size_t before = cabinet.moves();
  const std::string move = block("01,000", "PMOVJ 50,1000,0,0,0,0,0,0,0,0,0,0,0,0\r");
  EXPECT_EQ(heard_after("\x05"), "\x10\x30");
  EXPECT_EQ(heard_after(move.substr(0, 20), 5s), "");
  EXPECT_EQ(heard_after("\x04"), "");
  executor.run_for(5s);
  EXPECT_EQ(cabinet.moves(), before);
}

TEST_F(Bsc, NoiseThatLooksLikeTheBeginningOfABlockSwallowsNothing) {
  ASSERT_TRUE(ask(wire.near.open(executor.now() + 1s)));
  EXPECT_EQ(heard_after("\x01\x05"), "\x10\x30");
}

TEST_F(Bsc, ATextOfSeveralBlocksComesOverWhole) {
  BscStation near(executor, wire.near, BscStation::Manners::yields);
  serving = Job();
  BscStation far(executor, wire.far, BscStation::Manners::insists);
  for (const std::size_t size : {0u, 1u, 255u, 256u, 257u, 1000u}) {
    ASSERT_TRUE(ask(near.open(executor.now() + 1s)));
    ASSERT_TRUE(ask(far.open(executor.now() + 1s)));
    std::string text;
    for (std::size_t i = 0; i < size; ++i) text += static_cast<char>('0' + i * 7 % 61);
    std::optional<Result<BscMessage>> come;
    const Job listening = executor.spawn(keep(far.receive(executor.now() + 5s), come));
    EXPECT_TRUE(ask(near.send({"02,001", text}))) << size;
    executor.run_until([&] { return come.has_value(); });
    ASSERT_TRUE(*come) << size;
    EXPECT_EQ((*come)->text, text);
    EXPECT_EQ((*come)->header, "02,001");
  }
}

TEST_F(Bsc, GoesThereAndGripsAndSaysWhy) {
  ASSERT_EQ(connect(), "");
  const Joints there = moved(0, 40);
  EXPECT_EQ(move({there}), "");
  EXPECT_TRUE(are_same_place(wait()->joints, there));
  EXPECT_EQ(outcome(arm.start_gripper(60)), "");
  EXPECT_NEAR(wait_for_gripper()->opening_mm, 60, 0.01);
  EXPECT_EQ(move({moved(0, -100)}), "");
  executor.run_for(200ms);
  ASSERT_TRUE(cabinet.obey("alarm 4321"));
  EXPECT_EQ(wait()->why_stopped->sentence, "the controller has alarm 4321");
}

// A line that loses some of what is written, or one octet of it, changes one, or puts one before: never two at once,
// for which the sum of a block is no match.
std::function<std::string(std::string)> bad_line(Random& random, double part) {
  return [&random, part](std::string bytes) {
    if (random.uniform(0, 1) >= part || bytes.empty()) return bytes;
    const std::size_t at = random.below(bytes.size());
    const char noise = static_cast<char>(random.below(256));
    switch (random.below(4)) {
      case 0:
        return std::string();
      case 1:
        return bytes.erase(at, 1);
      case 2:
        return bytes.insert(at, 1, noise);
      default:
        // Its parity is wrong.
        bytes[at] = 0;
        return bytes;
    }
  };
}

TEST_F(Bsc, OverALineThatLosesGarblesAndInventsEveryMoveIsMadeOnce) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    ASSERT_EQ(connect(), "");
    const std::uint64_t before = cabinet.moves();
    wire.near.spoil = bad_line(random, 0.1);
    wire.far.spoil = bad_line(random, 0.1);
    for (int i = 0; i < 40; ++i) {
      Joints there = up6().ready;
      there[0] = i % 2 == 0 ? 5 : -5;
      const Result<void> moving = ask(arm.start_move({there}, 1));
      ASSERT_TRUE(moving) << describe(moving.error()) << "seed " << seed << ", move " << i;
      Result<ArmReading> ended = wait();
      ASSERT_TRUE(ended) << "seed " << seed << ", move " << i << ": " << describe(ended.error());
      EXPECT_TRUE(are_same_place(ended->joints, there)) << "seed " << seed << ", move " << i;
    }
    wire.near.spoil = nullptr;
    wire.far.spoil = nullptr;
    EXPECT_EQ(cabinet.moves() - before, 40u) << "seed " << seed;
    executor.run_for(5s);
  }
}

TEST_F(Bsc, NobodyIsAnsweredWhatAnotherAsked) {
  ASSERT_EQ(connect(), "");
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const std::size_t cut_at = wire.near.written.size() + wire.far.written.size() + random.below(60);
    {
      const Job cut_off = executor.spawn([](HostLine& host) -> Task<void> {
        HostCommand question{"RSTATS"};
        static_cast<void>(co_await host.command(std::move(question)));
      }(line));
      executor.run_until(
          [&] { return wire.near.written.size() + wire.far.written.size() >= cut_at || cut_off.done(); });
    }
    const Result<std::int32_t> fingers = ask(link.variable(2));
    ASSERT_TRUE(fingers) << "seed " << seed << ": " << describe(fingers.error());
    EXPECT_EQ(*fingers, 0) << "seed " << seed;
  }
}

TEST(BscBlocks, WhateverComesIsCutIntoSignsAndNoOctetIsTakenTwice) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    for (int i = 0; i < 5'000; ++i) {
      std::string line = write_bsc({"90,001", "194,64\r"}).front() + "\x04\x05\x10\x30";
      for (std::uint64_t edits = random.below(6); edits > 0; --edits) {
        line[random.below(line.size())] = static_cast<char>(random.below(256));
      }
      std::size_t taken = 0;
      while (true) {
        const Result<std::optional<line::Frame>> frame = frame_of_bsc(std::string_view(line).substr(taken));
        ASSERT_TRUE(frame);
        if (!*frame) break;
        ASSERT_GT((*frame)->octets, 0u) << "seed " << seed;
        if (!(*frame)->message.empty()) static_cast<void>(read_bsc((*frame)->message));
        taken += (*frame)->octets;
      }
      EXPECT_LE(taken, line.size());
    }
  }
}

}  // namespace
}  // namespace pizarra::arm
