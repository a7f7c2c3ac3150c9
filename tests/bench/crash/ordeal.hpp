#pragma once

// A board and its clients, and what is done to them: killed, stopped, cut off, a fault a round.
//
//   Ordeal ordeal(folder, seed, is_stopped);  // throws Stopped wherever that becomes true
//   for (int round = 0; round < rounds; ++round) ordeal.round();
//   ordeal.settle();                          // nobody is harmed any more, and every item becomes an effect
//   Result<Verdict> verdict = ordeal.judge();

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>

#include "blackboard/time/random.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/crash/judge.hpp"

namespace pizarra::bench {

struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

class Ordeal {
 public:
  using Clock = std::chrono::steady_clock;
  Ordeal(std::string folder, std::uint64_t seed, std::function<bool()> is_stopped);

  void round();
  void settle();
  Result<Verdict> judge();

 private:
  static constexpr int clients = 8;
  static constexpr int writers = 3;  // the first of them
  struct Role {
    void (*run)(const std::string& address, int who, int reports);
    int link;
  };

  static Child start_links(const std::string& folder);
  void start_board();
  void start_client(int number);
  void harm(std::uint64_t kind);
  void stop_for(std::function<Child*()> whom, Clock::duration time);
  void later(Clock::duration time, std::function<void()> what);
  // Listens to the clients and does what is due.
  void pass(Clock::duration time);
  void hear(Child& client);
  Clock::duration between(int least_ms, int most_ms);

  const std::string folder_;
  const std::function<bool()> is_stopped_;
  Random random_;
  Judge judge_;
  Child links_;
  std::optional<Child> board_;
  std::map<int, Child> clients_;
  std::multimap<Clock::time_point, std::function<void()>> due_;
  int next_who_ = 1;
  Clock::time_point absent_until_{};  // one client, longer than its session lasts
};

}  // namespace pizarra::bench
