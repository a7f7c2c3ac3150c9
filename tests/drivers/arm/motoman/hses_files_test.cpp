// Files, jobs and management times at the emulated High Speed Ethernet Server, as fs100 and moto-hses ask for them.

#include <gtest/gtest.h>

#include "drivers/line/octets.hpp"
#include "tests/drivers/arm/motoman/hses_cell.hpp"

namespace pizarra::arm {
namespace {

constexpr std::uint32_t last = 0x8000'0000;

class HsesFileClients : public testing::Test, protected HsesCell {
 protected:
  struct Said {
    bool anything = false;
    std::uint32_t block = 0;
    std::uint8_t status = 0;
    std::uint16_t added = 0;
    std::string data = {};
  };
  // `kind` is 0 of a request, 1 of a block or an acknowledgement.
  Said say(std::uint8_t service, std::uint8_t kind, std::uint32_t block, const std::string& data) {
    line::OctetWriter octets(line::ByteOrder::little);
    octets.text("YERC").u16(32).u16(static_cast<std::uint16_t>(data.size())).u8(3).u8(2).u8(kind).u8(5).u32(block);
    octets.text("99999999").u16(0).u16(0).u8(0).u8(service).u16(0).text(data);
    const std::string reply = emulator.answer_about_files(octets.octets());
    if (reply.empty()) return {};
    line::OctetReader read(reply, line::ByteOrder::little);
    EXPECT_EQ(read.text(4), "YERC");
    EXPECT_EQ(read.u16(), 32);
    const std::size_t size = read.u16();
    EXPECT_EQ(read.text(4), std::string("\3\2\1\5", 4)) << "the file control answers this request";
    Said said{.anything = true, .block = read.u32()};
    read.text(8);
    EXPECT_EQ(read.u8(), service | 0x80);
    said.status = read.u8();
    read.u16();
    said.added = read.u16();
    read.u16();
    said.data = read.rest();
    EXPECT_EQ(said.data.size(), size);
    return said;
  }
  // In blocks of 400 octets, each acknowledged.
  void send(const std::string& name, const std::string& text) {
    ASSERT_EQ(say(0x15, 0, 0, name).block, 0u);
    for (std::uint32_t block = 1; 400 * (block - 1) < text.size(); ++block) {
      const std::uint32_t number = block | (400 * block >= text.size() ? last : 0);
      const Said taken = say(0x15, 1, number, text.substr(400 * (block - 1), 400));
      EXPECT_EQ(taken.status, 0);
      EXPECT_EQ(taken.block, number);
    }
  }
  std::string fetch(std::uint8_t service, const std::string& asked) {
    Said said = say(service, 0, 0, asked);
    std::string text = said.data;
    for (std::uint32_t block = 1; said.anything && said.status == 0; ++block) {
      EXPECT_EQ(said.block & ~last, block);
      if ((said.block & last) != 0) {
        EXPECT_FALSE(say(service, 1, said.block, "").anything) << "the last acknowledgement is not answered";
        break;
      }
      said = say(service, 1, said.block, "");
      text += said.data;
    }
    return text;
  }
  HsesReply control(std::uint16_t command, std::uint16_t instance, std::uint8_t attribute, std::uint8_t service,
                    const std::string& data = "") {
    HsesRequest request{.id = 1, .command = command, .instance = instance, .attribute = attribute};
    request.service = service;
    request.data = data;
    return read_hses_reply(run(executor, emulator.answer(write_hses(request)))).value_or(HsesReply{.status = 0xff});
  }
  std::uint16_t select(std::string name) {
    name.resize(36, '\0');
    return control(0x87, 1, 0, 0x02, name).added_status;
  }
  std::uint16_t start() { return control(0x86, 1, 1, 0x10, std::string("\1\0\0\0", 4)).added_status; }
  bool runs() { return (control(0x72, 1, 1, 0x0e).data[0] & 8) != 0; }
  void servo_on() {
    control(0x83, 2, 1, 0x10, std::string("\1\0\0\0", 4));
    executor.run_for(1s);
  }
  static std::string job(const std::string& instructions) {
    return "/JOB\r\n//NAME TEST\r\n//POS\r\n///NPOS 0,0,0,0,0,0\r\n//INST\r\n///DATE 2022/12/23 15:58\r\n" +
           instructions;
  }
};

TEST_F(HsesFileClients, AFileGoesThereAndComesBackInBlocks) {
  std::string text;
  for (int number = 0; number < 200; ++number) text += "'line " + std::to_string(number) + "\r\n";
  send("LONG.JBI", text);
  EXPECT_EQ(fetch(0x16, "LONG.JBI"), text);
  send("EXACT.DAT", std::string(800, 'x'));
  EXPECT_EQ(fetch(0x16, "EXACT.DAT"), std::string(800, 'x'));
  EXPECT_EQ(fetch(0x32, "*.JBI"), "LONG.JBI\r\n");
  EXPECT_EQ(fetch(0x32, "*.DAT"), "EXACT.DAT\r\n");
  EXPECT_EQ(fetch(0x32, "*.CND"), "");
  EXPECT_EQ(say(0x09, 0, 0, "LONG.JBI").status, 0);
  EXPECT_EQ(say(0x09, 0, 0, "LONG.JBI").added, 0xe2b3);
  EXPECT_EQ(say(0x16, 0, 0, "LONG.JBI").added, 0xe2b3);
}

// A client over UDP says again what it has had no answer to.
TEST_F(HsesFileClients, ABlockThatComesAgainIsTakenOnceAndAnsweredAgain) {
  ASSERT_EQ(say(0x15, 0, 0, "TWICE.JBI").block, 0u);
  for (const auto& [number, text] : {std::pair(1u, "one "), std::pair(2u | last, "two")}) {
    for (int time = 0; time < 2; ++time) {
      const Said taken = say(0x15, 1, number, text);
      EXPECT_TRUE(taken.anything);
      EXPECT_EQ(taken.block, number);
      EXPECT_EQ(taken.status, 0);
    }
  }
  EXPECT_EQ(fetch(0x16, "TWICE.JBI"), "one two");
}

TEST_F(HsesFileClients, AnAcknowledgementThatComesAgainIsAnsweredWithTheSameBlock) {
  const std::string text = std::string(400, 'a') + std::string(400, 'b') + "c";
  send("LONG.JBI", text);
  ASSERT_EQ(say(0x16, 0, 0, "LONG.JBI").block, 1u);
  const Said second = say(0x16, 1, 1, "");
  EXPECT_EQ(second.block, 2u);
  const Said again = say(0x16, 1, 1, "");
  EXPECT_EQ(again.block, 2u);
  EXPECT_EQ(again.data, second.data);
  EXPECT_EQ(say(0x16, 1, 2, "").block, 3u | last);
  EXPECT_EQ(say(0x16, 1, 2, "").data, "c");
  EXPECT_FALSE(say(0x16, 1, 3u | last, "").anything);
}

TEST_F(HsesFileClients, AFileMayStandInOneMessageBehindItsName) {
  EXPECT_EQ(say(0x15, 0, 0, std::string("API_TEST.JBI\0//NAME API_TEST", 28)).status, 0);
  EXPECT_EQ(fetch(0x16, "API_TEST.JBI"), "//NAME API_TEST");
}

TEST_F(HsesFileClients, WhatIsNoFileOrNoBlockIsRefusedOrPassedOver) {
  EXPECT_EQ(say(0x15, 0, 0, "../secret").added, 0xb004);
  EXPECT_EQ(say(0x15, 0, 0, "").added, 0xb004);
  EXPECT_EQ(say(0x33, 0, 0, "X").added, 0xa000);
  EXPECT_FALSE(say(0x15, 1, 1, "nobody has begun").anything);
  EXPECT_FALSE(say(0x16, 1, 7, "").anything);
  EXPECT_EQ(emulator.answer_about_files("YERC"), "");
}

TEST_F(HsesFileClients, AJobThatWasSentIsSelectedAndRuns) {
  EXPECT_EQ(select("TEST"), 0x4040);
  EXPECT_EQ(start(), 0x4040);
  send("TEST.JBI", job("NOP\r\nTIMER T=2.50\r\nEND\r\n"));
  EXPECT_EQ(select("TEST"), 0);
  EXPECT_EQ(start(), 0x2070) << "the servos are off";
  control(0x83, 2, 1, 0x10, std::string("\1\0\0\0", 4));
  EXPECT_EQ(start(), 0) << "they come on";
  executor.run_for(1s);
  EXPECT_TRUE(runs());
  EXPECT_EQ(start(), 0x2010) << "it runs";
  const HsesReply info = control(0x73, 1, 0, 0x01);
  EXPECT_TRUE(info.data.starts_with(std::string("TEST\0", 5)));
  EXPECT_EQ(info.data[32], 1) << "its line";
  executor.run_for(2s);
  EXPECT_FALSE(runs());
  EXPECT_EQ(start(), 0);
  executor.run_for(1s);
  control(0x83, 2, 1, 0x10, std::string("\2\0\0\0", 4));
  EXPECT_FALSE(runs()) << "the servos went off";
}

TEST_F(HsesFileClients, AJobThatTheEmulatorCannotRunIsNotBegun) {
  servo_on();
  send("MOVES.JBI", job("NOP\r\nMOVJ C00000 VJ=25.00\r\nEND\r\n"));
  EXPECT_EQ(select("MOVES"), 0);
  EXPECT_EQ(start(), 0x5110);
  send("ENDLESS.JBI", job("NOP\r\n"));
  EXPECT_EQ(select("ENDLESS"), 0);
  EXPECT_EQ(start(), 0x5110);
  EXPECT_EQ(control(0x87, 2, 0, 0x02, std::string(36, '\0')).added_status, 0xa001);
}

TEST_F(HsesFileClients, ManagementTimesCountPowerServosAndMotion) {
  executor.run_for(61s);
  EXPECT_EQ(control(0x88, 1, 0, 0x01).data, "0000/00/00 00:00000000:01'01");
  EXPECT_EQ(control(0x88, 10, 2, 0x0e).data, "000000:00'00");
  servo_on();
  executor.run_for(9s);
  EXPECT_EQ(control(0x88, 10, 2, 0x0e).data, "000000:00'10");
  EXPECT_EQ(control(0x88, 211, 2, 0x0e).data, "000000:00'00");
  ASSERT_EQ(connect(), "");
  ASSERT_EQ(move({moved(0, 60)}, 0.1), "");
  ASSERT_TRUE(wait());
  EXPECT_GT(control(0x88, 211, 2, 0x0e).data, "000000:00'02");
  EXPECT_EQ(control(0x88, 2, 0, 0x01).added_status, 0xa001);
}

}  // namespace
}  // namespace pizarra::arm
