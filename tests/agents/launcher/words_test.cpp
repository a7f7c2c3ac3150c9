// The program as a person meets it at the shell: what it says and how it ends.

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/agents/launcher/running.hpp"
#include "tests/agents/launcher/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra {
namespace {

Said run(const std::string& words) {
  return shell("cd " + scratch_folder() + " && " + PIZARRA_CELL + " " + words + " 2>&1");
}

bool contains(const Said& said, const std::string& text) { return said.text.find(text) != std::string::npos; }

TEST(Words, EveryWordHelps) {
  for (const char* word :
       {"demo",    "scenario", "check", "up",   "ps",  "down", "agent", "world",  "repl",   "tell",
        "retract", "ask",      "watch", "look", "top", "goal", "why",   "replay", "shapes", "calibrate"}) {
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
  for (const char* words : {"", "demo one two", "demo --goal", "agent rob x", "--jsn", "demo --seeds 0 --random"}) {
    const Said said = run(words);
    EXPECT_EQ(said.status, 2) << words;
    EXPECT_TRUE(said.text.starts_with("pizarra: ")) << said.text;
    EXPECT_EQ(said.text.find('\n'), said.text.size() - 1) << said.text;
  }
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

TEST(Words, AFileThatCannotBeWrittenIsToldBeforeAnythingRuns) {
  for (const char* words : {"--video /proc/film.avi", "--journal /proc/journal", "--png /proc/view.png"}) {
    const Said said = run(std::string("demo ") + words);
    EXPECT_EQ(said.status, 4) << words << said.text;
    EXPECT_TRUE(said.text.starts_with("pizarra: cannot write /proc/")) << said.text;
    EXPECT_EQ(said.text.find('\n'), said.text.size() - 1) << said.text;
  }
}

// What a full disk does, for files of more than some blocks of 512 bytes.
Said run_with_small_files(int blocks, const std::string& words) {
  return run("--help > /dev/null; trap '' XFSZ; ulimit -f " + std::to_string(blocks) + "; " + PIZARRA_CELL + " " +
             words);
}

TEST(Words, WhatCouldNotBeWrittenWholeIsToldWithItsPathAndReason) {
  const std::string soon_done = " --goal '(on-table circle)'";
  for (const char* words : {"--png '' --video film.avi", "--png '' --video film.mp4", "--png picture.png",
                            "--png '' --journal journal.txt"}) {
    const Said said = run_with_small_files(40, std::string("demo ") + words + soon_done);
    const std::string file = std::string(words).substr(std::string(words).rfind(' ') + 1);
    EXPECT_EQ(said.status, 4) << said.text;
    const std::string last = said.text.substr(said.text.rfind('\n', said.text.size() - 2) + 1);
    EXPECT_TRUE(last.starts_with("pizarra: cannot write " + file + " whole: File too large")) << said.text;
    EXPECT_FALSE(contains(said, "libpng")) << said.text;
  }
}

TEST(Words, AFilmIsWholeAlsoWhenNobodyReadsTheStory) {
  const Said said = run("demo --png '' --video unread.avi --goal '(on-table circle)' | head -n 1");
  EXPECT_NE(text_of(scratch_folder() + "unread.avi").find("idx1"), std::string::npos) << said.text;
}

// They take four times the memory of all else that an agent needs.
TEST(Words, AnAgentLoadsNoLibraryThatOpensCamerasUnlessItHasOneOfItsOwn) {
  const std::string libraries = "ldd " + std::string(PIZARRA_AGENT);
  EXPECT_TRUE(contains(shell(libraries), "libopencv_core"));
  EXPECT_FALSE(contains(shell(libraries), "libopencv_videoio"));
  EXPECT_FALSE(contains(shell(libraries), "libopencv_imgcodecs"));
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

TEST(Words, ARefusalSaysEachFactOnce) {
  const Said said = run("demo --png '' --goal '(on circle triangle) (on triangle circle)'");
  EXPECT_TRUE(contains(said, "can never hold together from here")) << said.text;
  EXPECT_FALSE(contains(said, "from here:")) << said.text;
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

TEST(Words, AnEmptyGoalIsMalformedInTheSameWordsEverywhere) {
  for (const char* words : {"demo --goal ''", "goal ''", "goal ' '"}) {
    const Said said = run(words);
    EXPECT_EQ(said.status, 2) << words;
    EXPECT_EQ(said.text, "pizarra: nothing is typed: a goal is FACT, (and FACT ...) or several FACTs\n") << words;
  }
}

TEST(Words, AnArmThatTheTaskCannotBeDoneWithIsRefusedAtOnce) {
  for (const char* words : {"demo --arm gantry", "demo --random --seeds 2 --arm gantry"}) {
    const Said said = run(words);
    EXPECT_EQ(said.status, 2) << words;
    EXPECT_TRUE(contains(said, "the coordinator needs an arm that turns, and the arm gantry has no such axis"))
        << said.text;
  }
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

TEST(Words, AnInterruptedCountOfSeedsIsSummedUp) {
  const std::string log = scratch_folder() + "seeds.txt";
  Running seeds({PIZARRA_CELL, "demo", "--random", "--seeds", "1000", "--jobs", "1"}, log);
  ASSERT_TRUE(
      wait_until([&] { return seeds.said().find("seed     1") != std::string::npos; }, std::chrono::seconds(60)));
  seeds.signal(SIGINT);
  EXPECT_EQ(seeds.end(std::chrono::seconds(20)), 130);
  const std::string said = seeds.said();
  EXPECT_NE(said.find("\nreached "), std::string::npos) << said;
  EXPECT_TRUE(said.ends_with(" of 1000 seeds\n")) << said;
}

TEST(Words, AnAnswerThatCannotBeWrittenIsNoSuccess) {
  const std::string tree = source_dir();
  for (const std::string& words : {std::string("demo --png '' --goal '(on-table circle)'"), std::string("--help"),
                                   "check " + tree + "/examples/01-blocks/cell.scm", std::string("ps"),
                                   "scenario --quiet " + tree + "/tests/scenarios/01-undisturbed.scm"}) {
    const Said said = shell(std::string(PIZARRA_CELL) + " " + words + " 2>&1 >/dev/full");
    EXPECT_EQ(said.status, 4) << words;
    EXPECT_EQ(said.text, "pizarra: cannot write standard output whole: No space left on device\n") << words;
  }
}

// The status of a command whose output is read to its first line alone.
Said first_line_of(const std::string& words) {
  return shell("bash -c '" PIZARRA_CELL " " + words + " 2>&1 | head -n 1 >/dev/null; exit ${PIPESTATUS[0]}'");
}

TEST(Words, AnOutputThatIsNotReadAnyMoreEndsAsAnInterruption) {
  EXPECT_EQ(first_line_of("demo --random --seeds 1000 --jobs 1").status, 130);
  // More than a pipe holds, so that its reader is gone before the last of it is written.
  std::string much = "repl --agents planner";
  for (int i = 0; i < 100; ++i) much += " --eval \"(help)\"";
  EXPECT_EQ(first_line_of(much).status, 130);
}

TEST(Words, SeedsWhoseLinesAreNotReadAnyMoreAreSummedUpOnStandardError) {
  const Said said =
      shell(std::string("(") + PIZARRA_CELL + " demo --random --seeds 1000 --jobs 1 | head -n 1 >/dev/null) 2>&1");
  EXPECT_TRUE(contains(said, "reached ")) << said.text;
  EXPECT_TRUE(contains(said, "; interrupted after ")) << said.text;
}

TEST(Words, TheVersionIsThatOfTheTree) {
  const Said said = run("--version");
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.text, "pizarra " PIZARRA_VERSION "\n");
  EXPECT_EQ(run("--help > /dev/null; " + source_dir() + "/pizarra --version").text, said.text);
}

TEST(Words, ARefusedGoalOfAStoryIsShownWithACaretToo) {
  const std::string folder = scratch_folder() + "refused-story/";
  std::filesystem::create_directory(folder);
  std::ofstream(folder + "cell.scm") << "(cell c (world (cube circle (at 450 0)) (cube cross (at 450 150))) (domain \""
                                     << source_dir() << "/domains/blocks.scm\"))\n";
  std::ofstream(folder + "story.scm") << "(scenario \"neither way\" (cell \"cell.scm\")\n"
                                         "  (goal (on circle cross) (on cross circle)) (expect reached) (within 60))\n";
  const Said said = run("demo --png '' " + folder + "cell.scm");
  EXPECT_EQ(said.status, 3) << said.text;
  EXPECT_TRUE(contains(said, "goal:1:1\n  (on circle cross) (on cross circle)\n  ^\n")) << said.text;
}

TEST(Words, WithoutAStoryBesideTheCellAGoalIsAskedFor) {
  const std::string file = scratch_folder() + "lone-cell.scm";
  std::ofstream(file) << "(cell c (world (cube circle (at 450 0))) (domain \"" << source_dir()
                      << "/domains/blocks.scm\"))\n";
  const Said said = run("demo " + file);
  EXPECT_EQ(said.status, 2) << said.text;
  EXPECT_TRUE(contains(said, "--goal")) << said.text;
}

TEST(Words, AMalformedGoalIsToldAtItsPlaceBeforeAnythingRuns) {
  const Said said = run("demo --goal '(on circle'");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "^")) << said.text;
  EXPECT_FALSE(contains(said, "robot is there")) << said.text;
}

TEST(Words, AnUnknownPredicateIsToldWithTheNearest) {
  const Said said = run("demo --goal '(onn circle triangle)'");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "nearest is on")) << said.text;
}

TEST(Words, AGoalWithAnUnknownObjectIsRefusedBeforeAnythingRuns) {
  const Said said = run("demo --png unknown/view.png --goal '(on circle traingle)'");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "nearest is triangle")) << said.text;
  EXPECT_TRUE(contains(said, "goal:1:12\n")) << said.text;
  EXPECT_FALSE(contains(said, " s  ")) << "nothing was played: " << said.text;
  EXPECT_FALSE(std::filesystem::exists(scratch_folder() + "unknown")) << "nothing was written";
}

