#pragma once

// One run of a drawn story, from its cell's beginning to what became of its goals.
//
//   Result<RunResult> result = play(story, {.faults = {0, 3}}, narrator);     // of its faults these alone
//   result->kind; result->line; result->unsafe;
//
// After the fault phase all is well and nobody interferes: within `patience` a goal has then ended, or the run hangs.

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "programs/chaos/coverage.hpp"
#include "programs/chaos/draw_story.hpp"
#include "programs/story/narrator.hpp"

namespace pizarra::chaos {

// Taking a tower of four down and building another takes 8 operations of some 10 s each; each of them may fail once,
// and what hides behind something is looked for. Each cube beyond five has two operations more.
constexpr Duration patience(std::size_t cubes) {
  constexpr std::size_t usual_cubes = 5;
  return 180s + 40s * static_cast<int>(std::max(cubes, usual_cubes) - usual_cubes);
}

struct RunResult {
  enum class Kind : std::uint8_t { reached, refused, failed };
  Kind kind = Kind::failed;
  bool hung = false;
  std::vector<std::string> unsafe;
  std::string why;  // it failed, or what was refused
  double cell_s = 0;
  double cpu_s = 0;
  Coverage coverage;

  bool has_failed() const { return kind == Kind::failed; }
};

struct PlayOptions {
  std::optional<std::vector<std::size_t>> faults = {};  // none: all
  std::string film_file = {};
  std::string plant = {};  // plants.hpp
};

// Failures: those of the cell's domain, and of writing the film.
Result<RunResult> play(const ChaosStory& story, const PlayOptions& options, story::Narrator& narrator);
// The same, and prints nothing. A story that cannot be played counts as a failed run.
RunResult play_quietly(const ChaosStory& story, const PlayOptions& options);
// Of this machine's time, however loaded it is. The cell's own time bounds each run.
constexpr std::chrono::seconds longest_run(600);

// "reached", "refused", "failed"; for people.
std::string line_of(const RunResult& result);

}  // namespace pizarra::chaos
