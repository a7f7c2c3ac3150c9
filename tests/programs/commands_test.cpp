// The program as a person meets it at the shell: what it says and how it ends.

#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

Said run(const std::string& words) { return shell_in_scratch(std::string(PIZARRA_CELL) + " " + words); }

TEST(Words, EveryWordHelps) {
  for (const char* word : {"demo",  "scenario", "chaos",   "check",  "up",      "ps",        "down",  "agent",
                           "world", "repl",     "declare", "tell",   "retract", "ask",       "watch", "look",
                           "top",   "goal",     "why",     "replay", "shapes",  "calibrate", "find",  "measure"}) {
    const bool is_process = word == std::string("agent") || word == std::string("world");
    const Said said = is_process ? shell(std::string(PIZARRA_AGENT) + " " + word + " --help 2>&1")
                                 : run(std::string(word) + " --help");
    EXPECT_EQ(said.status, 0) << word;
    EXPECT_TRUE(contains(said, "pizarra " + std::string(word))) << said.text;
    EXPECT_TRUE(contains(said, "Example:\n  ./pizarra " + std::string(word))) << said.text;
  }
}

TEST(Words, FormsThatArePipedInAreReadOneByOneAndAFaultSpoilsOnlyItsOwn) {
  const std::string typed = scratch_folder() + "piped-forms";
  std::ofstream(typed)
      << "(nonsense)\n(ask (and (agent ?a ?kind ?h)\n          (= ?kind planner)))\n(ask (contract planner";
  const Said said = run("repl --agents planner < " + typed);
  EXPECT_TRUE(contains(said, "nonsense")) << said.text;
  EXPECT_TRUE(contains(said, "?kind = planner")) << said.text;
  EXPECT_TRUE(contains(said, "(ask (contract planner")) << "the form without an end is told too: " << said.text;
  EXPECT_EQ(said.status, 2) << "that of the first form that failed";
}

TEST(Words, ARandomStoryThatEndsWhileItsEventIsInHandIsToldToItsEnd) {
  const Said said = run("demo --random --seed 30083 --png ''");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "faster than real time")) << said.text;
}

TEST(Words, AnUnknownWordOrOptionIsAUsageError) {
  EXPECT_EQ(run("dmeo").status, 2);
  EXPECT_EQ(run("demo --sed 3").status, 2);
  EXPECT_EQ(run("demo /nowhere/cell.scm").status, 2);
}

TEST(Words, AnUnknownOptionIsNamedWithTheNearest) {
  const Said said = run("demo --sed 3");
  EXPECT_TRUE(contains(said, "--sed;")) << said.text;
  EXPECT_TRUE(contains(said, "did you mean --seed?")) << said.text;
}

TEST(Words, AWrongCommandLineIsToldInOneLineWithTheNearestWord) {
  const Said word = run("dmeo");
  EXPECT_EQ(word.text, "pizarra: there is no word dmeo; did you mean demo?\n");
  for (const char* words : {"", "demo one two", "demo --goal", "agent rob x", "--jsn", "demo --seeds 0 --random",
                            "top --interval nan", "look x --timeout nan", "top --interval inf"}) {
    const Said said = run(words);
    EXPECT_EQ(said.status, 2) << words;
    EXPECT_TRUE(said.text.starts_with("pizarra: ")) << said.text;
    EXPECT_EQ(said.text.find('\n'), said.text.size() - 1) << said.text;
  }
}

TEST(Words, AnUnknownAgentIsToldWithTheNearestOrAllThatThereAre) {
  EXPECT_EQ(run("repl --agents robto").text, "pizarra: --agents: there is no agent robto; did you mean robot?\n");
  const Said far = run("repl --agents wheel");
  EXPECT_EQ(far.status, 2);
  EXPECT_TRUE(contains(far, "there is no agent wheel; there are robot, vision, ")) << far.text;
}

TEST(Words, AnEmptyFileIsSaidToBeEmpty) {
  const std::string file = scratch_folder() + "empty.scm";
  std::ofstream(file).close();
  EXPECT_EQ(run("check " + file).text, "pizarra: " + file + ": nothing is written here\n");
}

