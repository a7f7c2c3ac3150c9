// Nothing of the simulated world's truth reaches vision, planner or coordinator: not by facts, not by the device link.

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <set>

#include "agents/launcher/local_cell.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/programs/tapped_cell.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

constexpr std::uint64_t seed = 7;

forms::CellDescription example_cell() {
  return forms::read_cell_file(source_dir() + "/examples/01-blocks/cell.scm").value();
}

std::vector<Datum> goal() { return {list("on"_sym, "circle"_sym, "triangle"_sym)}; }

// A fact of the journal and who told it.
struct Told {
  std::string teller;
  Datum fact;
};

struct Journal {
  std::set<std::string> tellers;     // who declared, told or took anything
  std::set<std::string> retractors;  // who let facts go
  std::vector<Told> told;
};

Journal read_journal(const std::string& text) {
  Journal journal;
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    const Datum line = read_one(text.substr(begin, end - begin)).value();
    begin = end + 1;
    const std::string teller(line[2].text());
    for (const Datum& change : line.items().subspan(3)) {
      (change.is_form("retract") ? journal.retractors : journal.tellers).insert(teller);
      if (change.is_form("tell")) journal.told.push_back({teller, change[2]});
    }
  }
  return journal;
}

void visit(const Datum& datum, const std::function<void(const Datum&)>& see) {
  see(datum);
  for (const Datum& item : datum.items()) visit(item, see);
}

bool holds_number(const Datum& datum) {
  bool found = false;
  visit(datum, [&found](const Datum& part) { found = found || part.is_number(); });
  return found;
}

bool names_a_cube(const Datum& datum) {
  bool found = false;
  visit(datum, [&found](const Datum& part) {
    if (!part.is_symbol() && !part.is_string()) return;
    for (const forms::CubePlacement& cube : example_cell().cubes) found = found || part.text() == cube.name;
  });
  return found;
}

// The example cell, run until the goal is reached.
class TruthInFacts : public testing::Test {
 protected:
  void SetUp() override {
    const Result<void> built = cell_.build(goal());
    ASSERT_TRUE(built) << describe(built.error());
    journal_ = read_journal(cell_.journal());
    ASSERT_GT(journal_.told.size(), 100U);
  }

  TappedCell cell_{example_cell(), launcher::world_config(example_cell(), seed).value(), seed};
  Journal journal_;
};

TEST_F(TruthInFacts, OnlyTheAgentsAndTheVisitorTellAnything) {
  std::set<std::string> known{"robot", "vision", "planner", "coordinator", "person", "visitor"};
  EXPECT_EQ(journal_.tellers, known);
  // By itself the board only lets facts go whose lease has lapsed.
  known.insert("board");
  EXPECT_TRUE(std::ranges::includes(known, journal_.retractors));
}

TEST_F(TruthInFacts, EveryRelationHasOneTellerButThoseThatAllAgentsShare) {
  const std::set<std::string> shared{"agent", "bound", "context", "contract", "holder", "request", "reply", "wired"};
  std::map<std::string, std::set<std::string>> tellers;
  for (const Told& told : journal_.told) tellers[std::string(told.fact.head())].insert(told.teller);
  for (const auto& [relation, who] : tellers) {
    EXPECT_TRUE(shared.contains(relation) || who.size() == 1) << relation;
  }
  EXPECT_EQ(tellers.at("learned"), std::set<std::string>{"vision"});
  EXPECT_EQ(tellers.at("place"), std::set<std::string>{"coordinator"});
  EXPECT_EQ(tellers.at("arm-pose"), std::set<std::string>{"robot"});
}

TEST_F(TruthInFacts, ThePersonTellsWherePixelsAreAndNoOtherNumberOfTheWorld) {
  std::set<std::string> seen;
  for (const Datum& at : cell_.taps().at("person")->answered) seen.insert(write(at));
  std::size_t clicks = 0;
  for (const Told& told : journal_.told) {
    if (told.teller != "person") continue;
    const std::string_view relation = told.fact.head();
    if (relation == "agent" || relation == "contract" || relation == "bound" || relation == "context") continue;
    const bool of_names = relation == "person" || relation == "wired" || relation == "holder";
    if (of_names) {
      EXPECT_FALSE(holds_number(told.fact)) << write(told.fact);
      continue;
    }
    ASSERT_EQ(relation, "request") << write(told.fact);
    const Datum& operation = told.fact[3];
    if (operation.is_form("learn")) {
      ++clicks;
      EXPECT_TRUE(seen.contains(write(list(operation[1], operation[2])))) << write(operation);
      EXPECT_TRUE(operation[1].number() >= 0 && operation[1].number() < 320) << write(operation);
      EXPECT_TRUE(operation[2].number() >= 0 && operation[2].number() < 240) << write(operation);
    } else if (operation.is_form("move-v")) {
      // A step of its own, the same wherever the cubes stand.
      EXPECT_EQ(write(operation), "(move-v down 50)");
    } else {
      const bool known = operation.is_form("ready") || operation.is_form("connect") || operation.is_form("accept");
      EXPECT_TRUE(known && !holds_number(operation)) << write(operation);
    }
  }
  EXPECT_EQ(clicks, example_cell().cubes.size() + 1);
}

TEST_F(TruthInFacts, NobodyAsksThePersonOrTheWorldAndOnlyTheCoordinatorAsksTheOthers) {
  const std::map<std::string, std::set<std::string>> may_ask{
      {"coordinator", {"robot", "vision", "planner"}}, {"person", {"robot", "vision"}}, {"visitor", {"coordinator"}}};
  std::size_t asked = 0;
  for (const auto& [teller, fact] : journal_.told) {
    if (!fact.is_form("request")) continue;
    ++asked;
    EXPECT_TRUE(fact[1].text().starts_with(teller + "-")) << teller << " tells " << write(fact);
    const auto asker = may_ask.find(teller);
    const bool may = asker != may_ask.end() && asker->second.contains(std::string(fact[2].text()));
    EXPECT_TRUE(may) << teller << " tells " << write(fact);
  }
  EXPECT_GT(asked, 20U);
}

