// A bad domain at the shell: `check` finds it in the domain, in a cell that names it and in a scenario of that cell,
// and nothing begins with it.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

class Check : public testing::Test {
 protected:
  Check() {
    std::filesystem::create_directories(folder_);
    std::string text = whole_file(source_dir() + "/domains/blocks.scm");
    const std::string sound = "(PICK-UP (<ob1>) (GRASP <ob1>))";
    const std::size_t at = text.find(sound);
    EXPECT_NE(at, std::string::npos);
    text.replace(at, sound.size(), "(PICK-UP (<ob1>) (JUMP <ob1>))");
    write("domain.scm", text);
    write("cell.scm",
          "(cell c (world (cube circle (at 450 0)) (noise (sensor 20) (blur 2) (gradient 0.9)))\n"
          "  (arm crs-f3) (domain \"domain.scm\"))");
    write("story.scm", "(scenario \"s\" (cell \"cell.scm\") (goal (on-table circle)) (expect reached))");
  }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ + name) << text; }

  // The status, and what was said.
  int run(const std::string& words) {
    Said said = shell("cd " + folder_ + " && " + PIZARRA_CELL + " " + words + " 2>&1");
    said_ = std::move(said.text);
    return said.status;
  }

  const std::string folder_ = scratch_folder() + "check/";
  std::string said_;
};

TEST_F(Check, SaysWhichCellNamesADomainThatIsNotThere) {
  write("lost.scm", "(cell lost (world (cube circle (at 450 0))) (domain \"no.scm\"))");
  EXPECT_EQ(run("check lost.scm"), 2);
  EXPECT_EQ(said_, "pizarra: the domain of the cell lost: there is no file no.scm\n");
}

TEST_F(Check, ReadsPlanningFilesAgainstTheDomainBeforeThem) {
  write("d.pddl", "(define (domain d) (:predicates (p ?x)) (:action a :parameters (?x) :effect (p ?x)))");
  write("p.pddl", "(DEFINE (problem q) (:domain d) (:objects o) (:init) (:goal (and (p o))))");
  write("bad.pddl", "(define (problem q) (:domain d) (:objects o) (:init (q o)) (:goal (p u)))");
  EXPECT_EQ(run("check d.pddl p.pddl"), 0) << said_;
  EXPECT_EQ(said_, "d.pddl: domain d: 1 predicate, 1 action\np.pddl: problem: 1 object, 0 facts, 1 goal\n");
  EXPECT_EQ(run("check p.pddl --domain d.pddl"), 0) << said_;
  EXPECT_EQ(run("check p.pddl"), 2);
  EXPECT_NE(said_.find("belongs to a domain"), std::string::npos) << said_;
  EXPECT_EQ(run("check d.pddl bad.pddl"), 2);
  EXPECT_NE(said_.find("there is no predicate q"), std::string::npos) << said_;
  EXPECT_NE(said_.find("there is no object u"), std::string::npos) << said_;
}

TEST_F(Check, ReadsTheThesisOperatorsAndFacts) {
  write("operators", "(operator GO (params (<x> T)) (preconds (p <x>)) (effects (q <x>) (del (p <x>))))");
  write("facts", "(types (a T)) (initials (p a)) (goals (q a))");
  EXPECT_EQ(run("check operators facts"), 0) << said_;
  EXPECT_EQ(said_, "operators: 1 operator\nfacts: problem: 1 object, 1 fact, 1 goal\n");
}

TEST_F(Check, FindsTheObjectsThatOperatorsNameAndTheFactsDoNot) {
  write("operators", "(operator GO (params (<x> T))\n (preconds (p tabel)) (effects (q <x>)))");
  write("facts", "(types (table T)) (initials (p table)) (goals (q table))");
  EXPECT_EQ(run("check operators facts"), 2);
  EXPECT_NE(said_.find("there is no object tabel; the nearest is table\noperators:2:15"), said_.npos) << said_;
}

TEST_F(Check, ReadsAProblemAlsoWhereItsDomainIsWrong) {
  write("d.pddl", "(define (domain d) (:predicates (p ?x))\n (:action a :parameters (?x) :effect (q ?x)))");
  write("p.pddl", "(define (problem q) (:domain d) (:objects o)\n (:init (p u)) (:goal (p o)))");
  write("good.pddl", "(define (problem q) (:domain d) (:objects o) (:goal (p o)))");
  EXPECT_EQ(run("check d.pddl p.pddl good.pddl"), 2);
  EXPECT_NE(said_.find("there is no predicate q; the nearest is p\nd.pddl:2:39"), said_.npos) << said_;
  EXPECT_NE(said_.find("there is no object u; the nearest is o\np.pddl:2:12"), said_.npos) << said_;
  EXPECT_NE(said_.find("good.pddl: nothing wrong is found, as far as its domain can be understood"), said_.npos)
      << said_;
  write("operators", "(operator GO (params (<x> T))\n (preconds (p tabel)) (effects (q <y>)))");
  write("facts", "(types (table T)) (initials (p table)) (goals (q tble))");
  EXPECT_EQ(run("check operators facts"), 2);
  EXPECT_NE(said_.find("there is no object tabel; the nearest is table (and 1 more)\noperators:2:15"), said_.npos)
      << said_;
  EXPECT_NE(said_.find("there is no object tble; the nearest is table\nfacts:1:50"), said_.npos) << said_;
}

TEST_F(Check, FindsABadDomainFromEveryFileThatLeadsToIt) {
  for (const char* file : {"domain.scm", "cell.scm", "story.scm"}) {
    EXPECT_EQ(run(std::string("check ") + file), 2) << said_;
    EXPECT_NE(said_.find("domain.scm:"), std::string::npos) << said_;
    EXPECT_NE(said_.find("JUMP"), std::string::npos) << said_;
  }
}

TEST_F(Check, NothingBeginsWithABadDomain) {
  for (const char* words : {"demo cell.scm", "demo cell.scm --goal '(on-table circle)'", "scenario story.scm",
                            "demo cell.scm --random --seeds 2", "up cell.scm"}) {
    EXPECT_EQ(run(words), 2) << words << "\n" << said_;
    EXPECT_NE(said_.find("domain.scm:"), std::string::npos) << words << "\n" << said_;
    EXPECT_EQ(said_.find("does not come up"), std::string::npos) << words << "\n" << said_;
  }
}

TEST_F(Check, AcceptsTheNoisiestCameraThatACellMayHave) {
  std::filesystem::copy_file(source_dir() + "/domains/blocks.scm", folder_ + "domain.scm",
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(run("check domain.scm cell.scm story.scm"), 0) << said_;
}

}  // namespace
}  // namespace pizarra::programs
