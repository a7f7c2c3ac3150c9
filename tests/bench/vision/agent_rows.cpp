// What a whole vision agent computes from a frame's arrival to the fact that says what was seen in it, on a board in its
// own process.

#include <ctime>
#include <fmt/format.h>

#include "agents/runtime/service.hpp"
#include "agents/vision/agent/vision_agent.hpp"
#include "agents/vision/memory/object_database.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/vision/rows.hpp"
#include "tests/run_task.hpp"

namespace pizarra::bench {
namespace {

constexpr Duration between_frames = 2ms;
constexpr int frames = 1500;
constexpr int first_counted = 100;
constexpr Duration patience = 60s;

// What this thread has computed so far, us: all that happens between two looks at it happens on this thread.
double thread_us() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

std::shared_ptr<const Image> as_image(const cv::Mat1b& mat) {
  return std::make_shared<Image>(Image{mat.cols, mat.rows, 1, {mat.datastart, mat.dataend}});
}

// Shows five marks that move to and fro, and notes when each frame came.
class MovingMarks : public StereoCamera {
 public:
  MovingMarks(Executor& executor, std::uint64_t seed) : executor_(executor) {
    Random random(seed);
    for (const double step : {0.0, 1.3, 3.1, 4.7, 3.6, 1.8}) {
      Scene scene = learning_scene();
      scene.noise = 5;
      for (SceneMark& mark : scene.marks) mark.centre += cv::Point2d(-step, 0.5 * step);
      lefts_.push_back(as_image(draw(scene, Side::left, random)));
      rights_.push_back(as_image(draw(scene, Side::right, random)));
    }
  }
  Task<Result<StereoModel>> open() override { co_return scene_camera(); }
  Task<Result<StereoFrame>> next(std::uint64_t after, bool) override {
    co_await sleep(executor_, between_frames);
    StereoFrame frame;
    frame.number = after + 1;
    frame.captured = executor_.now();
    frame.left = lefts_[frame.number % lefts_.size()];
    frame.right = rights_[frame.number % rights_.size()];
    arrival_us[frame.number] = thread_us();
    co_return frame;
  }
  std::map<std::uint64_t, double> arrival_us;

 private:
  Executor& executor_;
  std::vector<std::shared_ptr<const Image>> lefts_;
  std::vector<std::shared_ptr<const Image>> rights_;
};

struct Latencies {
  std::vector<double> track_us;  // frame to fact
  std::vector<double> board_us;  // the same fact, told by somebody who has nothing to see
};

Task<Result<void>> measure(AgentContext& context, const std::vector<std::string>& names, const MovingMarks& camera,
                           Latencies& out) {
  Service service(context, contract_from_text(R"((contract bench
    (posts (relation bench-says ((frame integer) (text string)) (key)))))")
                               .value());
  const Result<void> started = co_await service.start();
  if (!started) co_return fail(started);
  Caller caller(context, service);
  for (const std::string& name : names) {
    const Datum operation = list("track"_sym, name);
    const Result<Datum> tracked = co_await caller.call("vision", operation, patience);
    if (!tracked) co_return fail(tracked);
  }
  const Query said = query_for(list("vision-says"_sym, "vision"_sym, "?frame"_sym, "?text"_sym));
  const Query echoed = query_for(list("bench-says"_sym, "?frame"_sym, "?text"_sym));
  const Result<std::unique_ptr<Watch>> words = co_await context.board.watch(said);
  const Result<std::unique_ptr<Watch>> echoes = co_await context.board.watch(echoed);
  const Result<Change> nothing_yet = co_await (*echoes)->next();
  if (!nothing_yet) co_return fail(nothing_yet);
  while (out.track_us.size() < frames) {
    const Result<Change> change = co_await (*words)->next();
    const double seen_us = thread_us();
    if (!change) co_return fail(change);
    if (change->added.empty()) continue;
    const Datum fact = change->added.back().facts.front().datum;
    if (fact[3].text().find("FAIL") != std::string_view::npos) co_return fail("not-measured", "a mark was lost");
    out.track_us.push_back(seen_us - camera.arrival_us.at(static_cast<std::uint64_t>(fact[2].integer())));
    const Datum echo = list("bench-says"_sym, fact[2], fact[3]);
    const double before_us = thread_us();
    const Result<Revision> told = co_await context.board.tell(echo);
    const Result<Change> heard = co_await (*echoes)->next();
    if (!told || !heard) co_return fail("not-measured", "the board did not answer");
    out.board_us.push_back(thread_us() - before_us);
  }
  co_return Result<void>();
}

std::string objects_folder(const TemporaryFolder& folder, const LearnedObjects& marks) {
  const std::string path = folder.path() + "/objects";
  ObjectDatabase database = ObjectDatabase::open(path).value();
  for (const LearnedObject& object : marks.all()) {
    const Result<std::int64_t> kept = database.apply(KeepSample{object.name, object.samples.front()});
    if (!kept) throw std::runtime_error(describe(kept.error()));
  }
  return path;
}

Task<void> live(Agent& agent) {
  // That it ended early shows in what is measured.
  [[maybe_unused]] const Result<void> ended = co_await agent.run();
}

}  // namespace

void arrival(VisionBench& bench) {
  const TemporaryFolder folder;
  RealExecutor executor;
  MemoryBoard board(executor);
  MovingMarks camera(executor, bench.seed);
  const std::unique_ptr<Board> eyes = board.view("vision");
  const std::unique_ptr<Board> ears = board.view("bench");
  VisionAgent vision({"vision", "here", executor, *eyes, Random(1)}, camera, nullptr,
                     {objects_folder(folder, bench.marks)});
  AgentContext context{"bench", "here", executor, *ears, Random(2)};
  std::vector<std::string> names;
  for (const LearnedObject& object : bench.marks.all()) names.push_back(object.name);
  Latencies latencies;
  {
    const Job running = executor.spawn(live(vision));
    const Result<void> measured = run(executor, measure(context, names, camera, latencies));
    if (!measured) throw std::runtime_error(describe(measured.error()));
  }
  const auto counted = [](const std::vector<double>& all) {
    return std::span(all).subspan(std::min<std::size_t>(first_counted, all.size()));
  };
  const double board_ms = 1e-3 * percentile(counted(latencies.board_us), 0.99);
  bench.figures.say({"frame's arrival to track fact, p99",
                     1e-3 * percentile(counted(latencies.track_us), 0.99),
                     "ms",
                     at_most(1 + board_ms, fmt::format("<= 1 and the board's own p99, {:.3f}", board_ms)),
                     {{"the fact alone", board_ms}},
                     fmt::format("five objects, {} frames, what one thread computes: no capture thread, no "
                                 "socket and no waiting; median {:.3f}",
                                 frames, 1e-3 * percentile(counted(latencies.track_us), 0.5))});
}

}  // namespace pizarra::bench
