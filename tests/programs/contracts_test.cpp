// The facts that an agent reads and posts by its (contract ...) are those that it reads and posts: compared with the
// traffic of a whole demo.

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "agents/launcher/local_cell.hpp"
#include "agents/runtime/contract.hpp"
#include "lisp/reader.hpp"
#include "tests/programs/tapped_cell.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

using Names = std::set<std::string>;

// What every agent does by what it stands on: its presence and name, and requests and replies.
const Names of_every_agent = {"agent", "bound", "context", "contract", "request", "reply", "relation-stats"};

// The relations that an agent reads only where something goes wrong, or where somebody asks for it, which nobody does
// in these cells.
const std::map<std::string, Names> on_occasion = {{"person", {"vision-failed"}}, {"pan-tilt", {"place"}}};

// The names in one part of a contract.
Names names_in(const Datum& contract, std::string_view part) {
  Names names;
  for (const Datum& each : contract.items()) {
    if (!each.is_form(part)) continue;
    for (const Datum& item : each.items().subspan(1)) {
      names.emplace(item.is_form("relation") ? item[1].text() : item.text());
    }
  }
  return names;
}

std::string without(const Names& names, const Names& others) {
  std::string out;
  for (const std::string& name : names) {
    if (!others.contains(name) && !of_every_agent.contains(name)) out += " " + name;
  }
  return out;
}

void expect_true_contracts(const std::string& cell_file, std::vector<Datum> goal) {
  const forms::CellDescription description = forms::read_cell_file(source_dir() + cell_file).value();
  TappedCell cell(description, launcher::world_config(description, 7).value(), 7);
  const Result<void> built = cell.build(std::move(goal));
  ASSERT_TRUE(built) << describe(built.error());
  ASSERT_GE(cell.boards().size(), 5U);
  for (const auto& [agent, tap] : cell.boards()) {
    const Datum contract = cell.contract_of(agent);
    ASSERT_TRUE(contract.is_form("contract")) << agent;
    EXPECT_EQ(without(tap->read, names_in(contract, "reads")), "") << agent << " reads what its contract does not say";
    Names read = tap->read;
    if (on_occasion.contains(agent)) read.insert(on_occasion.at(agent).begin(), on_occasion.at(agent).end());
    EXPECT_EQ(without(names_in(contract, "reads"), read), "") << agent << " does not read what its contract says";
    EXPECT_EQ(without(tap->told, names_in(contract, "posts")), "") << agent << " posts what its contract does not say";
  }
}

TEST(Contracts, AreWhatTheAgentsOfADemoReadAndPost) {
  expect_true_contracts("/examples/01-blocks/cell.scm", {list("on"_sym, "circle"_sym, "triangle"_sym)});
}

TEST(Contracts, AreWhatTheAgentsOfAMovingHeadReadAndPost) {
  expect_true_contracts("/examples/03-moving-head/cell.scm", {list("on"_sym, "circle"_sym, "triangle"_sym)});
}

}  // namespace
}  // namespace pizarra::programs
