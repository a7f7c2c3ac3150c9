#include <fmt/format.h>
#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"
#include "lisp/writer.hpp"
#include "tests/drivers/arm/motoman/host_cell.hpp"

namespace pizarra::arm {
namespace {

using Kind = HostCommand::Kind;

class EthernetServer : public testing::Test, protected EthernetCell {
 protected:
  // "" or the symbol of what went wrong.
  std::string give(const char* name, const char* operands, Kind kind = Kind::order) {
    const Result<std::string> answer = ask(line.command({name, operands, kind}));
    return answer ? *answer : write(answer.error().subject) + " " + answer.error().symbol;
  }
  // The server's answers to lines typed at it.
  std::string typed(std::string_view text) {
    const std::size_t before = wire.far.written.size();
    EXPECT_TRUE(ask(wire.near.open(executor.now() + 1s)));
    EXPECT_TRUE(wire.near.write(text));
    executor.run_for(100ms);
    return wire.far.written.substr(before);
  }
};

// As the manual's figures have it.
TEST_F(EthernetServer, TheServerAnswersToWhatTheManualHasAHostType) {
  EXPECT_EQ(typed("CONNECT Robot_access Keep-Alive:-1\r\nHOSTCTRL_REQUEST SVON 2\r\n1\rHOSTCTRL_REQUEST RSTATS 0\r\n"),
            "OK: NX Information Server(1.30) Keep-Alive:-1.\r\nOK: SVON\r\n0000\rOK: RSTATS\r\n196,0\r");
  EXPECT_EQ(typed("CONNECT Robot_access\r\nHOSTCTRL_REQUEST HOLD 2\r\n1\rHOSTCTRL_REQUEST RSTATS 0\r\n"),
            "OK: NX Information Server(1.30).\r\nOK: HOLD\r\n0000\r")
      << "without Keep-Alive a session is one command";
  EXPECT_EQ(typed("GET / HTTP/1.0\r\n"), "NG: HTTP Error Response\r\n");
}

TEST_F(EthernetServer, TheDriverTypesWhatTheManualHas) {
  ASSERT_EQ(connect(), "");
  wire.near.written.clear();
  EXPECT_EQ(ask(link.set_variable(0, 84000)).has_value(), true);
  MotomanPulses pulses = ask(link.pulses()).value();
  pulses[0] += 1000;
  EXPECT_EQ(outcome(link.move_joints(pulses, 0.5)), "");
  const std::string operands = fmt::format("50.00,{},{},{},{},{},{},0,0,0,0,0,0,0", pulses[0], pulses[1], pulses[2],
                                           pulses[3], pulses[4], pulses[5]);
  EXPECT_EQ(wire.near.written, "HOSTCTRL_REQUEST LOADV 10\r\n2,0,84000\rHOSTCTRL_REQUEST RPOSJ 0\r\n" +
                                   fmt::format("HOSTCTRL_REQUEST PMOVJ {}\r\n{}\r", operands.size() + 1, operands));
}

TEST_F(EthernetServer, RefusesWithItsOwnCodes) {
  ASSERT_EQ(connect(), "");
  const auto code = [](int value) { return std::to_string(value) + " refused"; };
  EXPECT_EQ(give("FLY", ""), code(0x1010));
  EXPECT_EQ(give("SVON", "1,2"), code(0x1011));
  EXPECT_EQ(give("SVON", "7"), code(0x1012));
  EXPECT_EQ(give("SVON", "nan"), code(0x1012));
  EXPECT_EQ(give("SAVEV", "2,100", Kind::question), code(0x1012)) << "there is no D100";
  EXPECT_EQ(give("LOADV", "2,0,1e300"), code(0x1012));
  EXPECT_EQ(give("PMOVJ", "50,99999999,0,0,0,0,0,0,0,0,0,0,0,0", Kind::motion), code(0x5200));
  ASSERT_TRUE(cabinet.obey("pendant on"));
  EXPECT_EQ(give("SVON", "1"), code(0x2100));
  ASSERT_TRUE(cabinet.obey("pendant off"));
  ASSERT_TRUE(cabinet.obey("estop on"));
  EXPECT_EQ(give("SVON", "1"), code(0x3450));
  EXPECT_EQ(give("PMOVJ", "50,0,0,0,0,0,0,0,0,0,0,0,0,0", Kind::motion), code(0x2070));
}

TEST_F(EthernetServer, ASessionThatTheControllerEndedIsBegunAnewUnnoticed) {
  ASSERT_EQ(connect(), "");
  executor.run_for(60s);  // of silence: the controller has hung up
  wire.near.written.clear();
  EXPECT_EQ(move({moved(0, 20)}), "");
  EXPECT_TRUE(wire.near.written.starts_with("CONNECT")) << wire.near.written.substr(0, 80);
  EXPECT_TRUE(wait());
  EXPECT_EQ(cabinet.moves(), 1u);
}

TEST_F(EthernetServer, WhatIsCutOffInTheMiddleIsNotAnsweredToWhoComesNext) {
  ASSERT_EQ(connect(), "");
  {
    const Job cut_off = executor.spawn([](HostLine& host) -> Task<void> {
      HostCommand question{"RSTATS"};
      static_cast<void>(co_await host.command(std::move(question)));
    }(line));
    executor.run_until([&] { return wire.near.written.ends_with("RSTATS 0\r\n"); });
  }
  const Result<MotomanPulses> pulses = ask(link.pulses());
  ASSERT_TRUE(pulses) << describe(pulses.error());
  EXPECT_EQ((*pulses)[0], 0);
}

// Every connection ends after some octets, anywhere in a message.
TEST_F(EthernetServer, OverConnectionsThatBreakEveryMoveIsMadeOnce) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    ASSERT_EQ(connect(), "");
    const std::uint64_t before = cabinet.moves();
    std::uint64_t left = 0;
    const auto breaks = [&](std::string bytes) {
      if (bytes.size() < left) {
        left -= bytes.size();
        return bytes;
      }
      bytes.resize(left);
      left = 50 + random.below(2000);
      wire.far.close();
      return bytes;
    };
    wire.far.spoil = breaks;
    for (int i = 0; i < 40; ++i) {
      Joints there = up6().ready;
      there[0] = i % 2 == 0 ? 5 : -5;
      const std::string moving = move({there});
      ASSERT_TRUE(moving.empty()) << "seed " << seed << ", move " << i << ": " << moving;
      const Result<ArmReading> ended = wait();
      ASSERT_TRUE(ended) << "seed " << seed << ", move " << i << ": " << describe(ended.error());
      EXPECT_TRUE(are_same_place(ended->joints, there)) << "seed " << seed << ", move " << i;
    }
    wire.far.spoil = nullptr;
    EXPECT_EQ(cabinet.moves() - before, 40u) << "seed " << seed;
  }
}

TEST_F(EthernetServer, WhateverIsTypedTheServerLivesAndTheArmStands) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    const std::string sound =
        "CONNECT Robot_access Keep-Alive:-1\r\nHOSTCTRL_REQUEST LOADV 7\r\n2,5,17\rHOSTCTRL_REQUEST RPOSJ 0\r\n";
    for (int i = 0; i < 300; ++i) {
      std::string damaged = sound;
      for (std::uint64_t edits = 1 + random.below(6); edits > 0; --edits) {
        damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
      }
      typed(damaged.substr(0, random.below(damaged.size() + 1)));
    }
    EXPECT_EQ(cabinet.moves(), 0u) << "seed " << seed;
    EXPECT_TRUE(typed(sound).find("OK: RPOSJ\r\n0,") != std::string::npos) << "seed " << seed;
  }
}

}  // namespace
}  // namespace pizarra::arm
