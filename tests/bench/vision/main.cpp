// pizarra-bench-vision: the eyes against their goals, and the detectors of tags that are installed.

#include <CLI/CLI.hpp>
#include <array>
#include <fmt/format.h>

#include "programs/command_line/command_tools.hpp"
#include "tests/bench/vision/rows.hpp"

namespace {

struct Row {
  const char* name;
  void (*measure)(pizarra::bench::VisionBench&);
};

using namespace pizarra::bench;
constexpr std::array table = {Row{"find", find_time},      Row{"track", track_time},        Row{"tags", tag_time},
                              Row{"scenes", recall},       Row{"solids", solids},           Row{"unlearned", unlearned},
                              Row{"depth", depth},         Row{"orientation", orientation}, Row{"sequences", sequences},
                              Row{"covering", coverings},  Row{"arrival", arrival},         Row{"computing", computing},
                              Row{"memory", agent_memory}, Row{"photographs", photographs}, Row{"films", films}};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("The eyes' speed and precision on rendered scenes, beside ArUco and AprilTag on tags of the same size.",
               "pizarra bench vision");
  bool json = false;
  std::vector<std::string> only;
  std::vector<std::string> names;
  std::uint64_t seed = 1;
  int scenes = 10000;
  int runs = 1000;
  int photograph_scenes = 40;
  int film_count = 4;
  std::string photograph_folder;
  for (const Row& row : table) names.emplace_back(row.name);
  app.add_flag("--json", json, "one JSON object a line");
  app.add_option("--only", only, "these rows alone")->check(CLI::IsMember(names))->type_name("ROW");
  app.add_option("--scenes", scenes, "random scenes to find the marks in")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--runs", runs, "sequences of either kind to track them through")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--photographs", photograph_scenes, "scenes of each condition to photograph")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app.add_option("--films", film_count, "films of ten seconds, every second one by a pair")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option(
         "--photograph-folder", photograph_folder,
         "where photographs are, or are to be made and kept, and films in FOLDER-films; without it they are removed "
         "afterwards")
      ->type_name("FOLDER");
  app.add_option("--seed", seed, "what the scenes, the camera, its noise and what is learned are drawn from")
      ->check(pizarra::programs::seed_check())
      ->capture_default_str();
  app.footer(
      "Row scenes has clutter that is not solid and convex; row solids has such things as well.\n"
      "Status 0 when every figure was measured, short or not; 1 when one was not; 2 for wrong arguments.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  cv::setNumThreads(1);
  pizarra::bench::Figures figures("vision",
                                  json ? pizarra::bench::Figures::Style::json : pizarra::bench::Figures::Style::plain);
  set_scene_seed(seed);
  VisionBench bench{figures,           tag_detectors(), learn_marks(seed), seed, scenes, runs,
                    photograph_scenes, film_count,      photograph_folder};
  for (const Row& row : table) {
    if (!only.empty() && std::ranges::find(only, row.name) == only.end()) continue;
    try {
      row.measure(bench);
    } catch (const std::exception& error) {
      fmt::print(stderr, "pizarra bench vision: {}: {}\n", row.name, error.what());
      figures.say({row.name, {}, "", {}, {}, error.what()});
    }
  }
  return figures.finish();
}
