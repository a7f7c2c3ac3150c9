#pragma once

// The traffic of a running board, looked at for a while: who asked whom and was answered when, who told what, who
// watches it, how large and how fast that is.
//
//   LiveLook look(executor, board, connect);
//   Result<method::Traffic> traffic = co_await look.at(60s);
//
// It watches requests and replies, and reads the board's statistics before and after. Then it takes the images of each
// stream for a second. Where it may, it tells a fact of its own to 1, 2, 4, 8 and 16 subscribers, and measures how long
// the last one waits.

#include <functional>
#include <memory>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"
#include "programs/method/journal_traffic.hpp"

namespace pizarra::programs {

class LiveLook {
 public:
  // Another client of the same board, called like this.
  using Connect = std::function<Result<std::unique_ptr<Board>>(const std::string& name)>;
  // Of requests and replies; what comes after these is not counted, and `cut` says so.
  static constexpr std::size_t most_facts = 200'000;
  // The names of all looks begin so. They ask of everything, and are readers of nothing.
  static constexpr std::string_view names_begin = "method-";

  LiveLook(Executor& executor, Board& board, std::string name, Connect connect)
      : executor_(executor), board_(board), name_(std::move(name)), connect_(std::move(connect)) {}

  Task<Result<method::Traffic>> at(Duration duration);
  bool cut() const { return seen_.size() >= most_facts; }

 private:
  using Counts = std::map<std::string, std::map<std::string, std::int64_t>>;  // by relation, by client
  struct SoFar {
    Counts told, taken;
  };

  Task<void> collect(Query query);
  Task<Result<SoFar>> so_far(method::Traffic* with_readers);
  Task<Result<void>> see_agents(method::Traffic& traffic);
  Task<void> see_journeys(method::Traffic& traffic);
  Task<void> see_sizes(method::Traffic& traffic);
  Task<void> see_images(method::Traffic& traffic);
  Task<void> measure_scales(method::Traffic& traffic);
  Task<std::optional<double>> time_to(std::size_t subscribers);

  Executor& executor_;
  Board& board_;
  const std::string name_;
  Connect connect_;
  std::vector<Fact> seen_;
  Time board_time_{};
  std::int64_t probes_ = 0;
};

}  // namespace pizarra::programs
