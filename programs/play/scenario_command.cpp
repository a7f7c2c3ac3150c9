#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/play/play_commands.hpp"
#include "programs/story/scenario_run.hpp"

namespace pizarra::programs {

namespace {

struct ScenarioChoices {
  std::vector<std::string> files;
  std::optional<std::uint64_t> seed;
  std::string journal;
  bool quiet = false;
  bool json = false;
};

int run_one(const std::string& file, const ScenarioChoices& choices, const StopSignals& signals) {
  const Result<forms::Scenario> scenario = forms::read_scenario_file(file);
  if (!scenario) return complain(scenario.error(), exit_usage);
  const Result<forms::CellDescription> cell = story::cell_of(*scenario);
  if (!cell) return complain(cell.error(), exit_usage);
  story::StoryOptions options;
  options.seed = choices.seed.value_or(scenario->seed);
  options.journal_file = choices.journal;
  options.stop = &signals;
  const auto style = choices.quiet ? story::Narrator::Style::silent : story::Narrator::style_for(stdout, choices.json);
  story::Narrator narrator(stdout, style);
  const Result<story::StoryReport> report = story::run_story(*scenario, *cell, options, narrator);
  if (!report) return complain(report.error(), report.error().symbol == "cannot-write" ? exit_unavailable : exit_usage);
  if (report->interrupted) {
    fmt::print(stderr, "pizarra: interrupted in {}\n", text_of_bytes(file));
    return exit_interrupted;
  }
  const std::vector<std::string>& unmet = report->director.unmet;
  const double cell_s = static_cast<double>(report->director.took.count()) / 1e6;
  const char* word = unmet.empty() ? "as told" : "OTHERWISE";
  if (choices.json) {
    fmt::print("{{\"scenario\":{},\"seed\":{},\"as_told\":{},\"time_s\":{:.1f}}}\n", json_string(scenario->name),
               options.seed, unmet.empty(), cell_s);
  } else {
    fmt::print("{:<9}  seed {}  {:6.1f} s  {:5.1f}x  {}\n", word, options.seed, cell_s, report->speed(),
               scenario->name);
  }
  for (const std::string& sentence : unmet) fmt::print("           {}\n", sentence);
  return unmet.empty() ? exit_reached : exit_failed;
}

}  // namespace

void add_scenario_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<ScenarioChoices>();
  CLI::App* word = app.add_subcommand("scenario", "Play scenario files in virtual time and check how they end.");
  word->add_option("FILE", choices->files, "Scenario files")->required()->check(CLI::ExistingFile);
  word->add_option("--seed", choices->seed, "Use this seed instead of the scenario's")->check(seed_check());
  word->add_option("--journal", choices->journal, "Write every committed transaction of the last story to this file");
  word->add_flag("--quiet", choices->quiet, "Print only how each story ended");
  word->add_flag("--json", choices->json, "Print one JSON object a line");
  word->footer(help_footer("scenario tests/scenarios/01-undisturbed.scm"));
  word->callback([choices, &status] {
    const StopSignals signals;
    for (const std::string& file : choices->files) {
      status = std::max(status, run_one(file, *choices, signals));
      if (status == exit_interrupted) break;
    }
  });
}

}  // namespace pizarra::programs
