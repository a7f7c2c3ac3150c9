// Words at a board that asks for keys, as docs/security.md has them.

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

#include "tests/programs/declare_at.hpp"
#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"

namespace pizarra::programs {
namespace {

using std::chrono::seconds;

class WordsWithKeys : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(keys_);
    make("board", "");
    make("desk", "");
    make("camera",
         "--tell 'seen,vision-*,agent,contract,request,reply' --read agent,contract,request,reply --take request");
    make("blind", "--tell seen");
    board_.emplace(std::vector<std::string>{PIZARRA_BOARD, "--listen", "tcp://127.0.0.1:*", "--keys", keys_,
                                            "--journal", folder_ + "journal"},
                   folder_ + "board.log");
    ASSERT_TRUE(wait_until([&] { return board_->said().contains("ready on "); }, seconds(20))) << board_->said();
    const std::string said = board_->said();
    const std::size_t begin = said.find("tcp://");
    address_ = said.substr(begin, said.find_first_of(" \n", begin) - begin);
  }
  void make(const std::string& name, const std::string& may) {
    ASSERT_EQ(shell(std::string(PIZARRA_KEYS) + " keys new " + name + " --dir " + keys_ + " " + may).status, 0);
  }
  Said run(const std::string& key, const std::string& word, const std::string& rest) {
    return shell(std::string(PIZARRA_CELL) + " " + word + " --board " + address_ + " --key " + keys_ + "/" + key +
                 ".secret " + rest + " 2>&1");
  }

  const std::string folder_ = scratch_folder();
  const std::string keys_ = folder_ + "keys";
  std::string address_;
  std::optional<Running> board_;
};

TEST_F(WordsWithKeys, DoWhatTheirKeyPermitsAndAreRefusedTheRestWithStatus1) {
  ASSERT_TRUE(declare_at(address_, "(relation seen ((name string)) (key name))", keys_ + "/desk.secret"));
  const Said told = run("camera", "tell", "'(seen \"circle\")'");
  EXPECT_EQ(told.status, 0) << told.text;
  EXPECT_EQ(run("desk", "ask", "'(seen ?what)'").text, "?what = \"circle\"\n");
  for (int times = 0; times < 3; ++times) {
    const Said refused = run("camera", "tell", "'(goal 1)'");
    EXPECT_EQ(refused.status, 1) << refused.text;
    EXPECT_TRUE(refused.text.contains("the key camera may not tell facts of goal")) << refused.text;
  }
  const std::string refusals = "'(board-refusal ?client not-permitted ?count ?newest)'";
  EXPECT_TRUE(wait_until(
      [&] {
        return run("desk", "ask", refusals).text ==
               "?client = \"camera\"  ?count = 3  ?newest = \"the key camera may not tell facts of goal\"\n";
      },
      seconds(20)))
      << run("desk", "ask", refusals).text;
}

TEST(KeysWord, NamesTheFolderThatIsNotThere) {
  const Said said = shell(std::string(PIZARRA_KEYS) + " keys list --dir /tmp/no-such-keys 2>&1");
  EXPECT_EQ(said.status, 4);
  EXPECT_TRUE(said.text.contains("the folder of keys /tmp/no-such-keys cannot be read")) << said.text;
}

TEST(KeysWord, NamesTheNearestOfItsOwnWords) {
  const Said said = shell(std::string(PIZARRA_KEYS) + " keys nwe camera 2>&1");
  EXPECT_EQ(said.status, 2);
  EXPECT_EQ(said.text, "pizarra: keys has no word nwe; did you mean new?\n");
}

TEST_F(WordsWithKeys, EndWithOneStatusWhereTheKeyPermitsNothing) {
  for (const char* word : {"ask '(seen ?what)'", "top --once", "look"}) {
    const std::string text = word;
    const std::size_t end = text.find(' ');
    const Said refused = run("blind", text.substr(0, end), end == text.npos ? "" : text.substr(end));
    EXPECT_EQ(refused.status, 1) << word << ": " << refused.text;
    EXPECT_TRUE(refused.text.contains("the key blind may not ")) << word << ": " << refused.text;
  }
}

TEST_F(WordsWithKeys, AskOfNoMomentThatThereWasNot) {
  ASSERT_TRUE(declare_at(address_, "(relation seen ((name string)) (key name))", keys_ + "/desk.secret"));
  for (const auto& [moment, status] : {std::pair("99999", 1), std::pair("2099-01-01T00:00:00", 2),
                                       std::pair("2026-02-30T00:00:00", 2), std::pair("''", 2)}) {
    const Said refused = run("desk", "ask", std::string("--at ") + moment + " '(seen ?what)'");
    EXPECT_EQ(refused.status, status) << moment << ": " << refused.text;
    EXPECT_EQ(std::ranges::count(refused.text, '\n'), 1) << refused.text;
  }
  const Said later = run("desk", "ask", "'(query (seen ?what) (at (time 4000000000000000)))'");
  EXPECT_EQ(later.status, 1);
  EXPECT_TRUE(later.text.contains("later than the board's clock")) << later.text;
  EXPECT_EQ(run("desk", "ask", "--at 0s '(seen ?what)'").status, 0);
}

}  // namespace
}  // namespace pizarra::programs