TEST(Words, AnUnreachableGoalIsRefusedAndNothingMoves) {
  const Said said = run("demo --png '' --goal '(on circle triangle) (on triangle circle)'");
  EXPECT_EQ(said.status, 3);
  EXPECT_FALSE(contains(said, "operation ")) << said.text;
}

TEST(Words, ARefusedGoalIsShownWithACaretAtTheFirstFactThatCannotHold) {
  const Said both = run("demo --png '' --goal '(on-table cross) (on circle triangle) (on triangle circle)'");
  EXPECT_EQ(both.status, 3) << both.text;
  EXPECT_TRUE(contains(both, "goal:1:18\n  (on-table cross) (on circle triangle) ")) << both.text;
  EXPECT_TRUE(contains(both, "\n                   ^\n")) << both.text;
  const Said alone = run("demo --png '' --goal '(on Circle circle)'");
  EXPECT_EQ(alone.status, 3) << alone.text;
  EXPECT_TRUE(contains(alone, "goal:1:1\n  (on Circle circle)\n  ^\n")) << alone.text;
}

TEST(Words, ADemoSaysItsGoalOnce) {
  const Said said = run("demo --png '' --goal '(on-table circle)'");
  const std::size_t first = said.text.find(" s  goal ");
  ASSERT_NE(first, std::string::npos) << said.text;
  EXPECT_EQ(said.text.find(" s  goal ", first + 1), std::string::npos) << said.text;
}

