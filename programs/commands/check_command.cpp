#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

#include "agents/coordinator/plan/task_domain.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/camera/image_files.hpp"
#include "drivers/camera/stereo_geometry.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/check_agent.hpp"
#include "programs/commands/check_planning.hpp"
#include "programs/commands/check_sight.hpp"
#include "programs/commands/commands.hpp"
#include "programs/host/this_host.hpp"
#include "programs/method/description.hpp"
#include "programs/story/goal_text.hpp"
#include "programs/story/scenario_run.hpp"

namespace pizarra::programs {

namespace {

struct CheckChoices {
  std::vector<std::string> files;
  std::string domain;
};

// As the coordinator reads it, which therefore refuses no domain that was checked.
Result<std::string> check_domain(const std::string& file) {
  const Result<coordinator::TaskDomain> task = coordinator::TaskDomain::read(file);
  if (!task) return fail(task);
  const forms::Domain& domain = task->domain();
  return fmt::format("domain {}: {}, {}", domain.name, counted(domain.predicates.size(), "predicate"),
                     counted(domain.operators.size(), "operator"));
}

Result<std::string> check_domain(const forms::CellDescription& cell) {
  const Result<forms::Domain> domain = story::domain_of(cell);
  if (!domain) return fail(domain);
  return check_domain(cell.domain_file);
}

void warn(const std::string& file, const std::string& sentence) {
  fmt::print(stderr, "{}: warning: {}\n", text_of_bytes(file), text_of_bytes(sentence));
}

// A cell with the domain that it names.
Result<std::string> check_cell_whole(const std::string& file, const forms::CellDescription& cell) {
  const Result<simulation::WorldConfig> sound = launcher::world_config(cell, 1);
  if (!sound) return fail(sound);
  if (cell.eyes.sources.empty()) {
    for (const std::string& cube : cubes_out_of_sight(*sound)) {
      warn(file, fmt::format("the images do not show all of the cube {} where it stands", cube));
    }
  }
  const bool has_domain = !cell.domain_file.empty() || story::needs_domain(cell);
  const Result<std::string> domain = has_domain ? check_domain(cell) : "no domain";
  if (!domain) return fail(domain);
  return fmt::format("cell {}: {}, {}; {}", cell.name, counted(cell.cubes.size(), "cube"),
                     counted(cell.hosts.size(), "host"), *domain);
}

// As the cell's eyes read it.
Result<void> check_calibration(const forms::CameraSetup& eyes) {
  if (eyes.calibration_file.empty()) return {};
  const Result<camera::StereoCalibration> read = camera::read_calibration_file(eyes.calibration_file);
  if (!read) return fail(read);
  const Result<camera::StereoGeometry> suits = camera::StereoGeometry::make(eyes, *read, {read->width, read->height});
  if (!suits) return fail(suits);
  return {};
}

// Another host may have what is not here.
bool sees_from_here(const forms::CellDescription& cell) {
  const Result<forms::CellHost> host = host::choose_host(cell, "");
  return host && std::ranges::find(host->agents, "vision") != host->agents.end();
}

// A file that is missing now may come before the cell is run.
void warn_of_missing_recordings(const std::string& file, const forms::CellDescription& cell) {
  if (!sees_from_here(cell)) return;
  for (const forms::CameraSource& source : cell.eyes.sources) {
    std::error_code unreadable;
    const bool film_missing =
        source.kind == forms::CameraSource::Kind::video && !std::filesystem::is_regular_file(source.where, unreadable);
    const bool images_missing =
        source.kind == forms::CameraSource::Kind::images && camera::image_files_at(source.where).empty();
    if (film_missing) warn(file, "there is no film " + source.where);
    if (images_missing) warn(file, camera::no_images_at(source.where));
  }
}

Result<std::string> check_cell(const std::string& file) {
  const Result<forms::CellDescription> cell = forms::read_cell_file(file);
  if (!cell) return fail(cell);
  const Result<void> calibrated = check_calibration(cell->eyes);
  if (!calibrated) return fail(calibrated);
  warn_of_missing_recordings(file, *cell);
  return check_cell_whole(file, *cell);
}

Result<std::string> check_arm(const std::string& file) {
  const Result<arm::ArmModel> arm = arm::read_arm_file(file);
  if (!arm) return fail(arm);
  return fmt::format("arm {}: {} axes", arm->type, arm->axes.size());
}

// A description of components for `method`.
Result<std::string> check_system(const std::string& file) {
  const Result<method::System> system = method::read_system(file);
  if (!system) return fail(system);
  return fmt::format("system \"{}\": {}, {}", system->name, counted(system->components.size(), "component"),
                     counted(system->connections.size(), "connection"));
}

Result<std::string> check_scenario_file(const std::string& file) {
  const Result<forms::Scenario> scenario = forms::read_scenario_file(file);
  if (!scenario) return fail(scenario);
  const Result<void> playable = story::check_scenario(*scenario);
  if (!playable) return fail(playable);
  const Result<forms::CellDescription> cell = story::cell_of(*scenario);
  if (!cell) return fail(cell);
  const Result<std::string> whole = check_cell_whole(file, *cell);
  if (!whole) return fail(whole);
  return fmt::format("scenario \"{}\": {}; {}", scenario->name, counted(scenario->events.size(), "event"), *whole);
}

// What is none of these is a goal.
Result<std::string> check_goal_file(const std::string& file, const CheckChoices& choices) {
  const std::string domain_file = choices.domain.empty() ? shipped_file("domains/blocks.scm") : choices.domain;
  const Result<forms::Domain> domain = forms::read_domain_file(domain_file);
  if (!domain) return fail(domain);
  std::ifstream in(file);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  const Result<std::vector<Datum>> goal = forms::check_goal(*domain, text);
  if (!goal) return fail(goal);
  return fmt::format("goal of {}", counted(goal->size(), "fact"));
}

// `next` is the file behind it, or empty.
Result<std::string> check_planning(const Source& source, const std::string& next, PlanningCheck& planning) {
  if (next.empty()) return planning.check(source, nullptr);
  const Result<Source> behind = forms::read_planning_source_file(next);
  return planning.check(source, behind ? &*behind : nullptr);
}

Result<std::string> check_file(const std::string& file, const std::string& next, const CheckChoices& choices,
                               PlanningCheck& planning) {
  const Result<std::string> text = read_text_file(file);
  if (text && is_agent_file(*text)) return check_agent(file, *text);
  const Result<Source> source = forms::read_planning_source_file(file);
  if (!source) return fail(source);
  if (is_agent_story(*source)) return check_agent_story(*source);
  if (PlanningCheck::knows(*source)) return check_planning(*source, next, planning);
  if (source->data().empty()) return fail("nothing-to-read", file + ": nothing is written here");
  const std::string_view head = source->data().front().head();
  if (head == "domain") {
    const Result<std::string> domain = check_domain(file);
    if (!domain) return domain;
    const Result<void> used = planning.use_domain(file);
    if (!used) return fail(used);
    return domain;
  }
  if (head == "cell") return check_cell(file);
  if (head == "arm") return check_arm(file);
  if (head == "system") return check_system(file);
  if (head == "scenario") return check_scenario_file(file);
  return check_goal_file(file, choices);
}

int check_files(const CheckChoices& choices) {
  int status = exit_reached;
  PlanningCheck planning;
  if (!choices.domain.empty()) {
    const Result<void> used = planning.use_domain(choices.domain);
    if (!used) return complain(used.error(), exit_usage);
  }
  for (std::size_t i = 0; i < choices.files.size(); ++i) {
    const std::string& file = choices.files[i];
    const std::string next = i + 1 < choices.files.size() ? choices.files[i + 1] : std::string();
    const Result<std::string> checked = check_file(file, next, choices, planning);
    if (checked) {
      fmt::print("{}: {}\n", text_of_bytes(file), *checked);
    } else {
      status = std::max<int>(status, complain(checked.error(), exit_usage));
    }
  }
  return status;
}

}  // namespace

void add_check_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<CheckChoices>();
  CLI::App* word = app.add_subcommand(
      "check", "Check domain, cell, arm, scenario, goal, planning and agent files, and report every error.");
  word->add_option("FILE", choices->files, "Files to check; the first form of a file says what it is")->required();
  word->add_option("--domain", choices->domain,
                   "The domain for goals, PDDL problems and facts; default for goals: domains/blocks.scm");
  word->footer(help_footer("check domains/blocks.scm examples/01-blocks/cell.scm"));
  word->callback([choices, &status] { status = check_files(*choices); });
}

}  // namespace pizarra::programs
