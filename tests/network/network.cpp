#include "tests/network/network.hpp"

#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <sched.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/scratch.hpp"

namespace pizarra::network {

namespace {

int quietly(const std::string& command) { return std::system((command + " 2>/dev/null").c_str()); }

void must(const std::string& command) {
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

std::string first_line_of(int file) {
  std::string line;
  for (char c = 0; read(file, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

// The process of the test that made it; 0 where none of ours did.
int test_of(const std::string& name_space) {
  int test = 0;
  if (!name_space.starts_with("pz")) return 0;
  std::from_chars(name_space.data() + 2, name_space.data() + name_space.size(), test);
  return test;
}

// A test that was killed took nothing away with it: its hosts, and what runs there, go before the next one's come.
void remove_what_dead_tests_left() {
  std::error_code none_yet;
  for (const auto& entry : std::filesystem::directory_iterator("/run/netns", none_yet)) {
    const std::string name = entry.path().filename();
    const int test = test_of(name);
    if (test == 0 || std::filesystem::exists(fmt::format("/proc/{}", test))) continue;
    quietly(fmt::format("for pid in $(ip netns pids {0}); do kill -9 $pid; done; ip netns del {0}", name));
  }
}

}  // namespace

std::string Network::unavailable() {
  if (geteuid() != 0) return "network namespaces need root";
  if (quietly("ip -V >/dev/null") != 0) return "network namespaces need the program ip (iproute2)";
  if (access("/dev/net/tun", R_OK | W_OK) != 0) return "there is no /dev/net/tun to be had here";
  const std::string probe = fmt::format("pz-probe-{}", getpid());
  const bool allowed = quietly("ip netns add " + probe) == 0 && quietly("unshare --mount --uts true") == 0;
  quietly("ip netns del " + probe);
  return allowed ? "" : "network namespaces are not allowed here";
}

Network::Network(const std::string& name, Wires wires)
    : wires_(wires), prefix_(fmt::format("pz{}-{}", getpid(), name)) {}

// Where it fails midway, the destructor takes away what there is: Ctrl-C may have ended a program `ip`.
Network::Network(const std::string& name, const std::vector<std::string>& hosts, Wires wires) : Network(name, wires) {
  int number = 0;
  remove_what_dead_tests_left();
  std::filesystem::create_directories(shared_folder());
  for (const std::string& host : hosts) {
    const Host& made = hosts_[host] = {fmt::format("{}-{}", prefix_, host), fmt::format("10.83.0.{}", ++number),
                                       scratch_folder() + prefix_ + "/" + host + "/"};
    std::filesystem::create_directories(made.folder + "tmp");
    must("ip netns add " + made.name_space);
    must(fmt::format("ip -n {} link set lo up", made.name_space));
  }
  if (wires_ == Wires::veth) {
    lay_wires();
  } else {
    start_links();
  }
}

Network::~Network() {
  if (links_ != 0) {
    close(to_links_);
    close(from_links_);
    // A process forked meanwhile may hold the other end.
    kill(links_, SIGTERM);
    waitpid(links_, nullptr, 0);
  }
  for (const auto& [name, host] : hosts_) {
    kill_all_on(name);
    quietly("ip netns del " + host.name_space);
  }
  if (wires_ == Wires::veth) quietly("ip netns del " + prefix_);
  std::error_code gone_already;
  std::filesystem::remove_all(scratch_folder() + prefix_, gone_already);
}

// A bridge in a namespace of its own, so that nothing of this machine's network changes.
void Network::lay_wires() {
  must("ip netns add " + prefix_);
  must(fmt::format("ip -n {0} link add hub type bridge && ip -n {0} link set hub up", prefix_));
  int number = 0;
  for (const auto& [name, host] : hosts_) {
    const std::string port = fmt::format("port{}", ++number);
    must(fmt::format("ip -n {} link add {} type veth peer name pz0 netns {}", prefix_, port, host.name_space));
    must(fmt::format("ip -n {0} link set {1} master hub && ip -n {0} link set {1} up", prefix_, port));
    must(fmt::format("ip -n {0} addr add {1}/24 dev pz0 && ip -n {0} link set pz0 up", host.name_space, host.address));
  }
}

void Network::start_links() {
  std::vector<std::string> words = {PIZARRA_LINKS};
  for (const auto& [name, host] : hosts_) words.push_back(fmt::format("{}={}={}", name, host.name_space, host.address));
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int in[2];
  int out[2];
  if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) throw std::runtime_error("pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  const int spawned = posix_spawn(&links_, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(in[0]);
  close(out[1]);
  to_links_ = in[1];
  from_links_ = out[0];
  if (spawned != 0 || first_line_of(from_links_) != "ready") throw std::runtime_error("pizarra-links does not start");
}

std::string Network::command_links(const std::string& line) {
  const std::string whole = line + "\n";
  if (write(to_links_, whole.data(), whole.size()) != static_cast<ssize_t>(whole.size())) return "gone";
  return first_line_of(from_links_);
}

std::vector<std::string> Network::on(const std::string& name, const std::vector<std::string>& command) const {
  const Host& host = hosts_.at(name);
  constexpr const char* enter =
      "hostname \"$1\" && mount --bind \"$2\" /run && mkdir -p /run/shared && mount --bind \"$3\" /run/shared && shift "
      "3 && cd / && "
      "exec env XDG_RUNTIME_DIR=/run TMPDIR=/run/tmp \"$@\"";
  std::vector<std::string> words = {
      "/sbin/ip", "netns", "exec", host.name_space, "/usr/bin/unshare", "--mount", "--uts", "/bin/sh", "-c",
      enter,      "sh",    name,   host.folder,     shared_folder()};
  if (!host.clock_off.empty()) {
    words.insert(words.end(), {fmt::format("LD_PRELOAD={}", PIZARRA_CLOCK_OFF), "CLOCK_OFF_FILE=" + host.clock_off});
  }
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

// Written in place: whoever has started sees it in its memory.
void Network::put_clock_off(const std::string& name, std::chrono::seconds offset) {
  Host& host = hosts_.at(name);
  host.clock_off = host.folder + "clock-off";
  const long seconds = offset.count();
  const int file = open(host.clock_off.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const bool written = file >= 0 && pwrite(file, &seconds, sizeof seconds, 0) == sizeof seconds;
  close(file);
  if (!written) throw std::runtime_error("cannot write " + host.clock_off);
}

void Network::enter(const std::string& host) const {
  const int there = open(("/run/netns/" + hosts_.at(host).name_space).c_str(), O_RDONLY | O_CLOEXEC);
  if (there < 0 || setns(there, CLONE_NEWNET) != 0) throw std::runtime_error("cannot enter " + host);
  close(there);
}

std::string Network::shared_folder() const { return scratch_folder() + prefix_ + "/shared/"; }

void Network::link(const std::string& host, const std::string& conditions) {
  if (wires_ == Wires::forwarded) {
    const std::string answer = command_links(host + " " + conditions);
    if (answer != "ok") throw std::runtime_error("pizarra-links: " + answer);
    return;
  }
  const bool cut = conditions.ends_with("cut");
  must(fmt::format("ip -n {} link set pz0 {}", hosts_.at(host).name_space, cut ? "down" : "up"));
}

void Network::cut_power(const std::string& host) {
  link(host, "both cut");
  kill_all_on(host);
}

void Network::kill_all_on(const std::string& host) const {
  const std::string list = "ip netns pids " + hosts_.at(host).name_space + " 2>/dev/null";
  const std::unique_ptr<FILE, int (*)(FILE*)> pids(popen(list.c_str(), "r"), pclose);
  int pid = 0;
  while (pids != nullptr && std::fscanf(pids.get(), "%d", &pid) == 1) {
    // Who entered it itself lives on.
    if (pid != getpid()) kill(pid, SIGKILL);
  }
}

}  // namespace pizarra::network
