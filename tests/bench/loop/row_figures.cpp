#include "tests/bench/loop/row_figures.hpp"

#include <algorithm>
#include <numeric>

#include "tests/bench/measure.hpp"

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

MovingGrips moving_grips(const Runs& runs, double least_mm_s) {
  MovingGrips out;
  std::vector<double> moving;
  for (const Played& run : runs) {
    out.of_grips += static_cast<int>(run.grips_mm_s.size());
    const std::size_t before = moving.size();
    std::ranges::copy_if(run.grips_mm_s, std::back_inserter(moving), [&](double speed) { return speed >= least_mm_s; });
    out.runs += moving.size() > before ? 1 : 0;
  }
  out.grips = static_cast<int>(moving.size());
  out.median_mm_s = percentile(moving, 0.5);
  return out;
}

}  // namespace pizarra::bench
