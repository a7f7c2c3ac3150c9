// The time from a frame's arrival in a vision agent's process until a watch in another process gets the fact of it. The
// fact goes over a board server's socket; the clock is the wall clock.

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <thread>

#include "agents/vision/agent/vision_agent.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "drivers/camera/video_camera.hpp"
#include "tests/bench/vision/agent_latency.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int frames_per_s = 120;

// The same in all processes of the machine.
double now_us() { return std::chrono::duration<double, std::micro>(Clock::now().time_since_epoch()).count(); }

// A device that shows the moving marks, both images side by side, and says when the capture thread had each.
class MovingMarks : public camera::FrameSource {
 public:
  MovingMarks(std::uint64_t seed, Pipe& arrivals) : arrivals_(arrivals) {
    for (const Shot& shot : moving_marks(seed)) cv::hconcat(shot.left, shot.right, shots_.emplace_back());
  }
  Result<void> open() override {
    due_ = Clock::now();
    return {};
  }
  void close() override {}
  Result<std::optional<double>> grab() override {
    due_ = std::max(due_ + std::chrono::microseconds(1'000'000 / frames_per_s), Clock::now());
    std::this_thread::sleep_until(due_);
    arrived_us_ = now_us();
    return std::nullopt;
  }
  // Those that are retrieved are numbered, from 1.
  Result<cv::Mat> retrieve(bool /*grey*/) override {
    arrivals_.say(arrived_us_);
    return shots_[++retrieved_ % shots_.size()];
  }
  double recorded_hz() const override { return 0; }

 private:
  Pipe& arrivals_;
  std::vector<cv::Mat> shots_;
  Clock::time_point due_;
  double arrived_us_ = 0;
  std::size_t retrieved_ = 0;
};

Task<void> live(runtime::Agent& agent) {
  const Result<void> ended = co_await agent.run();
  if (!ended) throw std::runtime_error(describe(ended.error()));
}

// An agent as a cell runs it, but for its camera.
void be_the_eyes(Pipe& parent, const std::string& board_at, const std::string& objects, std::uint64_t seed) {
  RealExecutor executor;
  const std::unique_ptr<client::RemoteBoard> board = client::RemoteBoard::connect(executor, board_at, "vision").value();
  const forms::CameraSetup setup{.arrangement = forms::CameraSetup::Arrangement::side_by_side,
                                 .sources = {{forms::CameraSource::Kind::device, "moving marks"}},
                                 .focal_px = scene_camera().focal_px,
                                 .base_line_mm = scene_camera().base_line_mm};
  camera::VideoCamera camera(executor, setup, [&] {
    camera::StereoReader::Sources out;
    out.push_back(std::make_unique<MovingMarks>(seed, parent));
    return out;
  });
  vision::VisionAgent vision({"vision", "here", executor, *board, Random(1)}, camera, nullptr, {objects});
  const Job running = executor.spawn(live(vision));
  executor.run_until([&] { return running.done(); });
}

}  // namespace

void arrival(VisionBench& bench) {
  const TemporaryFolder folder;
  const std::string board_at = "ipc://" + folder.path() + "/board";
  Child server = Child::program({program_beside("pizarra-board"), "--listen", board_at});
  server.pipe().hear_line();
  const std::string objects = objects_folder(folder, bench.marks);
  Child eyes = Child::running([&](Pipe& parent) { be_the_eyes(parent, board_at, objects, bench.seed); });
  std::vector<double> arrivals_us;
  const auto arrival_us = [&](std::uint64_t frame) {
    while (arrivals_us.size() < frame) arrivals_us.push_back(eyes.pipe().hear());
    return arrivals_us[frame - 1];
  };
  RealExecutor executor;
  const std::unique_ptr<client::RemoteBoard> board = client::RemoteBoard::connect(executor, board_at, "bench").value();
  const Latencies took = latencies(executor, *board, bench.marks, {now_us, arrival_us});
  const double board_ms = took.board_ms(0.99);
  const double waited_ms = eyes.waited_for_core_ms() / latency_frames;
  bench.figures.say({"frame's arrival to track fact, p99",
                     took.track_ms(0.99),
                     "ms",
                     at_most(1 + board_ms, fmt::format("<= 1 and the board's own p99, {:.3f}", board_ms)),
                     {{"the board alone", board_ms}},
                     fmt::format("five objects, {} frames at {} a second; by the clock on the wall, from the capture "
                                 "thread to another process' watch; medians {:.3f} and {:.3f}",
                                 latency_frames, frames_per_s, took.track_ms(0.5), took.board_ms(0.5)),
                     fmt::format("the machine: ready to run, the threads of the eyes' process waited {:.3f} ms a "
                                 "frame for a core on average; what they compute is the next row",
                                 waited_ms)});
}

}  // namespace pizarra::bench
