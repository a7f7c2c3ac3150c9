#include "tests/bench/loop/row_figures.hpp"

#include <algorithm>
#include <numeric>

namespace pizarra::bench {

int reached(const Runs& runs) { return static_cast<int>(std::ranges::count_if(runs, &Played::reached)); }

double mean(const std::vector<double>& values) {
  return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double mean_time_s(const Runs& runs) {
  std::vector<double> times;
  for (const Played& run : runs) {
    if (run.reached) times.push_back(run.took_s);
  }
  return mean(times);
}

double mean_speed(const Runs& runs) {
  std::vector<double> values;
  for (const Played& run : runs) {
    if (run.wall_s > 0) values.push_back(run.cell_s / run.wall_s);
  }
  return mean(values);
}

std::vector<double> all(const Runs& runs, std::vector<double> Played::*part) {
  std::vector<double> values;
  for (const Played& run : runs) values.insert(values.end(), (run.*part).begin(), (run.*part).end());
  return values;
}

}  // namespace pizarra::bench
