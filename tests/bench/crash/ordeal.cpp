#include "tests/bench/crash/ordeal.hpp"

#include <csignal>
#include <poll.h>
#include <sys/socket.h>

namespace pizarra::bench {

namespace {

using namespace std::chrono_literals;

constexpr auto begin_patience = 120s;
constexpr auto settle_patience = 90s;
// Longer than anybody holds what it took; who was killed before it said what it had made never says so.
constexpr auto last_word_patience = 10s;
constexpr int giving_work = 5;  // the first of them

}  // namespace

void Ordeal::start_client(int number) {
  static constexpr Role roles[clients] = {write_items, write_items, flood_items, compare_registers, compare_registers,
                                          take_items,  take_items,  take_items,  watch_counters,    watch_counters};
  end(number);
  const int who = next_who_++;
  clients_.emplace(number, Child::running([&](Pipe& parent) {
                     const std::string address = come_to_the_board(number);
                     roles[number](address, who, parent.file());
                   }));
}

const Child* Ordeal::client(int number) const {
  const auto found = clients_.find(number);
  return found == clients_.end() ? nullptr : &found->second;
}

void Ordeal::stop_for(std::function<const Child*()> whom, Clock::duration time) {
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

void Ordeal::wait_until_begun() {
  const Clock::time_point patience = Clock::now() + begin_patience;
  while (!judge_.has_begun()) {
    if (Clock::now() > patience) throw std::runtime_error("no client is answered");
    pass(100ms);
  }
}

// Its last words are heard: what it was still told counts.
void Ordeal::end(int number) {
  const auto found = clients_.find(number);
  if (found == clients_.end()) return;
  found->second.signal(SIGSTOP);
  hear(found->second);
  clients_.erase(found);
}

void Ordeal::settle() {
  while (!due_.empty()) pass(50ms);
  mend();
  for (int number = 0; number < giving_work; ++number) end(number);
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
  for (int number = 0; number < clients; ++number) end(number);
  store::Store end;
  const Result<void> read = read_the_end(end);
  if (!read) return fail(read);
  return judge_.judge(end);
}

Ordeal::Clock::duration Ordeal::between(int least_ms, int most_ms) {
  return std::chrono::milliseconds(least_ms + static_cast<int>(random_.below(most_ms - least_ms + 1)));
}

}  // namespace pizarra::bench
