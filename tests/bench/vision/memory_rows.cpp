// The memory of a vision agent's process that has learned four objects and tracks them: with the simulated camera, with
// image files, and with a film, which brings FFmpeg along.

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <zmq.hpp>

#include "agents/runtime/caller.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "drivers/simulation/socket_link.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/vision/rows.hpp"
#include "tests/run_task.hpp"

namespace pizarra::bench {
namespace {

constexpr Duration patience = 60s;
constexpr double goal_mb = 80;

// Where an object is to be clicked on, px.
struct Place {
  std::string name;
  Datum x;
  Datum y;
};

Task<Result<void>> learn_and_track(runtime::AgentContext& context, std::vector<Place> places) {
  runtime::Service service(context, runtime::contract_from_text("(contract bench)").value());
  const Result<void> started = co_await service.start();
  if (!started) co_return fail(started);
  runtime::Caller caller(context, service);
  for (const Place& place : places) {
    const Datum learn = list("learn"_sym, place.x, place.y, place.name);
    const Result<Datum> learned = co_await caller.call("vision", learn, patience);
    if (!learned) co_return fail(learned);
    if ((*learned)[0].text().find("OK") == std::string_view::npos) {
      co_return fail("not-learned", place.name + " was not learned");
    }
  }
  for (const Place& place : places) {
    const Datum track = list("track"_sym, place.name);
    const Result<Datum> tracked = co_await caller.call("vision", track, patience);
    if (!tracked) co_return fail(tracked);
  }
  co_await sleep(context.executor, 2s);
  co_return Result<void>();
}

Task<Result<std::vector<Place>>> places_of_cubes(simulation::SocketLink& world) {
  std::vector<Place> out;
  const std::vector<std::string> names{"circle", "triangle", "cross", "square"};
  for (const std::string& name : names) {
    const Datum question = list("where-seen"_sym, name);
    const Result<simulation::Message> place = co_await world.call(question, patience);
    if (!place) co_return fail(place);
    out.push_back({name, place->head[0], place->head[1]});
  }
  co_return out;
}

std::vector<Place> places_of_marks(const Scene& scene) {
  std::vector<Place> out;
  for (const SceneMark& mark : scene.marks) {
    if (mark.name == "end-effector") continue;
    out.push_back({mark.name, to_datum(static_cast<int>(mark.centre.x)), to_datum(static_cast<int>(mark.centre.y))});
  }
  return out;
}

template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(describe(result.error()));
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

void say_memory(VisionBench& bench, const std::string& camera, const Child& vision) {
  const double all_mb = vision.memory_mb("VmHWM");
  const double own_mb = vision.memory_mb("RssAnon");
  bench.figures.say({"memory of the agent, peak, " + camera,
                     all_mb,
                     "MB",
                     at_most(goal_mb),
                     {},
                     fmt::format("{:.0f} of it its own, the rest pages of shared libraries; a process of its own, four "
                                 "objects learned and tracked",
                                 own_mb),
                     fmt::format("{:.0f} MB of pages of shared libraries", all_mb - own_mb)});
}

// A cell's file, a board, and where they are.
struct CellOnDisk {
  TemporaryFolder folder;
  std::string cell = folder.path() + "/cell.scm";
  std::string board_at = "ipc://" + folder.path() + "/board";
  Child board = Child::program({program_beside("pizarra-board"), "--listen", board_at});

  explicit CellOnDisk(const std::string& text) { std::ofstream(cell) << text; }
};

void simulated(VisionBench& bench) {
  const CellOnDisk there(
      "(cell bench (world (cube circle (at 450 -150)) (cube triangle (at 450 -50)) "
      "(cube cross (at 450 50)) (cube square (at 450 150))))");
  const std::string world_at = "ipc://" + there.folder.path() + "/world";
  const std::string program = program_beside("pizarra-agent");
  const Child world = Child::program({program, "world", there.cell, "--listen", world_at});
  const Child vision =
      Child::program({program, "agent", "vision", there.cell, "--board", there.board_at, "--world", world_at});
  RealExecutor executor;
  zmq::context_t sockets(1);
  {
    const std::unique_ptr<client::RemoteBoard> view =
        client::RemoteBoard::connect(executor, there.board_at, "bench").value();
    simulation::SocketLink link(executor, sockets, world_at);
    runtime::AgentContext context{"bench", "here", executor, *view, Random(1)};
    const std::vector<Place> places = value_of(run(executor, places_of_cubes(link)));
    value_of(run(executor, learn_and_track(context, places)));
  }
  say_memory(bench, "simulated camera", vision);
}

void own(VisionBench& bench, const std::string& camera, const std::string& source,
         const std::function<void(const std::string& folder, const Scene& scene)>& write) {
  const CellOnDisk there("(cell bench (camera (single " + source +
                         ") (rate 30)) (host \"localhost\" (agents vision)))");
  const Scene scene = learning_scene();
  write(there.folder.path(), scene);
  const Child vision =
      Child::program({program_beside("pizarra-agent"), "agent", "vision", there.cell, "--board", there.board_at});
  RealExecutor executor;
  {
    const std::unique_ptr<client::RemoteBoard> view =
        client::RemoteBoard::connect(executor, there.board_at, "bench").value();
    runtime::AgentContext context{"bench", "here", executor, *view, Random(1)};
    value_of(run(executor, learn_and_track(context, places_of_marks(scene))));
  }
  say_memory(bench, camera, vision);
}

void pictures(VisionBench& bench) {
  own(bench, "image files", "(images \"shots\")", [&](const std::string& folder, const Scene& scene) {
    std::filesystem::create_directory(folder + "/shots");
    Random random(bench.seed);
    for (const char* file : {"1.png", "2.jpg", "3.png", "4.jpg", "5.png"}) {
      cv::imwrite(folder + "/shots/" + file, draw(scene, Side::left, random));
    }
  });
}

void film(VisionBench& bench) {
  own(bench, "a film", "(video \"film.avi\")", [&](const std::string& folder, const Scene& scene) {
    constexpr int frames = 30;
    Random random(bench.seed);
    cv::VideoWriter writer;
    for (int i = 0; i < frames; ++i) {
      cv::Mat image;
      cv::cvtColor(draw(scene, Side::left, random), image, cv::COLOR_GRAY2BGR);
      if (i == 0) writer.open(folder + "/film.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 30, image.size());
      writer.write(image);
    }
  });
}

}  // namespace

void agent_memory(VisionBench& bench) {
  simulated(bench);
  pictures(bench);
  film(bench);
}

}  // namespace pizarra::bench
