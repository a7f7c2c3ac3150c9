#pragma once

// Clients of a board, and what is done to them and to it: killed, stopped, cut off, a fault a round. On which board
// (lone_ordeal.hpp, cluster_ordeal.hpp) and by which faults, those derived from it say.
//
//   LoneOrdeal ordeal(folder, seed, is_stopped);   // throws Stopped wherever that becomes true
//   for (int round = 0; round < rounds; ++round) ordeal.round();
//   ordeal.settle();                               // nobody is harmed any more, and every item becomes an effect
//   Result<Verdict> verdict = ordeal.judge();

#include <chrono>
#include <functional>
#include <map>
#include <stdexcept>

#include "blackboard/time/random.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/crash/judge.hpp"
#include "tests/bench/stopping.hpp"

namespace pizarra::bench {

class Ordeal {
 public:
  using Clock = std::chrono::steady_clock;
  Ordeal(std::uint64_t seed, std::function<bool()> is_stopped) : is_stopped_(std::move(is_stopped)), random_(seed) {}
  Ordeal(const Ordeal&) = delete;
  Ordeal& operator=(const Ordeal&) = delete;
  virtual ~Ordeal() = default;

  virtual void round() = 0;
  void settle();
  Result<Verdict> judge();

 protected:
  static constexpr int clients = 10;
  using Role = void (*)(const std::string& address, int who, int reports);

  // One that runs is killed first.
  void start_client(int number);
  const Child* client(int number) const;
  int some_client() { return static_cast<int>(random_.below(clients)); }
  // Where that client finds the board; it says so in the client's own process, before anything else is done there.
  virtual std::string come_to_the_board(int client) = 0;
  // Everything is whole again.
  virtual void mend() {}
  // The journal or the log, when all clients and boards are gone.
  virtual Result<void> read_the_end(store::Store& store) = 0;

  void stop_for(std::function<const Child*()> whom, Clock::duration time);
  void later(Clock::duration time, std::function<void()> what);
  // Until the clients are answered: a fault before that would try nothing.
  void wait_until_begun();
  // Listens to the clients and does what is due.
  void pass(Clock::duration time);
  Clock::duration between(int least_ms, int most_ms);
  std::uint64_t below(std::uint64_t bound) { return random_.below(bound); }

 private:
  void hear(Child& client);
  void end(int number);

  const std::function<bool()> is_stopped_;
  Random random_;
  Judge judge_;
  std::map<int, Child> clients_;
  std::multimap<Clock::time_point, std::function<void()>> due_;
  int next_who_ = 1;
};

}  // namespace pizarra::bench
