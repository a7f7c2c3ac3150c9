#include "agents/robot/silence.hpp"

#include <fmt/format.h>

namespace pizarra::robot {

Task<void> Silence::listen() {
  const Duration longest = driver_.longest_silence();
  std::uint64_t heard = driver_.states_heard();
  int silent = 0;
  while (true) {
    // Beats, not the time between them: what keeps this process from running keeps it from hearing, too.
    co_await sleep(executor_, longest / beats);
    ++silent;
    if (driver_.states_heard() != heard) silent = 0;
    heard = driver_.states_heard();
    if (silent < beats) continue;
    silent = 0;
    const std::string sentence = fmt::format("the arm has not told its state for {} ms", longest.count() / 1000);
    tell_({"stopped", sentence, list("silent"_sym, "arm"_sym), {}});
  }
}

}  // namespace pizarra::robot
