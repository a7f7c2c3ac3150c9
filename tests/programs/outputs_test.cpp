// What is written: files, films and standard output, whole or said not to be, also where the run is ended or not read.

#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

Said run(const std::string& words) { return shell_in_scratch(std::string(PIZARRA_CELL) + " " + words); }

TEST(Outputs, AFileThatCannotBeWrittenIsToldBeforeAnythingRuns) {
  for (const char* words : {"--video /proc/film.avi", "--journal /proc/journal", "--png /proc/view.png"}) {
    const Said said = run(std::string("demo ") + words);
    EXPECT_EQ(said.status, 4) << words << said.text;
    EXPECT_TRUE(said.text.starts_with("pizarra: cannot write /proc/")) << said.text;
    EXPECT_EQ(said.text.find('\n'), said.text.size() - 1) << said.text;
  }
}

// A full disk, for files of more than some blocks of 512 bytes.
Said run_with_small_files(int blocks, const std::string& words) {
  return run("--help > /dev/null; trap '' XFSZ; ulimit -f " + std::to_string(blocks) + "; " + PIZARRA_CELL + " " +
             words);
}

TEST(Outputs, WhatCouldNotBeWrittenWholeIsToldWithItsPathAndReason) {
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

TEST(Outputs, AFilmIsWholeAlsoWhenNobodyReadsTheStory) {
  const Said said = run("demo --png '' --video unread.avi --goal '(on-table circle)' | head -n 1");
  EXPECT_NE(whole_file(scratch_folder() + "unread.avi").find("idx1"), std::string::npos) << said.text;
}

TEST(Outputs, AnInterruptedCountOfSeedsIsSummedUp) {
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

TEST(Outputs, AnAnswerThatCannotBeWrittenIsNoSuccess) {
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

TEST(Outputs, AnOutputThatIsNotReadAnyMoreEndsAsAnInterruption) {
  EXPECT_EQ(first_line_of("demo --random --seeds 1000 --jobs 1").status, 130);
  // More than a pipe holds, so that its reader is gone before the last of it is written.
  std::string much = "repl --agents planner";
  for (int i = 0; i < 100; ++i) much += " --eval \"(help)\"";
  EXPECT_EQ(first_line_of(much).status, 130);
}

TEST(Outputs, SeedsWhoseLinesAreNotReadAnyMoreAreSummedUpOnStandardError) {
  const Said said =
      shell(std::string("(") + PIZARRA_CELL + " demo --random --seeds 1000 --jobs 1 | head -n 1 >/dev/null) 2>&1");
  EXPECT_TRUE(contains(said, "reached ")) << said.text;
  EXPECT_TRUE(contains(said, "; interrupted after ")) << said.text;
}

TEST(Outputs, ASignalEndsTheDemoInOrderWithItsFilmAndJournalWhole) {
  const std::string base = scratch_folder() + "stopped";
  const std::string film = base + ".avi";
  const std::string journal = base + ".txt";
  for (const int signal : {SIGINT, SIGTERM}) {
    Running demo({PIZARRA_CELL, "demo", "--png", "", "--video", film, "--journal", journal}, base + ".log");
    ASSERT_TRUE(wait_until([&] { return !whole_file(journal).empty(); }, std::chrono::seconds(20)))
        << "no story began: " << demo.said();
    demo.signal(signal);
    EXPECT_EQ(demo.end(std::chrono::seconds(20)), 130) << demo.said();
    EXPECT_NE(whole_file(film).find("idx1"), std::string::npos) << "the film has no index";
    EXPECT_TRUE(whole_file(journal).ends_with(")\n"));
    std::filesystem::remove(journal);
  }
  std::filesystem::remove(film);
}

}  // namespace
}  // namespace pizarra::programs