TEST_F(TruthInFacts, OverTheDeviceLinkTheEyesGetPicturesTheArmItselfAndThePersonWhereToClick) {
  const std::map<std::string, std::set<std::string>> may_ask{
      {"robot", {"arm"}}, {"vision", {"camera"}}, {"planner", {}}, {"coordinator", {}}, {"person", {"where-seen"}}};
  for (const auto& [agent, tap] : cell_.taps()) {
    for (const Datum& asked : tap->asked) {
      EXPECT_TRUE(may_ask.at(agent).contains(std::string(asked.head()))) << agent << " asks " << write(asked);
    }
    for (const Datum& answer : tap->answered) EXPECT_FALSE(names_a_cube(answer)) << agent << " hears " << write(answer);
  }
  ASSERT_GT(cell_.taps().at("vision")->answered.size(), 50U);
  ASSERT_GT(cell_.taps().at("robot")->answered.size(), 50U);
  // Beside its two images a frame has a number and a time, which follow from each other.
  const Datum first = cell_.taps().at("vision")->answered[1];
  for (std::size_t n = 1; n < cell_.taps().at("vision")->answered.size(); ++n) {
    const Datum& frame = cell_.taps().at("vision")->answered[n];
    ASSERT_EQ(frame.size(), 2U) << write(frame);
    EXPECT_EQ(frame[1].integer() - first[1].integer(), (frame[0].integer() - first[0].integer()) * 100'000);
  }
}

std::string journal_of(const forms::CellDescription& description, const simulation::WorldConfig& config) {
  const Result<void> sound = check(config);
  if (!sound) return describe(sound.error());
  TappedCell cell(description, config, seed);
  const Result<void> built = cell.build(goal());
  return built ? cell.journal() : describe(built.error());
}

TEST_F(TruthInFacts, AgentsThatWereNotToldOfTheCubesDoAsInTheProgramsOwnCell) {
  VirtualExecutor executor;
  launcher::LocalCell whole(executor, example_cell(), seed);
  std::string journal;
  whole.board().set_journal([&journal](std::string_view line) { journal.append(line).append("\n"); });
  for (const std::string& kind : launcher::agent_kinds(example_cell())) ASSERT_TRUE(whole.start(kind));
  const Result<void> built = teach_and_build(executor, whole.board(), goal());
  ASSERT_TRUE(built) << describe(built.error());
  EXPECT_TRUE(journal == cell_.journal());
}

// The example's world on a table so long that a fifth cube stands beyond the edge of both images.
simulation::WorldConfig with_unseen_cube(double y_mm, simulation::Mark mark = simulation::Mark::circle) {
  simulation::WorldConfig config = launcher::world_config(example_cell(), seed).value();
  config.table.y_high_mm = 1000;
  config.cubes.push_back({"unseen", mark, 450, y_mm, 0, ""});
  return config;
}

TEST(UnseenTruth, ACubeOutsideTheImagesMayStandElsewhereBeAnotherOrNoneAndNoFactTellsIt) {
  simulation::WorldConfig without = with_unseen_cube(800);
  without.cubes.pop_back();
  const std::string journal = journal_of(example_cell(), with_unseen_cube(800));
  ASSERT_NE(journal.find("reached"), std::string::npos) << journal;
  EXPECT_TRUE(journal == journal_of(example_cell(), with_unseen_cube(850)));
  EXPECT_TRUE(journal == journal_of(example_cell(), with_unseen_cube(800, simulation::Mark::cross)));
  EXPECT_TRUE(journal == journal_of(example_cell(), without));
  // It is the world that the judge sees which differs, and a difference that shows does reach the journal.
  TappedCell here(example_cell(), with_unseen_cube(800), seed);
  TappedCell there(example_cell(), with_unseen_cube(850), seed);
  EXPECT_NE(write(here.ask_world(list("truth"_sym))), write(there.ask_world(list("truth"_sym))));
  simulation::WorldConfig shifted = with_unseen_cube(800);
  shifted.cubes.front().y_mm += 5;
  EXPECT_FALSE(journal == journal_of(example_cell(), shifted));
}

// The camera stands some 20 mm and 2 degrees from where its cell file says that somebody measured it.
forms::CellDescription cell_with_guessed_camera() {
  return forms::read_cell_file(source_dir() + "/tests/scenarios/cells/guessed-camera.scm").value();
}

TEST(CameraTruth, AgentsThatHaveAGuessAloneReachTheGoalAndReadNothingOfWhereTheCameraStands) {
  const forms::CellDescription guessed = cell_with_guessed_camera();
  const simulation::WorldConfig world = launcher::world_config(guessed, seed).value();
  const std::string journal = journal_of(guessed, world);
  ASSERT_NE(journal.find("reached"), std::string::npos) << journal;
  // Whatever the agents' copy of the cell says of where the world has it, they see and do the same.
  forms::CellDescription misled = guessed;
  misled.world_camera = {.at_mm = {900, 400, 700}, .pan_deg = 20, .tilt_deg = -15, .roll_deg = 4};
  EXPECT_TRUE(journal == journal_of(misled, world));
  // The guess is what they begin with: another one shows.
  forms::CellDescription other_guess = guessed;
  other_guess.camera.pose.at_mm[0] += 5;
  EXPECT_FALSE(journal == journal_of(other_guess, world));
}

}  // namespace
}  // namespace pizarra::programs
