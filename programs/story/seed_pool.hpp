#pragma once

// Runs many seeds, each in a process of its own, some at once: a run that crashes or hangs takes no other with it. The
// answers come in the order of the seeds.
//
//   SeedPool pool({.first = 1, .seeds = 100, .jobs = 2}, [](std::uint64_t seed) { return play(seed); });
//   pool.run([](std::uint64_t seed, const SeedPool::Answer& answer) { fmt::print("{}\n", answer.text); return true; });

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace pizarra::story {

class SeedPool {
 public:
  struct Seeds {
    std::uint64_t first = 1;
    std::uint64_t seeds = 1;
    unsigned jobs = 0;  // 0: one a core
    std::chrono::seconds longest{120};
  };
  struct Answer {
    std::string text;
    std::string trouble;  // why there is no text
    bool overdue = false;
  };
  enum class End { heard, interrupted, no_process };
  using Work = std::function<std::string(std::uint64_t seed)>;
  // False: no more of them.
  using Hear = std::function<bool(std::uint64_t seed, const Answer& answer)>;

  SeedPool(Seeds seeds, Work work);
  // Ends all processes before it returns, also by SIGINT, SIGTERM, SIGHUP and SIGPIPE, which it takes over.
  End run(const Hear& hear);

 private:
  struct Worker {
    std::uint64_t seed;
    pid_t pid;
    int pipe;
    std::chrono::steady_clock::time_point started;
    std::string text;
    bool overdue = false;
  };
  bool start(std::uint64_t seed);
  void read_some();
  void collect(Worker& worker);
  void end_all();

  const Seeds seeds_;
  const Work work_;
  std::size_t jobs_ = 1;
  std::vector<Worker> workers_;
  std::map<std::uint64_t, Answer> answers_;
};

}  // namespace pizarra::story
