#include <filesystem>
#include <fmt/format.h>

#include "agents/launcher/agent_factory.hpp"
#include "lisp/outside_text.hpp"
#include "lisp/writer.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/play/demo_choices.hpp"
#include "programs/play/play_commands.hpp"
#include "programs/play/random_runs.hpp"
#include "programs/story/goal_text.hpp"
#include "programs/story/output_file.hpp"
#include "programs/story/random_story.hpp"
#include "programs/story/scenario_run.hpp"

namespace pizarra::programs {

namespace {

constexpr double goal_alone_within_s = 300;

// The story beside the cell file; where there is none, or another goal is asked for, no hand interferes.
Result<forms::Scenario> story_of(const DemoChoices& choices) {
  const std::filesystem::path cell(choices.cell);
  const std::string story = (cell.parent_path() / "story.scm").string();
  forms::Scenario scenario;
  if (!choices.has("--goal") && !choices.random) {
    if (!std::filesystem::exists(story)) {
      const Result<forms::CellDescription> cell_alone = forms::read_cell_file(choices.cell);
      if (!cell_alone) return fail(cell_alone);
      return fail("no-story", fmt::format("there is no {}: give a goal with --goal '(on A B)'", story));
    }
    Result<forms::Scenario> told = forms::read_scenario_file(story);
    if (!told) return told;
    scenario = std::move(*told);
  } else {
    scenario.name = "a goal from the command line";
    scenario.within_s = goal_alone_within_s;
  }
  scenario.cell_file = choices.cell;
  if (!choices.domain.empty()) scenario.domain_file = choices.domain;
  return scenario;
}

std::string goal_words(const std::vector<Datum>& goal) {
  std::string out;
  for (const Datum& fact : goal) out += (out.empty() ? "" : " ") + write(fact);
  return out;
}

void tell_end(story::Narrator& narrator, const story::StoryReport& report, const DemoChoices& choices) {
  const Time end = Time{} + report.simulated;
  const story::DirectorReport& director = report.director;
  narrator.begin(Time{});
  if (director.outcome == "reached") {
    const std::string verdict = director.truth_holds ? "the world shows " : "the world does not show ";
    narrator.say(end, "judge", verdict + story::words_of_the_end(director.goal));
  }
  const double cell_s = static_cast<double>(report.simulated.count()) / 1e6;
  narrator.say(end, "time",
               fmt::format("{:.1f} s of the cell's time in {:.1f} s: {:.1f} times faster than real time", cell_s,
                           report.wall_s, report.speed()));
  if (!choices.picture.empty()) narrator.say(end, "picture", choices.picture);
  if (!choices.film.empty()) narrator.say(end, "film", choices.film);
}

int status_of(const story::DirectorReport& report, const std::string& typed_goal) {
  if (report.reached()) return exit_reached;
  if (report.outcome == "refused" && report.refusal) {
    const std::string goal = typed_goal.empty() ? goal_words(report.goal) : typed_goal;
    const Failure refusal = forms::at_its_goal(*report.refusal, goal);
    if (!report.refusal_told) return complain(refusal, exit_refused);
    // One that the coordinator came to has been part of the story already, but for its place.
    if (!refusal.place.empty()) fmt::print(stderr, "{}\n", lines_of_bytes(refusal.place));
    return exit_refused;
  }
  for (const std::string& sentence : report.unmet) fmt::print(stderr, "pizarra: {}\n", text_of_bytes(sentence));
  return exit_failed;
}

// What is told, in which cell.
struct Told {
  forms::Scenario scenario;
  forms::CellDescription cell;
  forms::Domain domain;
};

Result<Told> told_by(const DemoChoices& choices) {
  if (choices.has("--goal")) {
    const Result<void> typed = check_typed_goal(choices.goal);
    if (!typed) return fail(typed);
  }
  Result<forms::Scenario> scenario = story_of(choices);
  if (!scenario) return fail(scenario);
  Result<forms::CellDescription> cell = story::cell_of(*scenario);
  if (!cell) return fail(cell);
  if (!choices.arm.empty()) {
    const Result<void> put = forms::put_arm(*cell, choices.arm);
    if (!put) return fail(put);
  }
  const Result<simulation::WorldConfig> sound = launcher::world_config(*cell, choices.seed);
  if (!sound) return fail(sound);
  Result<forms::Domain> domain = story::domain_of(*cell);
  if (!domain) return fail(domain);
  if (choices.has("--goal")) {
    Result<std::vector<Datum>> goal = read_goal_for(*domain, choices.goal, *cell);
    if (!goal) return fail(goal);
    scenario->goal = std::move(*goal);
  }
  if (!choices.random) return Told{std::move(*scenario), std::move(*cell), std::move(*domain)};
  const Result<void> drawable = story::check_random_cell(*cell, *domain);
  if (!drawable) return fail(drawable);
  story::RandomStory drawn = story::random_story_of_seed(std::move(*cell), choices.seed);
  return Told{std::move(drawn.scenario), std::move(drawn.cell), std::move(*domain)};
}

int run_demo(const DemoChoices& choices) {
  const Result<Told> told = told_by(choices);
  if (!told) return complain(told.error(), exit_usage);
  for (const std::string& file : {choices.journal, choices.film, choices.picture}) {
    if (file.empty()) continue;
    const Result<void> writable = story::check_writable(file);
    if (!writable) return complain(writable.error(), exit_unavailable);
  }
  const StopSignals signals;
  story::StoryOptions options{choices.seed, choices.realtime, choices.journal, choices.film, choices.picture, &signals};
  options.director.events_may_fail = choices.random;
  story::Narrator narrator(stdout, story::Narrator::style_for(stdout, choices.json));
  narrator.say(Time{}, "cell",
               fmt::format("{}: {}, arm {}, domain {}, seed {}", told->cell.name,
                           counted(told->cell.cubes.size(), "cube"), told->cell.arm, told->domain.name, choices.seed));
  const Result<story::StoryReport> report = story::run_story(told->scenario, told->cell, options, narrator);
  if (!report) return complain(report.error(), exit_unavailable);
  if (report->interrupted) {
    narrator.begin(Time{});
    narrator.say(Time{} + report->simulated, "result", "interrupted");
    return exit_interrupted;
  }
  tell_end(narrator, *report, choices);
  return status_of(report->director, choices.goal);
}

}  // namespace

void add_demo_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<DemoChoices>();
  choices->cell = shipped_file("examples/01-blocks/cell.scm");
  CLI::App* demo =
      app.add_subcommand("demo",
                         "Run the simulated cell in this process: learn the objects, take a goal, plan, build it.\n"
                         "Without --goal the story beside the cell file is played, in which a hand interferes.");
  demo->add_option("CELL", choices->cell, "The cell file")->check(CLI::ExistingFile)->capture_default_str();
  demo->add_option("--goal", choices->goal, "FACT, (and FACT ...) or several FACTs; then no hand interferes");
  demo->add_option("--domain", choices->domain, "Use this domain file instead of the cell's")->check(CLI::ExistingFile);
  demo->add_option("--arm", choices->arm,
                   "Use this arm instead of the cell's: f3, t265, up6, another of arms/, or an arm file");
  demo->add_option("--seed", choices->seed, "The seed of all chance; the same seed gives the same run")
      ->check(seed_check())
      ->capture_default_str();
  demo->add_option("--journal", choices->journal, "Write every committed transaction to this file, one a line");
  demo->add_option("--video", choices->film, "Record the run as a film: FILE.avi or FILE.mp4");
  demo->add_option("--png", choices->picture, "Write the camera's view at the end to this file; '' writes none")
      ->capture_default_str();
  demo->add_flag("--realtime", choices->realtime, "Follow this machine's clock, not faster");
  demo->add_flag("--json", choices->json, "Print one JSON object a line");
  demo->add_flag("--random", choices->random, "Draw piles, a goal and one disturbance at random");
  demo->add_option("--seeds", choices->seeds,
                   "With --random: run this many seeds, print a line each and a summary; status 0 when no seed failed")
      ->check(CLI::Range(1, 100000));
  demo->add_option("--first-seed", choices->first_seed, "With --seeds: the first seed")
      ->check(seed_check())
      ->capture_default_str();
  demo->add_option("--jobs", choices->jobs, "With --seeds: how many run at once; 0: one a core")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  demo->footer(help_footer("demo --goal '(on circle triangle)' --seed 7"));
  demo->callback([choices, demo, &status] {
    for (const CLI::Option* option : demo->get_options()) {
      if (option->count() > 0) choices->given.insert(option->get_name());
    }
    const Result<void> sound = check_choices(*choices);
    if (!sound) {
      status = complain(sound.error(), exit_usage);
    } else if (choices->many()) {
      const RandomRuns runs{choices->cell,  choices->arm,  choices->first_seed,
                            choices->seeds, choices->jobs, choices->json};
      status = run_random(runs);
    } else {
      status = run_demo(*choices);
    }
  });
}

}  // namespace pizarra::programs