TEST(Words, TheCommandItselfNamesTheNearestWord) {
  const Said said = run("--help >/dev/null; " + source_dir() + "/pizarra sceanrio");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "did you mean scenario?")) << said.text;
}

TEST(Words, WhatIsNoCellIsSaidToBeNone) {
  const Said said = run("demo " + source_dir() + "/domains/blocks.scm");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "(cell ")) << said.text;
  EXPECT_FALSE(contains(said, "story.scm")) << said.text;
}

// They are two hundred libraries.
TEST(Words, NoProgramStartsWithTheLibrariesThatOpenFilmsAndCameras) {
  for (const std::string program : {PIZARRA_AGENT, PIZARRA_CELL}) {
    const Said libraries = shell("ldd " + program);
    EXPECT_TRUE(contains(libraries, "libopencv_core")) << program;
    EXPECT_FALSE(contains(libraries, "libopencv_videoio")) << program;
    EXPECT_FALSE(contains(libraries, "libopencv_imgcodecs")) << program;
  }
}

TEST(Words, AnAgentWithoutABoardSaysOnceWhatItWaitsFor) {
  const std::string address = "ipc://" + scratch_folder() + "no-board";
  const std::string cell = source_dir() + "/examples/01-blocks/cell.scm";
  const Said said = shell_in_scratch("timeout 4 " PIZARRA_AGENT " agent planner " + cell + " --board " + address);
  EXPECT_EQ(said.text, "pizarra: no board answers at " + address + " yet: waiting for it\n");
}

TEST(Words, TheWorldListensOnThisMachineAlone) {
  const Said said = shell(std::string(PIZARRA_AGENT) + " world " + source_dir() +
                          "/examples/01-blocks/cell.scm --listen tcp://127.0.0.1:7999 2>&1");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "ipc://")) << said.text;
}

TEST(Words, AFormThatCannotBeReadIsShownAsItWasTyped) {
  const Said said = run("ask '(on ?x ?y'");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "input:1:1\n  (on ?x ?y\n  ^\n")) << said.text;
}

TEST(Words, AQueryWithoutParenthesesIsAnsweredByAnExample) {
  for (const char* words : {"ask 'on ?x ?y'", "ask on", "ask '(on ?x ?y) (clear ?x)'"}) {
    const Said said = run(words);
    EXPECT_EQ(said.status, 2) << words;
    EXPECT_EQ(said.text, "pizarra: ask takes one QUERY in parentheses: pizarra ask '(and (on ?x ?y) (clear ?x))'\n");
  }
}

TEST(Words, AFileThatIsNotThereIsNamed) {
  EXPECT_TRUE(contains(run("demo no-such.scm"), "CELL: there is no file no-such.scm; pizarra demo --help says more"));
  EXPECT_TRUE(contains(run("demo /tmp"), "CELL: this is a folder, not a file: /tmp; pizarra demo --help says more"));
}

TEST(Words, AFailureIsJsonForPrograms) {
  const Said unread = run("ask --json '(on ?x ?y'");
  EXPECT_EQ(unread.status, 2);
  EXPECT_TRUE(unread.text.starts_with("{\"error\":{\"symbol\":\"unclosed-list\",")) << unread.text;
  const Said nobody = run("why --json --cell no-such-cell");
  EXPECT_EQ(nobody.status, 4);
  EXPECT_EQ(nobody.text,
            "{\"error\":{\"symbol\":\"nothing-runs\",\"sentence\":\"no cell named no-such-cell runs here\",\"subject\":"
            "null}}\n");
}

TEST(Words, OneThingIsCountedAsOne) {
  const Said said = run("check " + source_dir() + "/examples/01-blocks/cell.scm");
  EXPECT_TRUE(contains(said, "4 cubes, 1 host;")) << said.text;
}

