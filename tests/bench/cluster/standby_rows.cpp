#include "tests/bench/cluster/standby_rows.hpp"

#include <array>
#include <fmt/format.h>
#include <thread>

#include "tests/bench/cluster/tells.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/stopping.hpp"

namespace pizarra::bench {

namespace {

constexpr int rounds = 3;
constexpr std::size_t most = 2;
constexpr auto at_rest = std::chrono::seconds(2);
// A board that has just begun reads the log first.
constexpr auto until_it_follows = std::chrono::seconds(2);

struct Cost {
  std::vector<double> per_s;
  std::vector<double> cpu_ms;   // of boards and members, for 1000 tells
  std::vector<double> resting;  // of one standby, in hundredths of a core
};

std::vector<std::size_t> standbys_of(const ClusterCell& cell) {
  std::vector<std::size_t> others;
  const std::size_t leads = cell.await_leading_board();
  for (std::size_t number = 0; number < ClusterCell::members; ++number) {
    if (number != leads) others.push_back(number);
  }
  return others;
}

double cpu_of_all(const ClusterCell& cell) {
  double cpu_s = 0;
  for (std::size_t number = 0; number < ClusterCell::members; ++number) {
    for (const Child* child : {cell.board(number), cell.member(number)}) cpu_s += child == nullptr ? 0 : child->cpu_s();
  }
  return cpu_s;
}

void run_standbys(ClusterCell& cell, const std::vector<std::size_t>& others, std::size_t wanted) {
  for (std::size_t i = 0; i < others.size(); ++i) {
    const bool runs = cell.board(others[i]) != nullptr;
    if (i < wanted && !runs) cell.start_board(others[i]);
    if (i >= wanted && runs) cell.kill_board(others[i]);
  }
  std::this_thread::sleep_for(until_it_follows);
  throw_if_stopped();
}

void measure(RealExecutor& executor, client::RemoteBoard& board, const ClusterCell& cell, const Child* standby,
             int count, Cost& cost) {
  const double cpu_before = cpu_of_all(cell);
  const TellTimes told = tells(executor, board, in_flight, count);
  cost.per_s.push_back(told.per_s);
  cost.cpu_ms.push_back((cpu_of_all(cell) - cpu_before) * 1000 / (static_cast<double>(count) / 1000));
  if (standby == nullptr) return;
  const double before = standby->cpu_s();
  std::this_thread::sleep_for(at_rest);
  cost.resting.push_back((standby->cpu_s() - before) / std::chrono::duration<double>(at_rest).count() * 100);
}

}  // namespace

void say_standbys(Figures& figures, RealExecutor& executor, ClusterCell& cell, int count) {
  const auto board = board_for_tells(executor, cell);
  const std::vector<std::size_t> others = standbys_of(cell);
  std::array<Cost, most + 1> costs;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t wanted = 0; wanted <= most; ++wanted) {
      run_standbys(cell, others, wanted);
      measure(executor, *board, cell, wanted == 0 ? nullptr : cell.board(others.front()), count, costs[wanted]);
    }
  }
  run_standbys(cell, others, most);
  // As the other rows have it: boards of the first two hosts.
  if (cell.board(most) != nullptr) cell.kill_board(most);
  for (std::size_t wanted = 0; wanted <= most; ++wanted) {
    const std::string with = wanted == 0 ? "no standby" : fmt::format("{} standb{}", wanted, wanted == 1 ? "y" : "ies");
    figures.say({"durable tells, " + with, percentile(costs[wanted].per_s, 0.5), "facts/s", {}});
    figures.say({"processor time of all boards and members, " + with,
                 percentile(costs[wanted].cpu_ms, 0.5),
                 "ms/1000 tells",
                 {}});
  }
  figures.say({"a standby at rest", percentile(costs[1].resting, 0.5), "% of a core", {}});
}

}  // namespace pizarra::bench
