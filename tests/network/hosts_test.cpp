// Cells on several hosts, over links as they are.

#include <csignal>
#include <gtest/gtest.h>
#include <thread>

#include "tests/campaign.hpp"
#include "tests/network/cell_on_hosts.hpp"
#include "tests/programs/taught_cell.hpp"
#include "tests/scratch.hpp"

namespace pizarra::network {
namespace {

using std::chrono::seconds;

class Hosts : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = Network::unavailable(); !why.empty()) GTEST_SKIP() << why;
    cell_ = std::make_unique<CellOnHosts>(CellOnHosts::Boards::one, objects());
  }
  // What the eyes know from the start.
  virtual std::string objects() const { return programs::taught_cell(PIZARRA_CELL) + "objects"; }
  void up_all(const std::vector<std::string>& order) {
    for (const std::string& host : order) cell_->up(host);
    ASSERT_TRUE(cell_->all_are_there()) << cell_->said();
  }
  void expect_goal(const std::string& goal = "(on circle triangle)") {
    const programs::Said said = cell_->run("board-pc", "goal '" + goal + "'");
    EXPECT_EQ(said.status, 0) << said.text << cell_->said();
  }
  // Whether the agent's presence ends.
  bool goes(const std::string& agent) const {
    const std::string question = "ask '(agent " + agent + " ?kind ?host)'";
    return programs::wait_until([&] { return cell_->run("board-pc", question).text == "no\n"; }, seconds(30));
  }
  std::unique_ptr<CellOnHosts> cell_;
};

class UntaughtHosts : public Hosts {
 protected:
  std::string objects() const override { return ""; }
};

TEST_F(UntaughtHosts, TeachAndBuildAGoalTogetherAndSeeEachOthersImagesInWhateverOrderTheyCome) {
  up_all({"eyes-pc", "arm-pc", "board-pc"});
  // An image of eyes-pc's that comes over the network.
  const programs::Said looked = cell_->run("arm-pc", "look colour --frames 3 --png /run/eyes.png");
  EXPECT_EQ(looked.status, 0) << looked.text;
  EXPECT_TRUE(looked.text.contains("320 x 240 colour")) << looked.text;
  expect_goal();
  const programs::Said shown = cell_->run("eyes-pc", "hosts /run/cell.scm --key /run/keys/eyes-pc.secret");
  EXPECT_EQ(shown.status, 0) << shown.text;
  for (const char* line : {"arm-pc           there", "eyes-pc          there", "board-pc         there"}) {
    EXPECT_TRUE(shown.text.contains(line)) << shown.text;
  }
}

TEST_F(Hosts, LoseOneHostsPowerAndGoOnWhenItIsBackWithWhatItKnewOfOld) {
  up_all({"board-pc", "arm-pc", "eyes-pc"});
  cell_->network().cut_power("arm-pc");
  EXPECT_TRUE(goes("robot"));
  EXPECT_TRUE(cell_->comes("board-pc", "hosts /run/cell.scm --board ipc:///run/pizarra/three@board-pc/board.ipc",
                           "arm-pc           away"));
  cell_->network().link("arm-pc", "both");
  cell_->up("arm-pc");
  expect_goal();
}

TEST_F(Hosts, AreUnpluggedAndPluggedInAgainWhileAGoalIsBuilt) {
  up_all({"board-pc", "arm-pc", "eyes-pc"});
  programs::Said goal{-1, ""};
  std::thread asker([&] { goal = cell_->run("board-pc", "goal '(on circle triangle)'"); });
  const bool begun = cell_->comes("board-pc", "ask '(operation ?n ?what running)'", "PICK-UP");
  cell_->network().link("arm-pc", "both cut");
  // Longer than the arm and its agents bear without the board.
  constexpr seconds unplugged{5};
  std::this_thread::sleep_for(unplugged);
  cell_->network().link("arm-pc", "both");
  asker.join();
  EXPECT_TRUE(begun);
  EXPECT_EQ(goal.status, 0) << goal.text << cell_->said();
}