TEST(Words, AnOptionThatWouldHaveNoEffectIsRefusedAndNothingRuns) {
  const std::string places = source_dir() + "/examples/02-numbered-places/cell.scm";
  for (const std::string& words :
       {std::string("--random --goal '(on circle triangle)'"), "--random --domain " + places, std::string("--seeds 3"),
        std::string("--first-seed 3"), std::string("--random --jobs 2"), std::string("--random --seeds 2 --seed 3"),
        std::string("--random --seeds 2 --journal j.txt"), std::string("--random --seeds 2 --video v.avi"),
        std::string("--random --seeds 2 --png p.png"), std::string("--random --seeds 2 --realtime"),
        std::string("--video film.mpg"), std::string("--png picture.pgn"), places + " --random",
        places + " --random --seeds 2"}) {
    const Said said = run("demo " + words);
    EXPECT_EQ(said.status, 2) << words << said.text;
    EXPECT_FALSE(contains(said, "is there")) << words << said.text;
  }
}

TEST(Words, ASeedThatIsNoWholeNumberOrTooLargeIsRefused) {
  for (const char* words :
       {"--seed -1", "--seed 1.5", "--seed 99999999999999999999", "--seed ''", "--random --seeds 2 --first-seed -1",
        "--random --seeds 2 --first-seed 18446744073709551615", "--random --seeds 0"}) {
    const Said said = run(std::string("demo ") + words);
    EXPECT_EQ(said.status, 2) << words << said.text;
    EXPECT_TRUE(contains(said, "seed")) << words << said.text;
    EXPECT_FALSE(contains(said, "is there")) << words << said.text;
  }
}

// A gantry has no axis that turns and a SCARA's tool always points down: both carry the gripper where it is needed.
TEST(Words, ArmsOfEveryBuildBuildTheTowerThatIsAskedFor) {
  const std::string deep = " --goal '(and (on square cross) (on cross triangle) (on triangle circle))'";
  for (const char* arm : {"gantry", "scara"}) {
    const std::string demo = std::string("demo --arm ") + arm;
    for (const std::string& words : {std::string(" --seed 3"), " --seed 12" + deep, std::string(" --seed 40")}) {
      const Said said = run(demo + words);
      EXPECT_EQ(said.status, 0) << demo << words << "\n" << said.text;
    }
  }
}

TEST(Words, AnArmWithoutANameIsRefused) {
  const Said nameless = run("demo --arm ''");
  EXPECT_EQ(nameless.status, 2);
  EXPECT_EQ(nameless.text, "pizarra: --arm '': an arm has a name, or a file\n");
}

TEST(Words, WhatIsForACellInThisProcessIsNotLeftOutWithoutAWord) {
  const std::string file = source_dir() + "/examples/01-blocks/cell.scm";
  for (const std::string& given : {file, std::string("--seed 7")}) {
    const Said said = run("repl --board ipc:///tmp/nobody " + given + " --eval '(help)'");
    EXPECT_EQ(said.status, 2) << said.text;
    EXPECT_TRUE(contains(said, " is for a cell in this process, and this prompt talks to one that runs already"))
        << said.text;
  }
}

TEST(Words, WhereNoCellOfThatNameRunsNoOtherTakesItsPlace) {
  for (const char* command : {"repl --cell no-such-cell --eval '(help)'", "console --cell no-such-cell"}) {
    const Said said = run(command);
    EXPECT_EQ(said.status, 4) << said.text;
    EXPECT_TRUE(contains(said, "no cell named no-such-cell runs here")) << said.text;
  }
}

TEST(Words, AReplayRefusesWhatItWouldLeaveOut) {
  const Said beyond = run("chaos --replay 7 --faults 99");
  EXPECT_EQ(beyond.status, 2);
  EXPECT_TRUE(contains(beyond, "counted from 0, and none is number 99")) << beyond.text;
  EXPECT_EQ(run("chaos --runs 1 --video film.avi").status, 2);
  for (const char* of_many : {"--coverage points.txt", "--runs 9", "--first-seed 4", "--jobs 3", "--no-shrink"}) {
    const Said said = run(std::string("chaos --replay 7 --faults none ") + of_many);
    EXPECT_EQ(said.status, 2) << of_many;
    EXPECT_TRUE(contains(said, "excludes")) << said.text;
  }
  const Said all = run("chaos --replay 7 --faults none --plant all");
  EXPECT_EQ(all.status, 2);
  EXPECT_TRUE(contains(all, "with --replay, --plant names one fault")) << all.text;
}

