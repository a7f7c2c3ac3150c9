#include "tests/bench/measure.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <string>

namespace pizarra::bench {

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double thread_seconds_of(const std::function<void()>& work) {
  const auto used = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = used();
  work();
  return used() - start;
}

std::vector<double> medians_in_turns(int rounds, const std::vector<std::function<void()>>& works) {
  std::vector<std::function<double()>> timed;
  for (const std::function<void()>& work : works) timed.emplace_back([&work] { return seconds_of(work); });
  return medians_of_rounds(rounds, timed);
}

std::vector<double> medians_of_rounds(int rounds, const std::vector<std::function<double()>>& works) {
  std::vector<std::vector<double>> samples(works.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < works.size(); ++i) samples[i].push_back(works[i]());
  }
  std::vector<double> medians;
  for (const std::vector<double>& of_one : samples) medians.push_back(percentile(of_one, 0.5));
  return medians;
}

double percentile(std::span<const double> samples, double fraction) {
  if (samples.empty()) return 0;
  std::vector<double> sorted(samples.begin(), samples.end());
  const auto at = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(sorted.size() - 1) + 0.5);
  std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
  return sorted[static_cast<std::size_t>(at)];
}

double peak_memory_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  }
  return 0;
}

}  // namespace pizarra::bench
