#include "lisp/forms/scenario_file.hpp"

#include "lisp/forms/file_paths.hpp"
#include "lisp/guile/scheme.hpp"

namespace pizarra::forms {

namespace {

std::vector<Datum> items_of(const Datum& datum) { return {datum.items().begin(), datum.items().end()}; }

Scenario scenario_from_datum(const Datum& datum, const std::string& file) {
  Scenario scenario;
  scenario.file = file;
  scenario.name = datum[0].text();
  scenario.cell_file = beside(file, std::string(datum[1].text()));
  scenario.domain_file = beside(file, std::string(datum[2].text()));
  if (datum[3].is_form("cubes")) {
    scenario.cubes.emplace();
    for (const Datum& cube : datum[3].items().subspan(1)) scenario.cubes->push_back(cube_from_datum(cube));
  }
  scenario.goal = items_of(datum[4]);
  scenario.before_goal = items_of(datum[5]);
  for (const Datum& event : datum[6].items()) {
    const auto actions = event.items().subspan(1);
    scenario.events.push_back({event[0], {actions.begin(), actions.end()}});
  }
  scenario.expect_reached = datum[7].is_symbol("reached");
  scenario.refusal = datum[8].text();
  scenario.expect_seen = items_of(datum[9]);
  scenario.expect_never = items_of(datum[10]);
  scenario.within_s = datum[11].number();
  scenario.seed = static_cast<std::uint64_t>(datum[12].number());
  return scenario;
}

// How big the cubes are of the cell that the scenario names. A cell that cannot be read is reported by who opens it:
// its cubes take no room here.
double cube_mm_of(const Source& source) {
  for (const Datum& scenario : source.data()) {
    for (const Datum& section : scenario.items()) {
      if (!section.is_form("cell") || section.size() != 2 || !section[1].is_string()) continue;
      const Result<CellDescription> cell = read_cell_file(beside(source.file(), std::string(section[1].text())));
      if (cell) return cell->cube_mm;
    }
  }
  return 0;
}

Result<Scenario> interpret_scenario(const Result<Source>& source) {
  if (!source) return fail(source);
  const Result<Datum> scenario = guile::interpret(*source, "scenario", {to_datum(cube_mm_of(*source))});
  if (!scenario) return fail(scenario);
  return scenario_from_datum(*scenario, source->file());
}

}  // namespace

Result<Scenario> read_scenario(std::string_view text, const std::string& file) {
  return interpret_scenario(read_source(text, file));
}

Result<Scenario> read_scenario_file(const std::string& path) { return interpret_scenario(read_source_file(path)); }

}  // namespace pizarra::forms
