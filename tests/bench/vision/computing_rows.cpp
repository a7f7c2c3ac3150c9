// The computing time of a whole vision agent from a frame's arrival to the fact of what it shows, on a board in its own
// process: nobody else's work on the same core is counted.

#include <ctime>
#include <fmt/format.h>

#include "agents/vision/agent/vision_agent.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/bench/vision/agent_latency.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr Duration between_frames = 2ms;

// What this thread has computed so far, us: all that happens between two looks at it happens on this thread.
double thread_us() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

std::shared_ptr<const Image> as_image(const cv::Mat& mat) {
  return std::make_shared<Image>(Image{mat.cols, mat.rows, 1, {mat.datastart, mat.dataend}});
}

// Shows the moving marks, and notes what had been computed when each frame came.
class MovingMarks : public camera::StereoCamera {
 public:
  MovingMarks(Executor& executor, std::uint64_t seed) : executor_(executor) {
    for (const Shot& shot : moving_marks(seed)) {
      lefts_.push_back(as_image(shot.left));
      rights_.push_back(as_image(shot.right));
    }
  }
  Task<Result<camera::StereoModel>> open() override { co_return scene_camera(); }
  Task<Result<camera::StereoFrame>> next(Time, bool) override {
    co_await sleep(executor_, between_frames);
    camera::StereoFrame frame;
    frame.number = ++number_;
    frame.captured = executor_.now();
    frame.left = lefts_[frame.number % lefts_.size()];
    frame.right = rights_[frame.number % rights_.size()];
    arrival_us[frame.number] = thread_us();
    co_return frame;
  }
  std::map<std::uint64_t, double> arrival_us;

 private:
  Executor& executor_;
  std::uint64_t number_ = 0;
  std::vector<std::shared_ptr<const Image>> lefts_;
  std::vector<std::shared_ptr<const Image>> rights_;
};

Task<void> live(runtime::Agent& agent) {
  // That it ended early shows in what is measured.
  [[maybe_unused]] const Result<void> ended = co_await agent.run();
}

}  // namespace

void computing(VisionBench& bench) {
  const TemporaryFolder folder;
  RealExecutor executor;
  memory::MemoryBoard board(executor);
  MovingMarks camera(executor, bench.seed);
  const std::unique_ptr<Board> eyes = board.view("vision");
  const std::unique_ptr<Board> ears = board.view("bench");
  vision::VisionAgent vision({"vision", "here", executor, *eyes, Random(1)}, camera, nullptr,
                             {objects_folder(folder, bench.marks)});
  const Job running = executor.spawn(live(vision));
  const Latencies took = latencies(executor, *ears, bench.marks,
                                   {thread_us, [&](std::uint64_t frame) { return camera.arrival_us.at(frame); }});
  bench.figures.say({"frame to track fact, computing alone, p99",
                     took.track_ms(0.99),
                     "ms",
                     {},
                     {{"the facts alone", took.board_ms(0.99)}},
                     fmt::format("five objects, {} frames, what one thread computes: no capture thread, no socket "
                                 "and no waiting; median {:.3f}",
                                 latency_frames, took.track_ms(0.5))});
}

}  // namespace pizarra::bench
