#include "tests/bench/crash/ordeal.hpp"

#include <csignal>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/blackboard/link_proxy.hpp"

namespace pizarra::bench {

namespace {

using namespace std::chrono_literals;

constexpr int links = 4;
constexpr auto settle_patience = 90s;
// A session is forgotten after 10 s, and what it held and told under its leases long before.
constexpr auto longest_absence = 13s;
// Longer than anybody holds what it took; who was killed before it said what it had made never says so.
constexpr auto last_word_patience = 10s;

std::string link_path(const std::string& folder, int link) { return folder + "/link-" + std::to_string(link); }

}  // namespace

Ordeal::Ordeal(std::string folder, std::uint64_t seed, std::function<bool()> is_stopped)
    : folder_(std::move(folder)), is_stopped_(std::move(is_stopped)), random_(seed), links_(start_links(folder_)) {
  start_board();
  for (int number = 0; number < clients; ++number) start_client(number);
}

Child Ordeal::start_links(const std::string& folder) {
  return Child::running([&](Pipe& parent) {
    std::vector<std::string> paths;
    for (int link = 0; link < links; ++link) paths.push_back(link_path(folder, link));
    LinkProxy(paths, folder + "/board.ipc").run(parent.file());
  });
}

// A short history, so that the journal is compacted all the time.
void Ordeal::start_board() {
  board_.reset();
  board_.emplace(Child::program({program_beside("pizarra-board"), "--listen", "ipc://" + folder_ + "/board.ipc",
                                 "--journal", folder_ + "/board.journal", "--history", "1000"}));
}

void Ordeal::start_client(int number) {
  static constexpr void (*roles[clients])(const std::string&, int, int) = {
      write_items, write_items, flood_items, take_items, take_items, take_items, watch_counters, watch_counters};
  clients_.erase(number);
  const int who = next_who_++;
  const std::string address = "ipc://" + link_path(folder_, number % links);
  clients_.emplace(number, Child::running([&](Pipe& parent) { roles[number](address, who, parent.file()); }));
}

void Ordeal::round() {
  harm(random_.below(7));
  pass(between(200, 600));
}

void Ordeal::harm(std::uint64_t kind) {
  const auto number = static_cast<int>(random_.below(clients));
  const auto link = static_cast<int>(random_.below(links));
  const auto change_link = [this, link](LinkProxy::State state) {
    LinkProxy::command(links_.pipe().file(), link, state);
  };
  switch (kind) {
    case 0:
      board_.reset();
      return later(between(0, 300), [this] { start_board(); });
    case 1:
      // Again, perhaps before it has recovered.
      start_board();
      return later(between(1, 40), [this] { start_board(); });
    case 2:
      hear(clients_.at(number));
      return start_client(number);
    case 3:
    case 4:
      change_link(kind == 3 ? LinkProxy::State::cut : LinkProxy::State::silent);
      return later(between(50, kind == 3 ? 800 : 4000), [change_link] { change_link(LinkProxy::State::whole); });
    case 5:
      if (Clock::now() < absent_until_) return;
      absent_until_ = Clock::now() + longest_absence;
      return stop_for([this, number] { return &clients_.at(number); }, between(11'000, 13'000));
    default:
      if (random_.below(2) == 0) return stop_for([this] { return board_ ? &*board_ : nullptr; }, between(50, 1500));
      return stop_for([this, number] { return &clients_.at(number); }, between(50, 2500));
  }
}

void Ordeal::stop_for(std::function<Child*()> whom, Clock::duration time) {
  const auto send = [whom = std::move(whom)](int signal) {
    if (const Child* child = whom()) child->signal(signal);
  };
  send(SIGSTOP);
  later(time, [send] { send(SIGCONT); });
}

void Ordeal::later(Clock::duration time, std::function<void()> what) {
  due_.emplace(Clock::now() + time, std::move(what));
}

void Ordeal::pass(Clock::duration time) {
  const Clock::time_point end = Clock::now() + time;
  for (auto now = Clock::now(); now < end; now = Clock::now()) {
    if (is_stopped_()) throw Stopped();
    while (!due_.empty() && due_.begin()->first <= now) {
      const auto what = due_.extract(due_.begin());
      what.mapped()();
    }
    std::vector<pollfd> polled;
    for (auto& [number, client] : clients_) polled.push_back({client.pipe().file(), POLLIN, 0});
    poll(polled.data(), polled.size(), 5);
    for (auto& [number, client] : clients_) hear(client);
  }
}

void Ordeal::hear(Child& client) {
  Report report{};
  while (recv(client.pipe().file(), &report, sizeof report, MSG_DONTWAIT) == sizeof report) judge_.hear(report);
}

void Ordeal::settle() {
  while (!due_.empty()) pass(50ms);
  // The writers' last words are heard: what they were still told counts.
  for (int writer = 0; writer < writers; ++writer) {
    clients_.at(writer).signal(SIGSTOP);
    hear(clients_.at(writer));
    clients_.erase(writer);
  }
  const Clock::time_point patience = Clock::now() + settle_patience;
  Clock::time_point heard = Clock::now();
  std::size_t left = judge_.unmade();
  while (left > 0 && Clock::now() < std::min(patience, heard + last_word_patience)) {
    pass(200ms);
    if (judge_.unmade() < left) heard = Clock::now();
    left = judge_.unmade();
  }
  // A job taken by a client that is not sure of it comes back, and another does it.
  pass(2s);
}

Result<Verdict> Ordeal::judge() {
  clients_.clear();
  board_.reset();
  return judge_.judge(folder_ + "/board.journal");
}

Ordeal::Clock::duration Ordeal::between(int least_ms, int most_ms) {
  return std::chrono::milliseconds(least_ms + static_cast<int>(random_.below(most_ms - least_ms + 1)));
}

}  // namespace pizarra::bench
