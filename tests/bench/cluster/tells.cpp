#include "tests/bench/cluster/tells.hpp"

#include <algorithm>

#include "lisp/reader.hpp"
#include "tests/run_task.hpp"

namespace pizarra::bench {

namespace {

Task<void> tell_on(client::RemoteBoard& board, int* left, std::vector<double>* ms) {
  while (*left > 0) {
    const std::int64_t mark = --*left;
    const auto sent = std::chrono::steady_clock::now();
    const Result<Revision> told = co_await board.tell(list("tally"_sym, mark, "some text of a usual length"));
    if (told) ms->push_back(ms_since(sent));
  }
}

}  // namespace

double ms_since(std::chrono::steady_clock::time_point begun) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

std::unique_ptr<client::RemoteBoard> board_for_tells(RealExecutor& executor, const ClusterCell& cell) {
  auto board = client::RemoteBoard::connect(executor, cell.boards(), "bench").value();
  const std::vector<Relation> relations = {
      relation_from_datum(read_one("(relation tally ((n integer) (text string)) (key n) (durable))").value()).value()};
  while (!run(executor, board->declare(relations))) continue;
  (void)tells(executor, *board, in_flight, in_flight);
  return board;
}

TellTimes tells(RealExecutor& executor, client::RemoteBoard& board, int at_once, int all) {
  int left = all;
  TellTimes measured;
  const auto begun = std::chrono::steady_clock::now();
  std::vector<Job> jobs;
  for (int i = 0; i < at_once; ++i) jobs.push_back(executor.spawn(tell_on(board, &left, &measured.ms)));
  executor.run_until([&] { return std::ranges::all_of(jobs, [](const Job& job) { return job.done(); }); });
  measured.per_s = static_cast<double>(measured.ms.size()) / (ms_since(begun) / 1000);
  return measured;
}

}  // namespace pizarra::bench
