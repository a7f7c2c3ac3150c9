// Scheme files as agents in processes of their own: the shipped example, a story that fails, and what a file tries that
// only the process's limits end.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

constexpr std::chrono::seconds patience{60};

std::string example(const std::string& file) { return source_dir() + "/examples/10-conveyor/" + file; }

Said cell(const std::string& words) { return shell(std::string(PIZARRA_CELL) + " " + words + " 2>&1"); }

bool comes(const std::string& words, const std::string& text) {
  return wait_until([&] { return contains(cell(words), text); }, patience);
}

// As an editor does: the file is another one.
void save(const std::string& file, const std::string& text) {
  std::ofstream(file + ".new") << text;
  std::filesystem::rename(file + ".new", file);
}

// A cell of one Scheme agent.
class SchemeCell : public testing::Test {
 protected:
  void up(const std::string& text, const std::string& options = "") {
    save(file_, text);
    std::ofstream(folder_ + "cell.scm") << "(cell lonely (agent conveyor (scheme \"conveyor.scm\") " << options
                                        << ") (host \"localhost\" (agents conveyor)))";
    up_.emplace(std::vector<std::string>{PIZARRA_CELL, "up", folder_ + "cell.scm"}, folder_ + "up.log");
    ASSERT_TRUE(comes("ask '(program conveyor ?state ?why)'", "?state = ")) << up_->said();
  }
  void TearDown() override {
    if (!up_) return;
    up_->signal(SIGINT);
    EXPECT_EQ(up_->end(patience), 0) << up_->said();
  }

  const std::string folder_ = scratch_folder();
  const std::string file_ = folder_ + "conveyor.scm";
  std::optional<Running> up_;
};

TEST_F(SchemeCell, TheExamplesRulesWorkAndSayWhyAndAreReplacedWhenTheirFileIsSaved) {
  up(whole_file(example("conveyor.scm")));
  EXPECT_EQ(cell("tell '(barrier exit blocked)'").status, 0);
  EXPECT_TRUE(comes("ask '(belt ?s)'", "?s = stopped")) << up_->said();
  const Said why = cell("why '(belt ?)'");
  EXPECT_TRUE(contains(why, "(belt stopped)  by conveyor")) << why.text;
  EXPECT_TRUE(contains(why, "  because (rule conveyor piece-arrives \"(barrier exit blocked)\")")) << why.text;
  EXPECT_TRUE(contains(why, "  because (barrier exit blocked)  by ")) << why.text;
  EXPECT_EQ(cell("tell '(barrier door blocked)'").status, 0);
  EXPECT_TRUE(comes("ask '(stop ?who ?why)'", "the barrier at the door is blocked")) << up_->said();

  save(file_, whole_file(example("conveyor.scm")) + "(rule third (barrier exit ?s)\n  (tell (belt reversed))");
  EXPECT_TRUE(comes("ask '(program conveyor ?state ?why)'", "?state = kept")) << up_->said();
  EXPECT_TRUE(contains(cell("ask '(program conveyor ?state ?why)'"), "conveyor.scm:")) << up_->said();
  EXPECT_TRUE(contains(cell("ask '(belt ?s)'"), "?s = stopped"));

  save(file_, whole_file(example("conveyor.scm")) + "(rule third (barrier exit ?s)\n  (tell (belt reversed)))");
  EXPECT_TRUE(comes("ask '(belt ?s)'", "?s = reversed")) << up_->said();
}

TEST_F(SchemeCell, AProcessThatItsInterpreterCannotInterruptIsKilledAndStartedAgain) {
  up("(operation (ready) 'yes)(loop power 300 (expt 7 (expt 10 9)))", "(time 200) (memory 16)");
  EXPECT_TRUE(wait_until([this] { return up_->said().find("starts again") != std::string::npos; }, patience))
      << up_->said();
  save(file_, "(operation (ready) 'yes)");
  EXPECT_TRUE(comes("ask '(program conveyor ?state ?why)'", "?state = runs")) << up_->said();
}

TEST_F(SchemeCell, AProcessThatAsksForTooMuchMemoryHarmsNobodyElse) {
  up("(operation (ready) 'yes)(define kept #f)(loop greedy 300 (set! kept (make-vector 100000000 0)))", "(memory 16)");
  const auto dealt_with = [this] {
    return contains(cell("ask '(program-fault conveyor greedy ?why)'"), "?why = ") ||
           up_->said().find("starts again") != std::string::npos;
  };
  EXPECT_TRUE(wait_until(dealt_with, patience)) << up_->said();
  save(file_, "(operation (ready) 'yes)");
  EXPECT_TRUE(comes("ask '(program conveyor ?state ?why)'", "?state = runs")) << up_->said();
}

TEST(SchemeWord, TriesTheExampleOnItsStory) {
  const Said said = shell(std::string(PIZARRA_SCHEME) + " scheme " + example("conveyor.scm") + " --try " +
                          example("conveyor-test.scm") + " 2>&1");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "all as expected")) << said.text;
}

TEST(SchemeWord, SaysWhatOfAStoryIsNotAsExpectedAndWhere) {
  const std::string story = scratch_folder() + "wrong-story.scm";
  save(story, "(tell (barrier exit blocked))\n(expect (belt running))\n(call (reset) (1))\n");
  const std::string words = std::string(PIZARRA_SCHEME) + " scheme " + example("conveyor.scm") + " --try " + story;
  const Said said = shell(words + " 2>&1");
  EXPECT_EQ(said.status, 1) << said.text;
  EXPECT_TRUE(contains(said, "(belt running) does not hold")) << said.text;
  EXPECT_TRUE(contains(said, "wrong-story.scm:2:1")) << said.text;
  EXPECT_TRUE(contains(said, "answers (ok) in place of (ok 1)")) << said.text;
  save(story, "(hope (belt running))");
  EXPECT_EQ(shell(words + " 2>&1").status, 2);
}

TEST(SchemeWord, ChecksAgentsAndTheirStories) {
  const Said good = cell("check " + example("conveyor.scm") + " " + example("conveyor-test.scm"));
  EXPECT_EQ(good.status, 0) << good.text;
  EXPECT_TRUE(contains(good, "agent conveyor: 3 rules, 0 loops, 1 operation")) << good.text;
  const std::string wrong = scratch_folder() + "wrong.scm";
  save(wrong, "(rule a (x ?b)\n  (tell (y ?c)))");
  const Said bad = cell("check " + wrong);
  EXPECT_EQ(bad.status, 2);
  EXPECT_TRUE(contains(bad, "wrong.scm:1: no condition binds")) << bad.text;
}

}  // namespace
}  // namespace pizarra::programs
