// pizarra-bench-coordinator: what one look of the eyes costs, from the eyes' telling it to what is believed of it.
//
// The vision agent's own teller tells looks of cubes that rest on the table, each a little off as a camera's noise has
// it. A coordinator on the same board, in this process and in virtual time, makes of them what it believes. What the
// thread computes for one look is told: the telling, the board and the coordinator, no image.

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "agents/coordinator/geometry/camera_view.hpp"
#include "agents/coordinator/pursue/coordinator_agent.hpp"
#include "agents/vision/agent/look_teller.hpp"
#include "agents/vision/agent/vision_contract.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/bench/figures.hpp"
#include "tests/bench/measure.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::bench {
namespace {

constexpr int first_counted = 50;

// The eyes of a cell in which nothing moves.
class StillEyes {
 public:
  StillEyes(VirtualExecutor& executor, Board& board, int cubes)
      : context_{"vision", "here", executor, board, Random(1)}, facts_(context_, service_) {
    service_.emplace(context_, runtime::contract_from_text(vision::vision_contract).value());
    see("end-effector", {400, 0, 476});
    for (int i = 0; i < cubes; ++i) {
      const int row = i / 2;
      see(fmt::format("cube-{}", i), {i % 2 == 0 ? 480.0 : 380.0, -225 + 80.0 * row, 30.0});
    }
  }

  Task<void> begin() {
    const Result<void> started = co_await service_->start();
    if (!started) co_return;
    facts_.begin_anew();
    std::vector<Datum> told;
    told.push_back(list("camera-model"_sym, 320, 240, 431.0, 159.5, 119.5, 90.0));
    co_await facts_.tell(std::move(told));
  }
  Task<void> look() {
    std::vector<vision::TrackSighting> noisy = sightings_;
    for (vision::TrackSighting& sighting : noisy) {
      sighting.captured = context_.executor.now();
      sighting.centre.x += random_.uniform(-0.05, 0.05);
      sighting.centre.y += random_.uniform(-0.05, 0.05);
      sighting.range_mm += random_.uniform(-1, 1);
      sighting.yaw_deg = random_.uniform(-2, 2);
    }
    ++frame_;
    co_await looks_.tell(frame_, noisy);
  }

 private:
  void see(const std::string& name, const Eigen::Vector3d& mark) {
    const coordinator::Sight sight = view_.sight(mark);
    vision::TrackSighting sighting;
    sighting.name = name;
    sighting.seen = true;
    sighting.centre = {sight.x_px, sight.y_px};
    sighting.right_centre = cv::Point2d(sight.x_px - 40, sight.y_px);
    sighting.range_mm = sight.range_mm;
    sighting.range_spread_mm = 0.8;
    sighting.confidence = 0.98;
    sighting.margin = 0.4;
    sightings_.push_back(std::move(sighting));
  }

  runtime::AgentContext context_;
  std::optional<runtime::Service> service_;
  vision::FactTeller facts_;
  vision::LookTeller looks_{facts_};
  coordinator::CameraView view_{{}, {}};
  Random random_{7};
  std::uint64_t frame_ = 0;
  std::vector<vision::TrackSighting> sightings_;
};

Task<void> live(coordinator::CoordinatorAgent& agent) { co_await agent.run(); }

// The thread's computing time for each of so many looks, in seconds; nothing where it does not believe what it sees.
std::vector<double> looks(int cubes, int count) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  const std::unique_ptr<Board> of_eyes = board.view("vision");
  const std::unique_ptr<Board> of_coordinator = board.view("coordinator");
  StillEyes eyes(executor, *of_eyes, cubes);
  const Job begun = executor.spawn(eyes.begin());
  coordinator::CoordinatorOptions options;
  options.domain_file = source_dir() + "/domains/blocks.scm";
  coordinator::CoordinatorAgent agent({"coordinator", "here", executor, *of_coordinator, Random(2)}, options);
  const Job living = executor.spawn(live(agent));
  executor.run_for(1s);
  std::vector<double> took;
  for (int i = 0; i < first_counted + count; ++i) {
    const double seconds = thread_seconds_of([&] {
      const Job look = executor.spawn(eyes.look());
      executor.run_for(90ms);
    });
    if (i >= first_counted) took.push_back(seconds);
    executor.run_for(10ms);
  }
  const Query resting = query_from_datum(read_one("(believed (on-table ?cube))").value()).value();
  const bool believed = board.ask(resting)->answers.size() == static_cast<std::size_t>(cubes);
  return believed ? took : std::vector<double>();
}

void measure(Figures& figures, int cubes, int count) {
  const std::vector<double> took = looks(cubes, count);
  const std::string what = fmt::format("a look of {} object{}", cubes, cubes == 1 ? "" : "s");
  for (const auto& [name, part] : {std::pair("median", 0.5), std::pair("99 %", 0.99)}) {
    std::optional<double> us;
    if (!took.empty()) us = 1e6 * percentile(took, part);
    figures.say({fmt::format("{}, {}", what, name), us, "us", {}});
  }
}

}  // namespace
}  // namespace pizarra::bench

int main(int argc, char** argv) {
  using namespace pizarra;
  CLI::App app("What one look of the eyes costs until it is believed.", "pizarra bench coordinator");
  bool json = false;
  int count = 500;
  app.add_flag("--json", json, "one JSON object a line");
  app.add_option("--looks", count, "that are measured")->check(CLI::Range(10, 100'000))->type_name("N");
  app.footer("Status 0 when every figure was measured; 1 when one was not; 2 for wrong arguments.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  bench::Figures figures("coordinator", json ? bench::Figures::Style::json : bench::Figures::Style::plain);
  for (const int cubes : {1, 4, 12}) bench::measure(figures, cubes, count);
  return figures.finish();
}