TEST(Words, ASearchForAPlantedFaultRefusesWhatItWouldLeaveOut) {
  for (const char* of_runs : {"--coverage points.txt", "--reference " PIZARRA_CELL, "--no-shrink"}) {
    const Said said = run(std::string("chaos --plant plan-not-kept --runs 1 ") + of_runs);
    EXPECT_EQ(said.status, 2) << of_runs;
    EXPECT_TRUE(contains(said, "excludes")) << said.text;
  }
}

TEST(Words, APromptHasTheAgentsThatItsCellNamesAndNoOthers) {
  const std::string file = scratch_folder() + "alone.scm";
  std::ofstream(file) << "(cell alone (world (cube circle (at 450 0))) (host \"desk\" (agents robot)))";
  const Said said = run("repl " + file + " --eval '(ask (agent ?n ?k ?h))'");
  EXPECT_TRUE(contains(said, "?n = robot\n")) << said.text;
  for (const char* kind : {"person", "vision", "planner", "coordinator"}) {
    EXPECT_FALSE(contains(said, "?n = " + std::string(kind))) << said.text;
  }
}

TEST(Words, AnUnreachablePointIsSaidOnceInTenthsOfMillimetres) {
  const Said said = run("repl --agents robot --eval '(robot (do-action \"(move 1450.123456789 0 200)\"))'");
  EXPECT_EQ(said.status, 1);
  EXPECT_TRUE(
      said.text.starts_with("the arm cannot reach this point with this tool direction, x leads out of its "
                            "reach: (point 589.9 0.0 367.2)"))
      << said.text;
}

TEST(Words, TheVersionIsThatOfTheTree) {
  const Said said = run("--version");
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.text, "pizarra " PIZARRA_VERSION "\n");
  EXPECT_EQ(run("--help > /dev/null; " + source_dir() + "/pizarra --version").text, said.text);
}

std::string pair_with(const std::string& sections) {
  std::string file = scratch_folder() + "pair.scm";
  std::ofstream(file) << "(cell words-pair (world (cube circle (at 450 -60))) (domain \"" << source_dir()
                      << "/domains/blocks.scm\") " << sections << ")\n";
  return file;
}

TEST(Words, UpEndsAtOnceWithTheBoardsReasonWhereItsAddressCannotBeUsed) {
  const Said said = run("up " + pair_with("(board \"localhost\" \"tcp://0.0.0.0:7800\")"));
  EXPECT_EQ(said.status, 4) << said.text;
  EXPECT_TRUE(contains(said, "give --insecure")) << said.text;
  EXPECT_FALSE(contains(said, "starts again")) << said.text;
}

TEST(Words, UpRefusesDevicesOnAHostThatTheWorldIsNotOn) {
  const std::string cell = pair_with("(host \"localhost\" (agents planner)) (host \"other\" (agents robot))");
  const Said said = run("up " + cell + " --host other");
  EXPECT_EQ(said.status, 2) << said.text;
  EXPECT_TRUE(contains(said, "robot needs the simulated world")) << said.text;
}

TEST(Words, AnArmThatNoDriverKnowsIsRefusedWithTheKnownOnes) {
  const Said said = run("demo " + pair_with("(arm crs-f4)") + " --goal '(on-table circle)'");
  EXPECT_EQ(said.status, 2) << said.text;
  EXPECT_TRUE(contains(said, "crs-f3")) << said.text;
}

TEST(Words, AnotherArmOfTheSameCellReachesTheSameGoal) {
  for (const char* arm : {"t265", "up6"}) {
    const Said said = run(std::string("demo --arm ") + arm + " --goal '(holding circle)' --png ''");
    EXPECT_EQ(said.status, 0) << said.text;
    EXPECT_TRUE(contains(said, arm)) << said.text;
  }
  const Said said = run("demo --arm up7 --png ''");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "motoman-up6")) << said.text;
}

