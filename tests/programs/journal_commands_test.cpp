// The files that a run leaves behind, and the commands that ask them: the journal of `demo`, `ask --journal`, `replay`.

#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

Said run(const std::string& words) { return shell_in_scratch(std::string(PIZARRA_CELL) + " " + words); }

TEST(JournalWords, TheSameSeedGivesTheSameJournalByteForByte) {
  const auto journal_of = [](const std::string& options) {
    const std::string file = scratch_folder() + "journal";
    run("demo --png '' --goal '(on circle triangle)' --journal " + file + " " + options);
    return whole_file(file);
  };
  const std::string seven = journal_of("--seed 7");
  EXPECT_GT(seven.size(), 1000U);
  EXPECT_TRUE(seven == journal_of("--seed 7"));
  EXPECT_FALSE(seven == journal_of("--seed 8"));
}

std::string journal_of_modes() {
  std::string path = scratch_folder() + "modes.txt";
  std::ofstream(path) << "(0 0 \"alice\" (declare (relation mode ((name symbol)) (key))))\n"
                         "(1 1000000 \"alice\" (tell 1 (mode idle)))\n"
                         "(2 2000000 \"bob\" (retract 1) (tell 2 (mode ready)))\n"
                         "(3 3000000 \"bob\" (retract 2))\n";
  return path;
}

TEST(JournalWords, AskAnswersFromAJournalWhatHeldThen) {
  const std::string ask = "ask --journal " + journal_of_modes();
  EXPECT_EQ(run(ask + " '(mode ?m)'").text, "no\n");
  for (const char* moment : {"1", "@1.5", "2s"}) {
    EXPECT_EQ(run(ask + " --at " + moment + " '(mode ?m)'").text, "?m = idle\n") << moment;
  }
  EXPECT_EQ(run(ask + " --at @3 --json '(mode ?m)'").text, "{\"revision\":3,\"answers\":[]}\n");
  for (const char* later : {"1970-01-02T00:00:00", "@3.1", "4"}) {
    const Said refused = run(ask + " --at " + later + " '(mode ?m)'");
    EXPECT_EQ(refused.status, 2) << refused.text;
    EXPECT_TRUE(contains(refused, later[0] == '4' ? "the newest is 3" : "later than the end")) << refused.text;
  }
  EXPECT_EQ(run(ask + " --at '' '(mode ?m)'").status, 2);
  const Said soon = run(ask + " --at soon '(mode ?m)'");
  EXPECT_EQ(soon.status, 2);
  EXPECT_TRUE(contains(soon, "a moment is")) << soon.text;
}

TEST(JournalWords, ReplayStepsAsksWatchesAndGoesBack) {
  const std::string replay = "replay " + journal_of_modes() + " --at 1";
  const Said said = run(replay + " --eval '(moment)' --eval '(watch (mode ?x))' --eval '(step)' --eval '(play 1000)'" +
                        " --eval '(at 2)' --eval '(ask (mode ?m))'");
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.text,
            "revision 1 at @1.000000\nwatch 1\n[1] + ?x = idle\nrevision 2 at @2.000000\n[1] - ?x = idle\n"
            "[1] + ?x = ready\nrevision 3 at @3.000000\n[1] - ?x = ready\nrevision 2 at @2.000000\n?m = ready\n");
  for (const char* steps : {"-3", "0", "1.5", "two", "(2)"}) {
    const Said refused = run(replay + " --eval '(step " + steps + ")' --eval '(moment)'");
    EXPECT_EQ(refused.status, 2) << steps;
    EXPECT_EQ(refused.text, "(step N) takes a whole number above 0\n") << "and nothing moved";
  }
  const Said told = run(replay + " --eval '(tell (mode busy))'");
  EXPECT_EQ(told.status, 1);
  EXPECT_TRUE(contains(told, "a recorded board cannot be changed")) << told.text;
  for (const char* moment : {"\"\"", "4", "soon", "\"2026-02-30T00:00:00\""}) {
    EXPECT_NE(run(replay + " --eval '(at " + moment + ")'").status, 0) << moment;
  }
  EXPECT_EQ(run("replay " + journal_of_modes() + " --at ''").status, 2);
  EXPECT_EQ(run("replay " + scratch_folder()).status, 2);
}

}  // namespace
}  // namespace pizarra::programs
