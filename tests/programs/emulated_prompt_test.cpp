// A prompt's forms find the devices of its cell, which are emulated ones in other programs.

#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"

namespace pizarra::programs {
namespace {

constexpr std::chrono::seconds patience{20};

Said prompt(const std::string& name, const std::string& sections, const std::string& words) {
  const std::string file = scratch_folder() + name + ".scm";
  std::ofstream(file) << "(cell " << name << " " << sections << ")";
  return shell_in_scratch(fmt::format("{} repl {} {}", PIZARRA_CELL, file, words));
}

// A device at a free port of this machine.
class Emulated {
 public:
  explicit Emulated(const std::string& device)
      : device_({PIZARRA_EMULATE, "emulate", device, device == "up6" ? "--udp" : "--tcp", "0"},
                scratch_folder() + device + ".log") {
    EXPECT_TRUE(wait_until([this] { return device_.said().find('\n') != std::string::npos; }, patience));
    const std::string line = device_.said().substr(0, device_.said().find('\n'));
    const std::string ports = line.substr(line.rfind(':') + 1);
    port_ = ports.substr(0, ports.find(','));
  }
  const std::string& port() const { return port_; }

 private:
  Running device_;
  std::string port_;
};

TEST(EmulatedPrompt, FormsWaitUntilTheArmIsThere) {
  const Emulated up6("up6");
  const std::string arm = "(arm motoman-up6 (driver hses \"127.0.0.1\" " + up6.port() + "))";
  const Said said = prompt("wired", arm, "--agents robot --eval '(robot (turn right 1))'");
  EXPECT_EQ(said.text, "true\n");
  EXPECT_EQ(said.status, 0);
}

TEST(EmulatedPrompt, FormsWaitUntilThePanTiltUnitIsThere) {
  const Emulated unit("ptu46-17.5");
  const std::string line = "(pan-tilt (tcp \"127.0.0.1\" " + unit.port() + "))";
  const Said said = prompt("head", line, "--agents pan-tilt --eval '(pan-tilt (set-pan-pos 10))'");
  EXPECT_EQ(said.text, "true\n");
  EXPECT_EQ(said.status, 0);
}

TEST(EmulatedPrompt, ADeviceThatDoesNotComeEndsItWithASentence) {
  // The port of one that is not there any more.
  const std::string port = Emulated("ptu46-70").port();
  const Said unit =
      prompt("headless", "(pan-tilt (tcp \"127.0.0.1\" " + port + "))", "--agents pan-tilt --eval '(help)'");
  EXPECT_EQ(unit.text, "pizarra: pan-tilt has not reached its unit within 10 s: 127.0.0.1 port " + port +
                           " is not reached: Connection refused\n");
  EXPECT_EQ(unit.status, 4);
}

}  // namespace
}  // namespace pizarra::programs
