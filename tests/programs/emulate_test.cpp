// `pizarra emulate` as a person meets it at the shell.

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/programs/shell.hpp"

namespace pizarra::programs {
namespace {

// Types `lines` at the program and interrupts it a while later.
Said emulate(const std::string& arguments, const std::string& lines, double seconds = 0.5) {
  return shell(fmt::format("(printf '{}'; sleep {}) | timeout --preserve-status -s INT {} {} emulate {} 2>&1", lines,
                           seconds, seconds, PIZARRA_EMULATE, arguments));
}

// An arm's file is read first.
constexpr double arm_seconds = 1.5;

TEST(Emulate, SaysWhereItIsAndObeysWhoStandsBesideIt) {
  const Said said = emulate("ptu46-17.5 --pty", "status\\npower off\\nfly\\n");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(said.text.starts_with("ptu46-17.5 at /dev/pts/")) << said.text;
  EXPECT_NE(said.text.find("\npower on, pan 0.00 tilt 0.00 degrees, still\n"), std::string::npos) << said.text;
  EXPECT_NE(said.text.find("\npower off, pan 0.00"), std::string::npos) << said.text;
  EXPECT_NE(said.text.find("nobody here understands 'fly'"), std::string::npos) << said.text;
}

TEST(Emulate, TellsProgramsAnObjectALine) {
  const Said said = emulate("ptu46-70 --tcp 0 --json", "status\\n");
  EXPECT_TRUE(said.text.starts_with(R"({"emulates":"ptu46-70","at":"tcp://127.0.0.1:)")) << said.text;
  EXPECT_NE(said.text.find(R"({"power":true,"pan":0.0000,"tilt":0.0000,"state":"still"})"), std::string::npos)
      << said.text;
}

TEST(Emulate, AnArmsCabinetDoesWhatItsSwitchesSay) {
  const Said said = emulate("up6 --udp 0", "estop on\\npendant on\\nalarm 4107\\noverride 50\\n", arm_seconds);
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(said.text.starts_with("up6 at udp://127.0.0.1:")) << said.text;
  EXPECT_NE(said.text.find("power on, servo off, the pendant has control, emergency stop, alarm 4107, override 50 %, "
                           "still at 0.00 -35.00 -70.00 0.00 -55.00 0.00"),
            std::string::npos)
      << said.text;
}

TEST(Emulate, AControllerWithAPortAndASerialLineIsAtEither) {
  EXPECT_TRUE(emulate("up6-nx100 --tcp 0", "status\\n", arm_seconds).text.starts_with("up6-nx100 at tcp://127.0.0.1:"));
  EXPECT_TRUE(emulate("up6-nx100 --pty", "status\\n", arm_seconds).text.starts_with("up6-nx100 at /dev/pts/"));
}

TEST(Emulate, AnArmWhoseControllerHasItsTrackHasNoSerialLine) {
  EXPECT_TRUE(emulate("f3-track --tcp 0", "status\\n", arm_seconds).text.starts_with("f3-track at tcp://127.0.0.1:"));
  EXPECT_EQ(shell(fmt::format("{} emulate f3-track --pty 2>&1", PIZARRA_EMULATE)).status, 2);
}

TEST(Emulate, AnArmWithSeveralPortsNamesThemAll) {
  const Said said = emulate("ur5e --tcp 0", "status\\n", arm_seconds);
  const std::string ports = said.text.substr(0, said.text.find('\n'));
  EXPECT_TRUE(ports.starts_with("ur5e at tcp://127.0.0.1:")) << said.text;
  EXPECT_EQ(std::ranges::count(ports, ','), 4) << said.text;
}

TEST(Emulate, AnArmWithSerialLinesNamesBoth) {
  const Said said = emulate("f3 --pty", "status\\n", arm_seconds);
  EXPECT_TRUE(said.text.starts_with("f3 at /dev/pts/")) << said.text;
  EXPECT_NE(said.text.find(",/dev/pts/"), std::string::npos) << said.text;
}

TEST(Emulate, PortsThatThereAreNotAreRefusedAtOnce) {
  const Said beyond = emulate("ur5e --tcp 65534", "");
  EXPECT_EQ(beyond.status, 2);
  EXPECT_NE(beyond.text.find("ur5e has 5 ports, and from 65534 on there are not so many"), std::string::npos)
      << beyond.text;
  for (const char* port : {"70000", "-1", "http"}) {
    EXPECT_EQ(emulate(fmt::format("f3 --tcp {}", port), "").status, 2) << port;
  }
  EXPECT_EQ(emulate("f3 --tcp 65534", "", arm_seconds).status, 0);
}

TEST(Emulate, APortThatAnotherHasIsNamed) {
  for (const auto& [device, port] : {std::pair("up6", "--udp"), std::pair("ptu46-70", "--tcp"),
                                     std::pair("f3", "--tcp"), std::pair("gripper", "--tcp")}) {
    const std::string both = fmt::format(
        "{0} emulate {1} {2} 45671 >/dev/null </dev/null & first=$!; sleep {3}; {0} emulate {1} {2} 45671 </dev/null "
        "2>&1; "
        "status=$?; kill $first; wait; exit $status",
        PIZARRA_EMULATE, device, port, arm_seconds);
    const Said said = shell(fmt::format("timeout 20 bash -c '{}'", both));
    EXPECT_EQ(said.status, 4) << device << said.text;
    EXPECT_NE(said.text.find("cannot listen at 127.0.0.1 port 45671: "), std::string::npos) << device << said.text;
  }
}

TEST(Emulate, AnArmTellsProgramsAnObjectALine) {
  const Said said = emulate("up6 --udp 0 --json", "status\\n", arm_seconds);
  EXPECT_NE(said.text.find(R"({"power":true,"servo":false,"pendant":false,"estop":false,"hold":false,"alarm":0,)"),
            std::string::npos)
      << said.text;
}

TEST(Emulate, AGripperSaysWhatSomebodyBesideItMadeOfIt) {
  const Said said = emulate("gripper --tcp 0", "fault 11\\nrefuse 4\\nopen\\n");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(said.text.starts_with("gripper at tcp://127.0.0.1:")) << said.text;
  EXPECT_NE(said.text.find("power on, not active, fault 11, refuses with 4, still at"), std::string::npos) << said.text;
  EXPECT_NE(said.text.find("nobody here understands 'open'"), std::string::npos) << said.text;
}

TEST(Emulate, NamesThePortsOptionAsItWasTyped) {
  const Said udp = shell(fmt::format("timeout 5 {} emulate up6 --tcp 45672 2>&1", PIZARRA_EMULATE));
  EXPECT_EQ(udp.status, 2);
  EXPECT_TRUE(contains(udp, "--tcp: up6 is at a UDP port, which --udp says")) << udp.text;
  const Said tcp = shell(fmt::format("timeout 5 {} emulate f3 --udp 45672 2>&1", PIZARRA_EMULATE));
  EXPECT_EQ(tcp.status, 2);
  EXPECT_TRUE(contains(tcp, "--udp: f3 is at a TCP port, which --tcp says")) << tcp.text;
  const Said word = shell(fmt::format("{} emulate gripper --tcp x 2>&1", PIZARRA_EMULATE));
  EXPECT_TRUE(contains(word, "--tcp")) << word.text;
  EXPECT_FALSE(contains(word, "--port")) << word.text;
}

TEST(Emulate, RefusesOptionsThatTheDeviceHasNoUseFor) {
  EXPECT_EQ(shell(fmt::format("{} emulate up6 --pty 2>&1", PIZARRA_EMULATE)).status, 2);
  EXPECT_EQ(shell(fmt::format("{} emulate ptu46-70 --world ipc:///tmp/w 2>&1", PIZARRA_EMULATE)).status, 2);
  EXPECT_EQ(shell(fmt::format("{} emulate up6 --world tcp://a 2>&1", PIZARRA_EMULATE)).status, 2);
}

TEST(Emulate, RefusesWhatItDoesNotKnowAndPortsThatAreTaken) {
  EXPECT_EQ(shell(fmt::format("{} emulate ptu99 2>&1", PIZARRA_EMULATE)).status, 2);
  EXPECT_EQ(shell(fmt::format("{} emulate ptu46-70 --tcp 4000 --pty 2>&1", PIZARRA_EMULATE)).status, 2);
  const Said nowhere = shell(fmt::format("{} emulate ptu46-70 --address 192.0.2.1 --tcp 0 2>&1", PIZARRA_EMULATE));
  EXPECT_EQ(nowhere.status, 4);
  EXPECT_NE(nowhere.text.find("cannot listen at 192.0.2.1"), std::string::npos) << nowhere.text;
}

}  // namespace
}  // namespace pizarra::programs
