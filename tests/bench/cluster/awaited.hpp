#pragma once

// Waits until some member leads. A round that begins without a leader would kill nobody, and measure nothing.
//
//   awaited([&] { return cell.leading_member(); }, ClusterCell::members, "no member leads", 10s)

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

#include "tests/bench/stopping.hpp"

namespace pizarra::bench {

// Throws `sentence` when `who` has answered `nobody` for the whole of `patience`.
inline std::size_t awaited(const std::function<std::size_t()>& who, std::size_t nobody, const std::string& sentence,
                           std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds between(50);
  const auto end = std::chrono::steady_clock::now() + patience;
  std::size_t found = who();
  while (found == nobody) {
    throw_if_stopped();
    if (std::chrono::steady_clock::now() >= end) throw std::runtime_error(sentence);
    std::this_thread::sleep_for(between);
    found = who();
  }
  return found;
}

}  // namespace pizarra::bench