TEST(Words, ARefusalIsToldOnce) {
  const Said said = run("demo --png '' --goal '(on circle triangle) (on triangle circle)'");
  const std::size_t first = said.text.find("no plan");
  EXPECT_NE(first, std::string::npos) << said.text;
  EXPECT_EQ(said.text.find("no plan", first + 1), std::string::npos) << said.text;
}

TEST(Words, ASignalEndsTheDemoInOrderWithItsFilmAndJournalWhole) {
  const std::string base = scratch_folder() + "stopped";
  const std::string film = base + ".avi";
  const std::string journal = base + ".txt";
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t demo = fork();
    if (demo == 0) {
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDOUT_FILENO);
      execl(PIZARRA_CELL, PIZARRA_CELL, "demo", "--png", "", "--video", film.c_str(), "--journal", journal.c_str(),
            nullptr);
      _exit(127);
    }
    // Its journal shows when the story has begun.
    std::error_code error;
    for (int n = 0; n < 400 && (std::filesystem::file_size(journal, error) == 0 || error); ++n) usleep(20'000);
    kill(demo, signal);
    int status = 0;
    waitpid(demo, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 130) << status;
    EXPECT_NE(text_of(film).find("idx1"), std::string::npos) << "the film has no index";
    EXPECT_TRUE(text_of(journal).ends_with(")\n"));
    std::filesystem::remove(journal);
  }
  std::filesystem::remove(film);
}

std::string pair_with(const std::string& sections) {
  const std::string file = scratch_folder() + "pair.scm";
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

TEST(Words, CheckFindsTheShippedFilesInOrder) {
  const std::string top = source_dir();
  const Said said =
      run("check " + top + "/domains/*.scm " + top + "/examples/*/*.scm " + top + "/tests/scenarios/*.scm");
  EXPECT_EQ(said.status, 0) << said.text;
}

TEST(Words, WithoutARunningCellTheBoardWordsSaySo) {
  for (const char* words : {"ask '(on ?x ?y)'", "why", "goal '(on a b)'"}) {
    const Said answer = run(std::string(words) + " --cell no-such-cell");
    EXPECT_EQ(answer.status, 4) << answer.text;
    EXPECT_TRUE(contains(answer, "no cell named no-such-cell runs here")) << answer.text;
  }
}

TEST(Words, TheSameSeedGivesTheSameJournalByteForByte) {
  const auto journal_of = [](const std::string& options) {
    const std::string file = scratch_folder() + "journal";
    run("demo --png '' --goal '(on circle triangle)' --journal " + file + " " + options);
    return text_of(file);
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

TEST(Words, AskAnswersFromAJournalWhatHeldThen) {
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

TEST(Words, ReplayStepsAsksWatchesAndGoesBack) {
  const std::string replay = "replay " + journal_of_modes() + " --at 1";
  const Said said = run(replay + " --eval '(moment)' --eval '(watch (mode ?x))' --eval '(step)' --eval '(play 1000)'" +
                        " --eval '(at 2)' --eval '(ask (mode ?m))'");
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.text,
            "revision 1 at @1.000000\nwatch 1\n[1] + ?x = idle\nrevision 2 at @2.000000\n[1] - ?x = idle\n"
            "[1] + ?x = ready\nrevision 3 at @3.000000\n[1] - ?x = ready\nrevision 2 at @2.000000\n?m = ready\n");
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
}  // namespace pizarra
