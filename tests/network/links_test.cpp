// Hosts as tests have them: whether their links do to packets what they are told.

#include <chrono>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/network/network.hpp"

namespace pizarra::network {
namespace {

struct Said {
  int status = 0;
  std::string text;
};

Said run(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    std::string quoted;
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    line += "'" + quoted + "' ";
  }
  Said said;
  FILE* pipe = popen((line + "2>&1").c_str(), "r");
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) said.text += static_cast<char>(c);
  said.status = pclose(pipe);
  return said;
}

pid_t fork_asleep() {
  const pid_t forked = fork();
  if (forked != 0) return forked;
  pause();
  _exit(0);
}

void kill_and_wait(pid_t process) {
  EXPECT_EQ(kill(process, SIGKILL), 0);
  EXPECT_EQ(waitpid(process, nullptr, 0), process);
}

// Python is there wherever the tests are. Each probe prints one number.
constexpr const char* server = R"(
import socket,sys,threading
s=socket.socket(); s.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1); s.bind(("0.0.0.0",7843)); s.listen(16)
def serve(c):
    while True:
        d=c.recv(65536)
        if not d: return
        if len(d)==1: c.sendall(d)
while True:
    c,_=s.accept(); threading.Thread(target=serve,args=(c,),daemon=True).start()
)";
// Where packets are lost, TCP asks again after 1, 2, 4 ... s: of a line that loses a fifth each way, one connection in
// a thousand takes a minute.
constexpr const char* round_trip_ms = R"(
import socket,sys,time
c=socket.create_connection((sys.argv[1],7843),timeout=120); c.setsockopt(socket.IPPROTO_TCP,socket.TCP_NODELAY,1)
times=[]
for i in range(5):
    t=time.monotonic(); c.sendall(b"x"); c.recv(1); times.append(time.monotonic()-t)
print(min(times)*1000)
)";
constexpr const char* seconds_for_250_kb = R"(
import socket,sys,time
c=socket.create_connection((sys.argv[1],7843),timeout=30); t=time.monotonic()
c.setsockopt(socket.SOL_SOCKET,socket.SO_SNDBUF,8192)
for i in range(125): c.sendall(b"x"*2000)
print(time.monotonic()-t)
)";
constexpr const char* comes_through = R"(
import socket,sys
try:
    c=socket.create_connection((sys.argv[1],7843),timeout=1); c.sendall(b"x"); c.settimeout(1); c.recv(1); print(1)
except OSError: print(0)
)";

class Links : public testing::TestWithParam<Network::Wires> {
 protected:
  void SetUp() override {
    if (const std::string why = Network::unavailable(); !why.empty()) GTEST_SKIP() << why;
    network_ =
        std::make_unique<Network>("links", std::vector<std::string>{"arm-pc", "eyes-pc", "board-pc"}, GetParam());
    run({"/bin/sh", "-c",
         fmt::format("{} >/dev/null 2>&1 &", quoted(network_->on("board-pc", {"python3", "-c", server})))});
    for (int tries = 0; tries < 50 && probe("arm-pc", comes_through) != 1; ++tries) continue;
  }
  static std::string quoted(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) {
      line += '\'';
      for (const char c : word) line += c == '\'' ? "'\\''" : std::string(1, c);
      line += "' ";
    }
    return line;
  }
  double probe(const std::string& from, const char* script) const {
    const Said said = run(network_->on(from, {"python3", "-c", script, network_->address("board-pc")}));
    EXPECT_EQ(said.status, 0) << said.text;
    return said.status == 0 ? std::stod(said.text) : -1;
  }
  std::unique_ptr<Network> network_;
};

TEST_P(Links, JoinHostsUntilTheyAreCutAndAgainWhenTheyAreWhole) {
  EXPECT_EQ(probe("arm-pc", comes_through), 1);
  network_->link("arm-pc", "both cut");
  EXPECT_EQ(probe("arm-pc", comes_through), 0);
  EXPECT_EQ(probe("eyes-pc", comes_through), 1);
  network_->link("arm-pc", "both");
  EXPECT_EQ(probe("arm-pc", comes_through), 1);
}

TEST_P(Links, HaveHostsWithNamesFoldersAndClocksOfTheirOwn) {
  EXPECT_EQ(run(network_->on("eyes-pc", {"hostname"})).text, "eyes-pc\n");
  run(network_->on("eyes-pc", {"touch", "/run/left-here"}));
  EXPECT_EQ(run(network_->on("eyes-pc", {"ls", "/run/left-here"})).status, 0);
  EXPECT_NE(run(network_->on("arm-pc", {"ls", "/run/left-here"})).status, 0);
  network_->put_clock_off("eyes-pc", std::chrono::minutes(10));
  const auto clock = [&](const std::string& host) { return std::stol(run(network_->on(host, {"date", "+%s"})).text); };
  EXPECT_NEAR(static_cast<double>(clock("eyes-pc") - clock("arm-pc")), 600, 5);
}

TEST_P(Links, EndEverythingOnAHostWithoutPower) {
  EXPECT_EQ(probe("arm-pc", comes_through), 1);
  network_->cut_power("board-pc");
  network_->link("board-pc", "both");
  EXPECT_EQ(probe("arm-pc", comes_through), 0);
}

// Once its owner is dead, another test beside this one may be the next.
TEST_P(Links, TakeTheHostsAwayThatAKilledTestLeft) {
  const pid_t owner = fork_asleep();
  const std::string left = fmt::format("pz{}-left", owner);
  EXPECT_EQ(run({"ip", "netns", "add", left}).status, 0);
  FILE* asleep = popen(("exec ip netns exec " + left + " sh -c 'echo on; exec sleep 300' 2>&1").c_str(), "r");
  EXPECT_NE(std::fgetc(asleep), EOF);
  kill_and_wait(owner);
  const Network next("next", {"arm-pc"}, GetParam());
  EXPECT_FALSE(run({"ip", "netns", "list"}).text.contains(left));
  EXPECT_NE(pclose(asleep), 0) << "it was not killed";
}

TEST_P(Links, AreSlowLossyNarrowOrOneWay) {
  if (GetParam() == Network::Wires::veth) GTEST_SKIP() << "veth is whole or cut";
  network_->link("arm-pc", "both delay 40");
  EXPECT_NEAR(probe("arm-pc", round_trip_ms), 80, 30);
  EXPECT_LT(probe("eyes-pc", round_trip_ms), 40);
  network_->link("arm-pc", "both rate 1000");
  // 2 Mbit at 1 Mbit/s; what the socket and the line hold is under way when all is sent.
  EXPECT_GT(probe("arm-pc", seconds_for_250_kb), 0.5);
  EXPECT_LT(probe("eyes-pc", seconds_for_250_kb), 0.5);
  network_->link("arm-pc", "in cut");
  EXPECT_EQ(probe("arm-pc", comes_through), 0);
  network_->link("arm-pc", "both loss 20");
  EXPECT_GT(probe("arm-pc", round_trip_ms), 0);
}

TEST_P(Links, AreTakenDownThoughAProcessForkedMeanwhileLivesOn) {
  const pid_t forked = fork_asleep();
  network_.reset();
  kill_and_wait(forked);
}

INSTANTIATE_TEST_SUITE_P(Wires, Links, testing::Values(Network::Wires::veth, Network::Wires::forwarded),
                         [](const auto& wires) { return wires.param == Network::Wires::veth ? "Veth" : "Forwarded"; });

}  // namespace
}  // namespace pizarra::network
