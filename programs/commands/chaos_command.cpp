#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

#include "programs/chaos/plant_search.hpp"
#include "programs/chaos/plants.hpp"
#include "programs/chaos/reference.hpp"
#include "programs/chaos/swarm.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"
#include "programs/story/output_file.hpp"
#include "programs/story/random_story.hpp"
#include "programs/story/scenario_run.hpp"

namespace pizarra::programs {

namespace {

struct ChaosChoices {
  std::string cell_file;
  std::string arm;
  std::uint64_t runs = 100;
  std::uint64_t first_seed = 1;
  unsigned jobs = 0;
  std::vector<std::string> only;
  std::optional<std::uint64_t> replay;
  std::string faults;
  std::string video;
  std::string plant;
  std::string coverage;
  std::string reference;
  bool no_shrink = false;
};

std::string plant_fault(const std::string& typed) {
  if (typed == "all" || chaos::is_plant(typed)) return {};
  return "there is no planted fault " + typed + "; --list-plants lists them";
}

std::string class_fault(const std::string& typed) {
  std::string names;
  for (const chaos::FaultClass& kind : chaos::fault_classes()) {
    if (typed == kind.name) return {};
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  return "there is no class of faults " + typed + "; there are " + names;
}

// `none`, or numbers with commas between.
std::optional<std::vector<std::size_t>> numbers_of(const std::string& text) {
  std::vector<std::size_t> numbers;
  if (text == "none") return numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    std::size_t number = 0;
    const auto read = std::from_chars(at, end, number);
    const bool sound = read.ec == std::errc() && (read.ptr == end || *read.ptr == ',');
    if (!sound) return std::nullopt;
    numbers.push_back(number);
    at = read.ptr == end ? end : read.ptr + 1;
  }
  return numbers;
}

// The rest of a line that replays a run, beside its seed and faults.
std::string replay_with(const ChaosChoices& choices) {
  std::string words;
  if (!choices.cell_file.ends_with("examples/01-blocks/cell.scm")) words += " " + choices.cell_file;
  if (!choices.arm.empty()) words += " --arm " + choices.arm;
  if (!choices.only.empty()) words += fmt::format(" --only {}", fmt::join(choices.only, ","));
  return words;
}

// Those of `faults`, of a run that has so many.
Result<std::optional<std::vector<std::size_t>>> chosen_faults(const ChaosChoices& choices, std::size_t drawn) {
  if (choices.faults.empty()) return std::nullopt;
  const std::optional<std::vector<std::size_t>> numbers = numbers_of(choices.faults);
  for (const std::size_t number : *numbers) {
    if (number >= drawn) {
      return fail("no-such-fault", fmt::format("seed {} has {} faults, counted from 0, and none is number {}",
                                               *choices.replay, drawn, number));
    }
  }
  return numbers;
}

int replay_one(const ChaosChoices& choices, const forms::CellDescription& cell) {
  if (choices.plant == "all") {
    return complain(
        Failure{"several-plants", "with --replay, --plant names one fault; --list-plants lists them", {}, {}},
        exit_usage);
  }
  const chaos::ChaosStory story = chaos::draw_story(cell, *choices.replay, choices.only);
  const auto faults = chosen_faults(choices, story.faults.size());
  if (!faults) return complain(faults.error(), exit_usage);
  fmt::print("seed {}\n", story.seed);
  for (const std::string& line : chaos::describe(story)) fmt::print("  {}\n", line);
  chaos::PlayOptions options;
  options.film_file = choices.video;
  options.plant = choices.plant;
  options.faults = *faults;
  story::Narrator narrator(stdout, story::Narrator::style_for(stdout, false));
  const Result<chaos::RunResult> result = chaos::play(story, options, narrator);
  if (!result) return complain(result.error(), exit_unavailable);
  fmt::print("seed {:6}  {}\n", story.seed, chaos::line_of(*result));
  for (const std::string& sentence : result->unsafe) fmt::print("  unsafe: {}\n", sentence);
  return result->kind == chaos::RunResult::Kind::failed ? exit_failed : exit_reached;
}

// It says something of the same runs alone.
Result<chaos::Reference> reference_for(const ChaosChoices& choices) {
  Result<chaos::Reference> reference = chaos::read_reference(choices.reference);
  if (!reference) return reference;
  if (reference->runs == choices.runs && reference->first_seed == choices.first_seed) return reference;
  return fail("other-runs",
              fmt::format("{} is of {} runs from seed {}: give --runs {} --first-seed {}", choices.reference,
                          reference->runs, reference->first_seed, reference->runs, reference->first_seed));
}

bool is_as_good_as(const chaos::Reference& reference, const chaos::Reference& now) {
  const std::vector<std::string> worse = chaos::worse_than(reference, now);
  for (const std::string& sentence : worse) fmt::print("{}\n", sentence);
  for (const std::string& sentence : chaos::better_than(reference, now)) fmt::print("{}\n", sentence);
  return worse.empty();
}

chaos::SwarmOptions swarm_options(const ChaosChoices& choices, const forms::CellDescription& cell) {
  chaos::SwarmOptions options;
  options.cell = cell;
  options.first_seed = choices.first_seed;
  options.runs = choices.runs;
  options.jobs = choices.jobs;
  options.only = choices.only;
  options.shrink = !choices.no_shrink;
  options.replay_with = replay_with(choices);
  return options;
}

int run_many(const ChaosChoices& choices, const forms::CellDescription& cell) {
  std::optional<chaos::Reference> reference;
  if (!choices.reference.empty()) {
    Result<chaos::Reference> read = reference_for(choices);
    if (!read) return complain(read.error(), exit_usage);
    reference = std::move(*read);
  }
  const chaos::Tally tally = chaos::run_swarm(swarm_options(choices, cell), stdout);
  const chaos::Reference now = chaos::reference_of(choices.first_seed, tally);
  if (!choices.coverage.empty()) {
    const std::string text = chaos::text_of(now);
    const Result<void> written =
        story::write_file(choices.coverage, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    if (!written) return complain(written.error(), exit_unavailable);
  }
  for (const std::string& point : tally.coverage.unreached()) fmt::print("unreached: {}\n", point);
  fmt::print("{:.1f} s of the cells' time in {:.1f} s of one core: {:.1f} times as fast\n", tally.cell_s, tally.cpu_s,
             tally.cpu_s > 0 ? tally.cell_s / tally.cpu_s : 0.0);
  const bool compares = reference && tally.whole;
  const bool well = compares ? is_as_good_as(*reference, now) : chaos::passes(tally);
  fmt::print("{}\n", chaos::last_line(tally));
  if (!tally.whole) return exit_interrupted;
  return well ? exit_reached : exit_failed;
}

// One planted fault, or all of them, each in as many runs as it takes.
int find_plants(const ChaosChoices& choices, const forms::CellDescription& cell) {
  chaos::SwarmOptions options = swarm_options(choices, cell);
  std::vector<std::uint64_t> taken;
  int missed = 0;
  for (const chaos::Plant& plant : chaos::plants()) {
    if (choices.plant != "all" && choices.plant != plant.name) continue;
    options.plant = plant.name;
    const chaos::PlantSearch search = chaos::find_plant(options);
    if (!search.whole) return exit_interrupted;
    const std::uint64_t runs = search.found_by;
    if (runs > 0) taken.push_back(runs);
    missed += runs == 0 ? 1 : 0;
    const std::string found = runs > 0 ? fmt::format("found by run {}", runs) : "NOT FOUND";
    fmt::print("plant {:<26} {}\n", plant.name, found);
    std::fflush(stdout);
  }
  std::ranges::sort(taken);
  if (!taken.empty()) {
    fmt::print("plants {} found {} median {} runs\n", taken.size() + static_cast<std::size_t>(missed), taken.size(),
               taken[taken.size() / 2]);
  }
  return missed == 0 ? exit_reached : exit_failed;
}

int run_chaos(const ChaosChoices& choices) {
  Result<forms::CellDescription> cell = forms::read_cell_file(choices.cell_file);
  if (!cell) return complain(cell.error(), exit_usage);
  if (!choices.arm.empty()) {
    const Result<void> put = forms::put_arm(*cell, choices.arm);
    if (!put) return complain(put.error(), exit_usage);
  }
  const Result<simulation::WorldConfig> sound = launcher::world_config(*cell, 1);
  if (!sound) return complain(sound.error(), exit_usage);
  const Result<forms::Domain> domain = story::domain_of(*cell);
  if (!domain) return complain(domain.error(), exit_usage);
  const Result<void> drawable = story::check_random_cell(*cell, *domain);
  if (!drawable) return complain(drawable.error(), exit_usage);
  if (choices.replay) return replay_one(choices, *cell);
  return choices.plant.empty() ? run_many(choices, *cell) : find_plants(choices, *cell);
}

// After the options that it excludes.
void add_replay_options(CLI::App* word, ChaosChoices& choices) {
  CLI::Option* const replay =
      word->add_option("--replay", choices.replay, "Play the run of this seed and tell its story")->check(seed_check());
  word->add_option("--faults", choices.faults, "With --replay: of its faults these alone: N,... or none")
      ->check([](const std::string& text) {
        return numbers_of(text) ? std::string() : "not numbers with commas between, or none";
      })
      ->type_name("N,...")
      ->needs(replay);
  word->add_option("--video", choices.video, "With --replay: film it (.avi or .mp4)")->needs(replay);
  for (const char* of_many : {"--runs", "--first-seed", "--jobs", "--coverage", "--reference", "--no-shrink"}) {
    replay->excludes(of_many);
  }
}

// After the options that it excludes.
void add_plant_option(CLI::App* word, ChaosChoices& choices) {
  CLI::Option* const plant = word->add_option("--plant", choices.plant,
                                              "Plant this fault into the cell, or `all` one after another, and find it")
                                 ->check(plant_fault)
                                 ->type_name("NAME");
  for (const char* of_runs : {"--coverage", "--reference", "--no-shrink"}) plant->excludes(of_runs);
}

void add_lists(CLI::App* word) {
  word->add_flag_callback(
      "--list-plants",
      [] {
        for (const chaos::Plant& plant : chaos::plants()) fmt::print("{:<26} {}\n", plant.name, plant.sentence);
        throw CLI::Success();
      },
      "Print the faults that can be planted, and end");
  word->add_flag_callback(
      "--list-classes",
      [] {
        for (const chaos::FaultClass& kind : chaos::fault_classes())
          fmt::print("{:<10} {}\n", kind.name, kind.sentence);
        throw CLI::Success();
      },
      "Print the classes of faults, and end");
}

}  // namespace

void add_chaos_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<ChaosChoices>();
  choices->cell_file = shipped_file("examples/01-blocks/cell.scm");
  CLI::App* word = app.add_subcommand(
      "chaos", "Play many runs of a cell in which whatever can fail fails, each drawn from its seed, in virtual time.");
  word->add_option("CELL", choices->cell_file, "A cell file (without: the demo's)")->check(CLI::ExistingFile);
  word->add_option("--runs,--seeds", choices->runs, "How many")->check(CLI::Range(1, 1'000'000))->capture_default_str();
  word->add_option("--first-seed", choices->first_seed, "The first run's; each has the next")
      ->check(seed_check())
      ->capture_default_str();
  word->add_option("--jobs", choices->jobs, "Processes at once (without: one a core)")->check(CLI::Range(1, 256));
  word->add_option("--only", choices->only,
                   "Faults of these classes alone, with commas or blanks between (--list-classes)")
      ->delimiter(',')
      ->check(class_fault)
      ->type_name("CLASS");
  word->add_option("--arm", choices->arm, "Another arm in place of the cell's: of arms/, or an arm file");
  word->add_option(
      "--coverage", choices->coverage,
      "Write to this file how many runs failed, were unsafe and hung, and how often each point was reached");
  word->add_option(
          "--reference", choices->reference,
          "A file of --coverage of the same runs. The status is 1 if more runs fail, are unsafe or hang, or if a "
          "point that it counts five times or more is no longer reached")
      ->check(CLI::ExistingFile);
  word->add_flag("--no-shrink", choices->no_shrink, "Leave out to look for the fewest faults that still fail");
  add_replay_options(word, *choices);
  add_plant_option(word, *choices);
  add_lists(word);
  word->footer(
      help_footer("chaos --runs 200 --first-seed 1",
                  "Exit status: 0 no run was unsafe, and at most one in a hundred failed (with --reference: "
                  "no worse than that);\n1 otherwise; 2 a wrong option or reference, or a cell that has no such "
                  "runs; 4 a file cannot be written;\n130 interrupted. With --replay: 0 reached or rightly "
                  "refused, 1 otherwise."));
  word->callback([choices, &status] { status = run_chaos(*choices); });
}

}  // namespace pizarra::programs