TEST(Words, AConditionThatIsNoQueryIsToldAtItsPlace) {
  const std::string file = scratch_folder() + "wrong-when.scm";
  std::ofstream(file) << "(scenario \"s\"\n  (cell \"" << pair_with("") << "\")\n  (goal (on-table circle))\n"
                      << "  (when (and (on circle ?x) (< ?y 3)) (wait 1)))\n";
  const Said said = run("scenario " + file);
  EXPECT_EQ(said.status, 2) << said.text;
  EXPECT_TRUE(contains(said, ":4:9")) << said.text;
}

TEST(Words, CheckTellsEveryErrorOfACellFile) {
  const std::string file = scratch_folder() + "wrong-cell.scm";
  std::ofstream(file) << "(cell c\n  (world (cube circle (at 9999 0)) (cube star (at 450 0)))\n  (amr crs-f3))\n";
  const Said said = run("check " + file);
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, ":2:")) << said.text;
  EXPECT_TRUE(contains(said, ":3:")) << said.text;
  EXPECT_TRUE(contains(said, "nearest is arm")) << said.text;
}

TEST(Words, CheckWarnsOfACubeThatTheImagesDoNotShow) {
  const std::string file = scratch_folder() + "beside.scm";
  std::ofstream(file) << "(cell c (world (cube circle (at 450 0)) (cube star (on circle)) (cube cross (at 450 330))"
                      << " (cube square (on cross))) (domain \"" << source_dir() << "/domains/blocks.scm\"))";
  const Said said = run("check " + file);
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "beside.scm: warning: the images do not show all of the cube cross ")) << said.text;
  EXPECT_TRUE(contains(said, "the cube square ")) << said.text;
  EXPECT_FALSE(contains(said, "circle")) << said.text;
  EXPECT_FALSE(contains(said, "star")) << said.text;
}

TEST(Words, CheckFindsTheShippedFilesInOrder) {
  const std::string top = source_dir();
  const Said said =
      run("check " + top + "/domains/*.scm " + top + "/examples/*/*.scm " + top + "/tests/scenarios/*.scm");
  EXPECT_EQ(said.status, 0) << said.text;
}

TEST(Words, WhoWaitsForABoardIsToldSoAndThenThatThereIsNone) {
  const std::string nobody = "ipc://" + scratch_folder() + "nobody.ipc";
  const Said early = shell(std::string("timeout 4 ") + PIZARRA_CELL + " ask --board " + nobody + " '(on ?x ?y)' 2>&1");
  EXPECT_TRUE(contains(early, "waiting for a board at " + nobody)) << early.text;
  const Said late = run("ask --board " + nobody + " '(on ?x ?y)'");
  EXPECT_EQ(late.status, 4) << late.text;
  EXPECT_TRUE(contains(late, "the board does not answer: \"" + nobody)) << late.text;
}

TEST(Words, UpRefusesKeysThatNobodyWouldComeWith) {
  const std::string alone = source_dir() + "/examples/01-blocks/cell.scm";
  const Said key = run("up " + alone + " --key desk.secret");
  EXPECT_EQ(key.status, 2);
  EXPECT_TRUE(contains(key, "--key is for a host that comes to the board of another")) << key.text;
  const Said keys = run("up " + alone + " --keys keys");
  EXPECT_EQ(keys.status, 2);
  EXPECT_TRUE(contains(keys, "the cell file names no such address")) << keys.text;
  const Said elsewhere = run("up " + alone + " --board ipc:///tmp/other.ipc --keys keys");
  EXPECT_EQ(elsewhere.status, 2);
  EXPECT_TRUE(contains(elsewhere, "this host does not run it")) << elsewhere.text;
}

TEST(Words, WithoutARunningCellTheBoardWordsSaySo) {
  for (const char* words : {"ask '(on ?x ?y)'", "why", "goal '(on a b)'"}) {
    const Said answer = run(std::string(words) + " --cell no-such-cell");
    EXPECT_EQ(answer.status, 4) << answer.text;
    EXPECT_TRUE(contains(answer, "no cell named no-such-cell runs here")) << answer.text;
  }
}

}  // namespace
}  // namespace pizarra::programs
