#include "programs/story/scenario_run.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <fstream>

#include "agents/coordinator/plan/task_domain.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "programs/story/output_file.hpp"
#include "programs/story/recorder.hpp"

namespace pizarra::story {

namespace {

// Frames for the picture that is taken after the story.
constexpr Duration last_look = 500ms;

Result<void> start_journal(std::ofstream& journal, const std::string& path, memory::MemoryBoard& board) {
  if (path.empty()) return {};
  journal.open(path, std::ios::trunc);
  if (!journal) return fail(unwritten(path));
  board.set_journal([&journal](std::string_view line) { journal << line << '\n'; });
  return {};
}

Task<void> pause(Executor& executor, Duration duration) { co_await sleep(executor, duration); }

void run_until_done(Executor& executor, const Job& job) {
  executor.run_until([&job] { return job.done(); });
}

// The last pictures, then what was recorded is written.
Result<void> finish_recording(Recorder& recorder, Executor& executor, const StoryOptions& options) {
  const bool interrupted = options.stop != nullptr && options.stop->received();
  if (!options.picture_file.empty() && !interrupted) {
    recorder.watch();
    const Job look = executor.spawn(pause(executor, last_look));
    run_until_done(executor, look);
    const Result<void> saved = recorder.save_picture(options.picture_file);
    if (!saved) return saved;
  }
  return recorder.finish();
}

Result<StoryReport> run_on(Executor& executor, const forms::Scenario& scenario,
                           const forms::CellDescription& description, const Judge& judge, const StoryOptions& options,
                           Narrator& narrator) {
  std::ofstream journal;
  // A story is told in the simulated world, whatever controllers and cameras the cell has of its own.
  forms::CellDescription simulated = description;
  simulated.arm_line = {};
  if (simulated.slave) simulated.slave->line = {};
  simulated.eyes = {};
  // It begins with nothing learned and leaves nothing behind, so that it repeats.
  simulated.objects_directory.clear();
  launcher::LocalCell cell(executor, std::move(simulated), options.seed);
  const Result<void> journaled = start_journal(journal, options.journal_file, cell.board());
  if (!journaled) return fail(journaled);
  Recorder recorder(cell.streams(), narrator);
  if (!options.film_file.empty()) {
    const Result<void> filming = recorder.film(options.film_file);
    if (!filming) return fail(filming);
  }
  const Time start = executor.now();
  const auto wall_start = std::chrono::steady_clock::now();
  narrator.begin(start);
  for (const std::string& kind : launcher::agent_kinds(cell.description())) {
    const Result<void> started = cell.start(kind);
    if (!started) return fail(started);
  }
  const std::unique_ptr<Board> ears = cell.board().view("narrator");
  const Job told = executor.spawn(narrator.follow(*ears, executor));
  const Job beside = options.beside ? executor.spawn(options.beside(cell)) : Job();
  Director director(cell, scenario, judge, narrator, options.director);
  const Job story = executor.spawn(director.run());
  const auto interrupted = [&] { return options.stop != nullptr && options.stop->received(); };
  executor.run_until([&] { return story.done() || interrupted(); });

  StoryReport report;
  report.interrupted = !story.done();
  report.director = director.report();
  report.simulated = executor.now() - start;
  report.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  const Result<void> recorded = finish_recording(recorder, executor, options);
  if (!recorded) return fail(recorded);
  journal.flush();
  if (journal.is_open() && !journal) return fail(unwritten(options.journal_file));
  return report;
}

}  // namespace

namespace {

// Where in the text a form stands: the way to it, empty where it does not.
std::vector<std::size_t> path_to(const Datum& wanted, std::span<const Datum> items) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i] == wanted) return {i};
    std::vector<std::size_t> path = path_to(wanted, items[i].items());
    if (path.empty()) continue;
    path.insert(path.begin(), i);
    return path;
  }
  return {};
}

Failure at_its_place(const Failure& failure, const forms::Scenario& scenario, const Datum& form) {
  const Failure without{"bad-scenario", describe(failure), form, {}};
  const Result<Source> source = scenario.file.empty() ? Result<Source>(fail("no-file", "it was not read from a file"))
                                                      : read_source_file(scenario.file);
  if (!source) return without;
  const std::vector<std::size_t> path = path_to(form, source->data());
  return path.empty() ? without : source->failure_at(path, without.symbol, failure.sentence);
}

}  // namespace

Result<void> check_scenario(const forms::Scenario& scenario) {
  std::vector<Datum> queries = scenario.expect_seen;
  queries.insert(queries.end(), scenario.expect_never.begin(), scenario.expect_never.end());
  for (const forms::ScenarioEvent& event : scenario.events) queries.push_back(event.condition);
  for (const Datum& form : queries) {
    const Result<Query> query = query_from_datum(form);
    if (!query) return fail(at_its_place(query.error(), scenario, form));
  }
  return {};
}

Result<forms::CellDescription> cell_of(const forms::Scenario& scenario) {
  Result<forms::CellDescription> cell = forms::read_cell_file(scenario.cell_file);
  if (!cell) return cell;
  if (scenario.cubes) cell->cubes = *scenario.cubes;
  if (!scenario.domain_file.empty()) cell->domain_file = scenario.domain_file;
  return cell;
}

bool needs_domain(const forms::CellDescription& cell) {
  return std::ranges::any_of(cell.hosts, [](const forms::CellHost& host) {
    return std::ranges::find(host.agents, "coordinator") != host.agents.end();
  });
}

Result<forms::Domain> domain_of(const forms::CellDescription& cell) {
  if (cell.domain_file.empty()) {
    return fail("no-domain", "a coordinator needs to know the task, and the cell names no file with (domain \"FILE\")",
                Datum::symbol(cell.name));
  }
  const Result<coordinator::TaskDomain> task = coordinator::TaskDomain::read(cell.domain_file);
  if (!task && task.error().symbol == "unreadable-file") {
    return fail("no-domain", fmt::format("the domain of the cell {}: {}", cell.name, task.error().sentence));
  }
  if (!task) return fail(task);
  return task->domain();
}

Result<StoryReport> run_story(const forms::Scenario& scenario, const forms::CellDescription& cell,
                              const StoryOptions& options, Narrator& narrator) {
  const Result<simulation::WorldConfig> sound = launcher::world_config(cell, options.seed);
  if (!sound) return fail(sound);
  const Result<void> playable = check_scenario(scenario);
  if (!playable) return fail(playable);
  const Result<forms::Domain> domain = domain_of(cell);
  if (!domain) return fail(domain);
  const Result<Judge> judge = Judge::make(*domain, cell.cube_mm, cell.edges_mm());
  if (!judge) return fail(judge);
  if (options.realtime) {
    RealExecutor executor;
    return run_on(executor, scenario, cell, *judge, options, narrator);
  }
  VirtualExecutor executor;
  return run_on(executor, scenario, cell, *judge, options, narrator);
}

}  // namespace pizarra::story
