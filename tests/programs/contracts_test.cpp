// The facts that an agent reads and posts by its (contract ...) are those that it reads and posts: compared with the
// traffic of a whole demo. The agent's page in docs/facts has them, and its operations.

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "agents/launcher/local_cell.hpp"
#include "agents/runtime/contract.hpp"
#include "lisp/forms/domain.hpp"
#include "lisp/reader.hpp"
#include "programs/method/system.hpp"
#include "tests/programs/tapped_cell.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

using method::names_in;

using Names = std::set<std::string>;

// What every agent does by what it stands on: its presence and name, and requests and replies.
const Names of_every_agent = {"agent", "bound", "context", "contract", "request", "reply", "relation-stats"};

// The relations that an agent reads or posts only where something goes wrong, or where somebody asks for it, which
// nobody does in these cells.
using Occasions = std::map<std::string, Names>;
const Occasions read_on_occasion = {{"coordinator", {"looking-at", "pan-tilt-unit", "robot-speed", "stop"}},
                                    {"pan-tilt", {"place"}}};
const Occasions told_on_occasion = {{"coordinator", {"camera-pose", "leans", "raised"}},
                                    {"pan-tilt", {"head-speed", "looking-at"}},
                                    {"robot", {"gripped", "robot-released", "robot-speed", "robot-variable"}},
                                    {"vision",
                                     {"body", "camera-drops", "found", "learned-axis", "look-alike", "looked-at-most",
                                      "objects-damaged", "searched-in", "tags-seen", "vision-failed"}}};

Names with(Names names, const Occasions& occasions, const std::string& agent) {
  const auto more = occasions.find(agent);
  if (more != occasions.end()) names.insert(more->second.begin(), more->second.end());
  return names;
}

std::string without(const Names& names, const Names& others) {
  std::string out;
  for (const std::string& name : names) {
    if (!others.contains(name) && !of_every_agent.contains(name)) out += " " + name;
  }
  return out;
}

std::string page(const std::string& name) { return whole_file(source_dir() + "/docs/facts/" + name + ".md"); }

// Facts that several agents tell alike have pages of their own. A predicate of the domain is a relation too.
void expect_described(const Datum& contract, const Names& predicates) {
  const std::string own = page(std::string(contract[1].text()));
  const std::string all = own + page("agents") + page("streams");
  const auto lacking = [&](std::string_view part, const std::string& text) {
    std::string names;
    for (const std::string& name : names_in(contract, part)) {
      const bool stands = text.contains("`(" + name + " ") || text.contains("`(" + name + ")");
      if (!stands && !predicates.contains(name)) names += " " + name;
    }
    return names;
  };
  EXPECT_EQ(lacking("offers", own), "") << contract[1].text();
  EXPECT_EQ(lacking("posts", all), "") << contract[1].text();
}

void expect_true_contracts(const std::string& cell_file, std::vector<Datum> goal) {
  const forms::CellDescription description = forms::read_cell_file(source_dir() + cell_file).value();
  TappedCell cell(description, launcher::world_config(description, 7).value(), 7);
  const Result<void> built = cell.build(std::move(goal));
  ASSERT_TRUE(built) << describe(built.error());
  ASSERT_GE(cell.boards().size(), 5U);
  Names predicates;
  const forms::Domain domain = forms::read_domain_file(description.domain_file).value();
  for (const forms::Predicate& predicate : domain.predicates) {
    predicates.insert(predicate.name);
  }
  for (const auto& [agent, tap] : cell.boards()) {
    const Datum contract = cell.contract_of(agent);
    ASSERT_TRUE(contract.is_form("contract")) << agent;
    EXPECT_EQ(without(tap->read, names_in(contract, "reads")), "") << agent << " reads what its contract does not say";
    const Names read = with(tap->read, read_on_occasion, agent);
    EXPECT_EQ(without(names_in(contract, "reads"), read), "") << agent << " does not read what its contract says";
    EXPECT_EQ(without(tap->told, names_in(contract, "posts")), "") << agent << " posts what its contract does not say";
    const Names told = with(tap->told, told_on_occasion, agent);
    EXPECT_EQ(without(names_in(contract, "posts"), told), "") << agent << " does not post what its contract says";
    expect_described(contract, predicates);
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
