#pragma once

// Hosts of a test, each a network namespace with its own address, name, folder in place of /run and, if need be, a wall
// clock that is wrong. Root alone may make them; a test elsewhere says why it is skipped.
//
//   if (const std::string why = Network::unavailable(); !why.empty()) GTEST_SKIP() << why;
//   Network network("deploy", {"arm-pc", "eyes-pc"}, Network::Wires::forwarded);
//   Running board(network.on("arm-pc", {PIZARRA_BOARD, "--listen", "tcp://" + network.address("arm-pc") + ":7800"}),
//   log); network.link("eyes-pc", "both delay 40 loss 1");       // as pizarra-links says (links_main.cpp)
//   network.cut_power("arm-pc");                           // everything there ends, and nobody is told
//   network.link("arm-pc", "both");                        // whole again
//
// With veth, hosts are on a bridge, and a link is whole or cut; forwarded, every packet comes through pizarra-links.
// All of it goes with the object: its processes are killed, its namespaces removed. Names hold the test's process, so
// that two tests never meet, and the next test removes what is left of one that was killed.

#include <chrono>
#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace pizarra::network {

class Network {
 public:
  enum class Wires { veth, forwarded };

  // Why there can be no hosts here; empty where there can.
  static std::string unavailable();
  Network(const std::string& name, const std::vector<std::string>& hosts, Wires wires);
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;
  ~Network();

  const std::string& address(const std::string& host) const { return hosts_.at(host).address; }
  // In place of /run there, and XDG_RUNTIME_DIR: ends with a slash.
  const std::string& folder(const std::string& host) const { return hosts_.at(host).folder; }
  // /run/shared on every host: for what hosts have in common that is no network, as the simulated world. Ends with a
  // slash.
  std::string shared_folder() const;
  // The command as that host runs it.
  std::vector<std::string> on(const std::string& host, const std::vector<std::string>& command) const;
  // Has the calling thread, and those that it starts from now on, be on that host's network.
  void enter(const std::string& host) const;
  // For processes that are started there once it was called; called again, their clocks jump.
  void put_clock_off(const std::string& host, std::chrono::seconds offset);
  // `both`, `out` or `in` with conditions behind it; with veth none but `cut`, both ways.
  void link(const std::string& host, const std::string& conditions);
  void cut_power(const std::string& host);
  void kill_all_on(const std::string& host) const;

 private:
  // Without hosts.
  Network(const std::string& name, Wires wires);
  struct Host {
    std::string name_space;
    std::string address;
    std::string folder;
    std::string clock_off = {};  // the file that says by how much; empty: it is right
  };
  void lay_wires();
  void start_links();
  std::string command_links(const std::string& line);

  const Wires wires_;
  const std::string prefix_;
  std::map<std::string, Host> hosts_;
  pid_t links_ = 0;
  int to_links_ = -1;
  int from_links_ = -1;
};

}  // namespace pizarra::network
