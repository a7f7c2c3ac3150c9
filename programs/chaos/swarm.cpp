#include "programs/chaos/swarm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "programs/chaos/shrink.hpp"
#include "programs/story/seed_pool.hpp"

namespace pizarra::chaos {

namespace {

struct Outcome {
  RunResult result;
  std::vector<std::size_t> fewest;
  std::size_t faults = 0;
  bool shrunk = false;
};

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

}  // namespace

Tally run_swarm(const SwarmOptions& options, std::FILE* out) {
  const auto work = [&](std::uint64_t seed) {
    const ChaosStory story = draw_story(options.cell, seed, options.only);
    Outcome outcome{
        .result = play_quietly(story, {.plant = options.plant}), .fewest = {}, .faults = story.faults.size()};
    if (options.shrink && outcome.result.has_failed()) {
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
    tally.count(heard.result);
    const std::vector<std::string> special = special_about(draw_story(options.cell, seed, options.only).cell);
    const std::string of = special.empty() ? "" : fmt::format("  ({})", fmt::join(special, ", "));
    fmt::print(out, "seed {:6}  {}{}\n", seed, line_of(heard.result), of);
    if (heard.result.has_failed()) {
      const std::string fewest = heard.fewest.empty() ? "none" : heard.fewest;
      const std::string faults = heard.shrunk ? " --faults " + fewest : "";
      fmt::print(out, "             ./pizarra chaos --replay {}{}{}\n", seed, options.replay_with, faults);
    }
    std::fflush(out);
    return !options.stop_at_failure || !heard.result.has_failed();
  });
  tally.whole = end == story::SeedPool::End::heard;
  return tally;
}

}  // namespace pizarra::chaos
