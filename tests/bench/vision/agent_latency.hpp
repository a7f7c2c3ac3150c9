#pragma once

// How long a vision agent that tracks takes from a frame to the fact that says what was seen in it, by any clock; and
// the board alone, for as much told by somebody who has nothing to see.
//
//   const std::vector<Shot> shots = moving_marks(seed);     // the agent's camera shows these in turn
//   Latencies took = latencies(executor, *board, marks, {now_us, arrival_us});
//
// Before: a vision agent `vision` is on that board, or comes soon, and knows the marks.

#include <functional>

#include "agents/vision/objects/learned.hpp"
#include "blackboard/board.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/vision/scene.hpp"

namespace pizarra::bench {

inline constexpr int latency_frames = 1500;

struct Latencies {
  std::vector<double> track_us;  // frame to fact
  std::vector<double> board_us;  // the same facts alone

  double track_ms(double part) const;  // 0.99: the 99th percentile
  double board_ms(double part) const;
};

struct LatencyClock {
  std::function<double()> now_us;
  std::function<double(std::uint64_t frame)> arrival_us;
};

// Throws where the agent or the board fails, or a mark is lost.
Latencies latencies(Executor& executor, Board& board, const vision::LearnedObjects& marks, const LatencyClock& clock);

// Five marks that go to and fro, at most 5 px from one to the next.
struct Shot {
  cv::Mat1b left;
  cv::Mat1b right;
};
std::vector<Shot> moving_marks(std::uint64_t seed);

// A folder with the database of the marks, for an agent to begin with.
std::string objects_folder(const TemporaryFolder& folder, const vision::LearnedObjects& marks);

}  // namespace pizarra::bench
