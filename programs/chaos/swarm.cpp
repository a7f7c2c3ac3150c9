#include "programs/chaos/swarm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>

#include "programs/story/seed_pool.hpp"

namespace pizarra::chaos {

namespace {

constexpr int most_shrinking_runs = 40;
// Of this machine's time, however loaded it is. The cell's own time bounds each run.
constexpr std::chrono::seconds longest_run(600);

struct Outcome {
  RunResult result;
  std::vector<std::size_t> fewest;
  std::size_t faults = 0;
  bool shrunk = false;
};

bool has_failed(const RunResult& result) { return result.kind == RunResult::Kind::failed; }

RunResult play_quietly(const ChaosStory& story, const PlayOptions& options) {
  story::Narrator narrator(stdout, story::Narrator::Style::silent);
  const Result<RunResult> played = play(story, options, narrator);
  if (played) return *played;
  RunResult failed;
  failed.why = describe(played.error());
  return failed;
}

// As a worker says it: a line of numbers, the reason, the faults that fail, the coverage.
std::string word_of(const Outcome& outcome) {
  const RunResult& r = outcome.result;
  std::string why = r.why;
  for (char& c : why) c = c == '\n' ? ' ' : c;
  return fmt::format("{} {} {} {:.3f} {:.3f} {} {}\n{}\n{}\n{}", static_cast<int>(r.kind), r.hung ? 1 : 0,
                     r.unsafe.size(), r.cell_s, r.cpu_s, outcome.shrunk ? 1 : 0, outcome.faults, why,
                     fmt::join(outcome.fewest, ","), r.coverage.text());
}

struct Heard {
  RunResult result;
  bool shrunk = false;
  std::size_t faults = 0;
  std::string fewest;
};

Heard heard_from(const story::SeedPool::Answer& answer) {
  Heard heard;
  if (!answer.trouble.empty()) {
    heard.result.why = answer.trouble;
    heard.result.hung = answer.overdue;
    return heard;
  }
  int kind = 0;
  int hung = 0;
  int shrunk = 0;
  std::size_t unsafe = 0;
  int read = 0;
  std::sscanf(answer.text.c_str(), "%d %d %zu %lf %lf %d %zu\n%n", &kind, &hung, &unsafe, &heard.result.cell_s,
              &heard.result.cpu_s, &shrunk, &heard.faults, &read);
  const std::size_t why_begins = answer.text.find('\n') + 1;
  const std::size_t fewest_begin = answer.text.find('\n', why_begins) + 1;
  const std::size_t points_begin = answer.text.find('\n', fewest_begin) + 1;
  heard.result.kind = static_cast<RunResult::Kind>(kind);
  heard.result.hung = hung != 0;
  heard.result.unsafe.resize(unsafe);
  heard.result.why = answer.text.substr(why_begins, fewest_begin - 1 - why_begins);
  heard.fewest = answer.text.substr(fewest_begin, points_begin - 1 - fewest_begin);
  heard.shrunk = shrunk != 0;
  heard.result.coverage = Coverage::from_text(answer.text.substr(points_begin));
  return heard;
}

void count(Tally& tally, const RunResult& result) {
  ++tally.runs;
  if (result.kind == RunResult::Kind::reached) ++tally.reached;
  if (result.kind == RunResult::Kind::refused) ++tally.refused;
  if (has_failed(result)) ++tally.failed;
  if (!result.unsafe.empty()) ++tally.unsafe;
  if (result.hung) ++tally.hung;
  tally.cell_s += result.cell_s;
  tally.cpu_s += result.cpu_s;
  tally.coverage.add(result.coverage);
}

}  // namespace

std::vector<std::size_t> shrink(const ChaosStory& story, const std::string& plant) {
  std::vector<std::size_t> fewest(story.faults.size());
  std::iota(fewest.begin(), fewest.end(), 0);
  int runs = 0;
  for (std::size_t part = (fewest.size() + 1) / 2; part > 0;) {
    bool smaller = false;
    for (std::size_t from = 0; from < fewest.size() && runs < most_shrinking_runs;) {
      std::vector<std::size_t> without = fewest;
      const std::size_t to = std::min(from + part, without.size());
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(from),
                    without.begin() + static_cast<std::ptrdiff_t>(to));
      ++runs;
      if (has_failed(play_quietly(story, {.faults = without, .plant = plant}))) {
        fewest = without;
        smaller = true;
      } else {
        from += part;
      }
    }
    if (!smaller || part > 1) part = part == 1 ? 0 : (part + 1) / 2;
    if (runs >= most_shrinking_runs) break;
  }
  return fewest;
}

