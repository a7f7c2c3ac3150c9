#include "programs/story/random_run.hpp"

#include <fmt/format.h>

#include "agents/launcher/agent_factory.hpp"
#include "lisp/writer.hpp"
#include "programs/story/random_story.hpp"
#include "programs/story/scenario_run.hpp"

namespace pizarra::story {

namespace {

std::string facts_text(const std::vector<Datum>& facts) {
  std::string out;
  for (const Datum& fact : facts) out += (out.empty() ? "" : " ") + write(fact);
  return out;
}

RandomResult describe_run(const RandomStory& story, const StoryReport& run) {
  const DirectorReport& report = run.director;
  RandomResult result;
  std::string end = report.outcome;
  if (report.refusal) end += fmt::format(" ({})", report.refusal->symbol);
  if (report.reached()) {
    result.kind = RandomResult::Kind::reached;
  } else if (report.refused_correctly()) {
    result.kind = RandomResult::Kind::refused;
    end += report.possible ? ", a mark was hidden" : ", no plan exists";
  } else if (report.outcome == "reached") {
    end += ", but not so in the world";
  }
  const auto& actions = story.scenario.events.front().actions;
  const double cell_s = static_cast<double>(report.took.count()) / 1e6;
  const std::string_view late = report.events == 0 ? " would have come" : "";
  result.line = fmt::format("{:6.1f} s  {:4.1f}x  {}; goal {}; {}{} after {:.1f} s", cell_s, run.speed(), end,
                            facts_text(story.scenario.goal), write(actions[1]), late, actions[0][1].number());
  return result;
}

}  // namespace

RandomResult run_random_seed(const std::string& cell_file, const std::string& arm, std::uint64_t seed) {
  RandomResult failed;
  Result<forms::CellDescription> cell = forms::read_cell_file(cell_file);
  if (!cell) return {RandomResult::Kind::unreadable, describe(cell.error())};
  if (!arm.empty()) {
    const Result<void> put = forms::put_arm(*cell, arm);
    if (!put) return {RandomResult::Kind::unreadable, describe(put.error())};
  }
  const Result<simulation::WorldConfig> sound = launcher::world_config(*cell, seed);
  if (!sound) return {RandomResult::Kind::unreadable, describe(sound.error())};
  const Result<forms::Domain> domain = domain_of(*cell);
  if (!domain) return {RandomResult::Kind::unreadable, describe(domain.error())};
  const Result<void> drawable = check_random_cell(*cell, *domain);
  if (!drawable) return {RandomResult::Kind::unreadable, describe(drawable.error())};
  const RandomStory story = random_story_of_seed(*cell, seed);
  Narrator narrator(stdout, Narrator::Style::silent);
  StoryOptions options;
  options.seed = seed;
  options.director.events_may_fail = true;
  const Result<StoryReport> run = run_story(story.scenario, story.cell, options, narrator);
  if (run) return describe_run(story, *run);
  failed.line = describe(run.error());
  return failed;
}

}  // namespace pizarra::story