TEST_F(Hosts, HaveAClockThatIsTenMinutesOff) {
  cell_->network().put_clock_off("eyes-pc", std::chrono::minutes(10));
  cell_->network().put_clock_off("arm-pc", -std::chrono::minutes(10));
  up_all({"board-pc", "arm-pc", "eyes-pc"});
  std::string shown;
  const auto shows = [&](const char* more, const char* less) { return shown.contains(more) || shown.contains(less); };
  EXPECT_TRUE(programs::wait_until(
      [&] {
        shown = cell_->run("board-pc", "hosts three").text;
        return shows("+600.", "+599.") && shows("-600.", "-599.");
      },
      seconds(30)))
      << shown;
  expect_goal();
}

TEST_F(Hosts, FollowAnAgentThatMovesToAnotherHost) {
  up_all({"board-pc", "arm-pc", "eyes-pc"});
  cell_->network().cut_power("eyes-pc");
  EXPECT_TRUE(goes("vision"));
  const std::string moved =
      std::string(PIZARRA_AGENT) + " agent vision /run/cell.scm --board tcp://" + cell_->network().address("board-pc") +
      ":7943 --world ipc:///run/shared/world.ipc --host arm-pc --key /run/keys/arm-pc.secret --streams tcp://" +
      cell_->network().address("arm-pc") + ":*";
  const programs::Running vision(cell_->network().on("arm-pc", {"/bin/sh", "-c", "exec " + moved}),
                                 scratch_folder() + "moved.log");
  EXPECT_TRUE(cell_->comes("board-pc", "ask '(agent vision ?k ?h)'", "arm-pc")) << vision.said();
  expect_goal();
}

struct Link {
  const char* name;
  const char* of_the_arm;
  const char* of_the_eyes;
};
class HostsOverALink : public Hosts, public testing::WithParamInterface<Link> {};

TEST_P(HostsOverALink, BuildAGoal) {
  cell_->network().link("arm-pc", GetParam().of_the_arm);
  cell_->network().link("eyes-pc", GetParam().of_the_eyes);
  up_all({"board-pc", "arm-pc", "eyes-pc"});
  expect_goal();
}

// There and back. With so much between the arm and the board, the arm would stand still by its own rule: see below.
constexpr Link links[] = {{"Of40MillisecondsToAll", "both delay 20", "both delay 20"},
                          {"ThatLosesOnePercent", "both loss 1", "both loss 1"},
                          {"Of80MillisecondsToTheEyes", "both", "both delay 40"},
                          {"OfOneMegabit", "both rate 1000", "both rate 1000"}};

INSTANTIATE_TEST_SUITE_P(Links, HostsOverALink,
                         testing::ValuesIn(std::begin(links), std::begin(links) + campaign(2, 4)),
                         [](const auto& link) { return std::string(link.param.name); });

TEST_F(Hosts, HaveAnArmThatStandsStillWhileTheBoardIsTooFarAwayToStopItAndGoesOnAfterwards) {
  cell_->network().link("arm-pc", "both delay 45");
  up_all({"board-pc", "arm-pc", "eyes-pc"});
  programs::Said goal{-1, ""};
  std::thread asker([&] { goal = cell_->run("board-pc", "goal '(on circle triangle)'"); });
  const bool held_up =
      cell_->comes("board-pc", "ask '(event ?n agent ?what ?detail)'", "held up: the board has not answered for 80 ms");
  cell_->network().link("arm-pc", "both");
  asker.join();
  EXPECT_TRUE(held_up) << cell_->said();
  EXPECT_EQ(goal.status, 0) << goal.text << cell_->said();
}

// What one side says still arrives; what it is told does not.
class HostsCutOneWay : public Hosts, public testing::WithParamInterface<const char*> {};

TEST_P(HostsCutOneWay, GoOnWhenTheLinkIsWholeAgain) {
  up_all({"board-pc", "arm-pc", "eyes-pc"});
  cell_->network().link("eyes-pc", std::string(GetParam()) + " cut");
  EXPECT_TRUE(goes("vision"));
  cell_->network().link("eyes-pc", "both");
  expect_goal();
}

INSTANTIATE_TEST_SUITE_P(Ways, HostsCutOneWay, testing::Values("in", "out", "both"),
                         [](const auto& way) { return std::string(way.param); });

}  // namespace
}  // namespace pizarra::network