Tally run_swarm(const SwarmOptions& options, std::FILE* out) {
  const auto work = [&](std::uint64_t seed) {
    const ChaosStory story = draw_story(options.cell, seed, options.only);
    Outcome outcome{
        .result = play_quietly(story, {.plant = options.plant}), .fewest = {}, .faults = story.faults.size()};
    if (options.shrink && has_failed(outcome.result)) {
      outcome.fewest = shrink(story, options.plant);
      outcome.shrunk = true;
    }
    return word_of(outcome);
  };
  Tally tally;
  story::SeedPool pool({.first = options.first_seed,
                        .seeds = options.runs,
                        .jobs = options.jobs,
                        .longest = (options.shrink ? most_shrinking_runs : 1) * longest_run},
                       work);
  const story::SeedPool::End end = pool.run([&](std::uint64_t seed, const story::SeedPool::Answer& answer) {
    const Heard heard = heard_from(answer);
    count(tally, heard.result);
    const std::vector<std::string> special = special_about(draw_story(options.cell, seed, options.only).cell);
    const std::string of = special.empty() ? "" : fmt::format("  ({})", fmt::join(special, ", "));
    fmt::print(out, "seed {:6}  {}{}\n", seed, line_of(heard.result), of);
    if (has_failed(heard.result)) {
      const std::string fewest = heard.fewest.empty() ? "none" : heard.fewest;
      const std::string faults = heard.shrunk ? " --faults " + fewest : "";
      fmt::print(out, "             ./pizarra chaos --replay {}{}{}\n", seed, options.replay_with, faults);
    }
    std::fflush(out);
    return !options.stop_at_failure || !has_failed(heard.result);
  });
  tally.whole = end == story::SeedPool::End::heard;
  return tally;
}

PlantSearch find_plant(const SwarmOptions& options) {
  const auto work = [&](std::uint64_t seed) -> std::string {
    const ChaosStory story = draw_story(options.cell, seed, options.only);
    const bool fails = has_failed(play_quietly(story, {.plant = options.plant}));
    return fails && !has_failed(play_quietly(story, {})) ? "found" : "not";
  };
  PlantSearch search;
  story::SeedPool pool(
      {.first = options.first_seed, .seeds = options.runs, .jobs = options.jobs, .longest = 2 * longest_run}, work);
  const story::SeedPool::End end = pool.run([&](std::uint64_t seed, const story::SeedPool::Answer& answer) {
    // A plant that brings a whole run down is found too.
    const bool is_found = answer.text == "found" || !answer.trouble.empty();
    if (is_found) search.found_by = seed - options.first_seed + 1;
    return !is_found;
  });
  search.whole = end == story::SeedPool::End::heard;
  return search;
}

std::string last_line(const Tally& tally) {
  return fmt::format("chaos runs {} reached {} refused {} failed {} unsafe {} hung {} unreached {}", tally.runs,
                     tally.reached, tally.refused, tally.failed, tally.unsafe, tally.hung,
                     tally.coverage.unreached().size());
}

bool passes(const Tally& tally) { return tally.unsafe == 0 && 100 * tally.failed <= tally.runs; }

}  // namespace pizarra::chaos
