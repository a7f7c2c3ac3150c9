// How a member without data begins, by what the others know of it.

#include "blackboard/cluster/log_members.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <optional>

namespace pizarra::cluster {
namespace {

constexpr const char* own_url = "http://10.0.0.3:2380";

class OtherMembers : public LogMembers {
 public:
  Result<std::vector<LogMember>> members() override {
    if (!answers) return fail("unavailable", "no answer");
    return known;
  }
  Result<void> remove(const LogMember& member) override {
    if (!agree) return fail("unavailable", "no quorum");
    std::erase_if(known, [&](const LogMember& each) { return each.id == member.id; });
    return {};
  }
  Result<void> add(const std::string& peer_url) override {
    if (!agree) return fail("unavailable", "no quorum");
    known.push_back({99, peer_url, true, false});
    return {};
  }

  bool answers = true;
  bool agree = true;
  std::vector<LogMember> known = {{1, "http://10.0.0.1:2380", false, true}, {3, own_url, false, true}};
};

TEST(LogMembers, ThatHaveRunAreRemovedAndAddedAndJoin) {
  OtherMembers others;
  EXPECT_EQ(begin_member(others, own_url).value(), Beginning::joining);
  EXPECT_EQ(others.known.size(), 2u);
  EXPECT_EQ(others.known.back().id, 99u);
  EXPECT_EQ(begin_member(others, own_url).value(), Beginning::joining) << "added, and not run yet";
  EXPECT_EQ(others.known.size(), 2u);
}

TEST(LogMembers, ThatTheOthersDoNotKnowAreAddedAndJoin) {
  OtherMembers others;
  others.known.pop_back();
  EXPECT_EQ(begin_member(others, own_url).value(), Beginning::joining);
  EXPECT_EQ(others.known.size(), 2u);
}

TEST(LogMembers, OfANewClusterBeginItTogether) {
  OtherMembers others;
  others.known.back().has_run = false;
  EXPECT_EQ(begin_member(others, own_url).value(), Beginning::anew);
}

TEST(LogMembers, WithoutAnAnswerOfTheOthersDoNotBegin) {
  OtherMembers others;
  others.answers = false;
  EXPECT_EQ(begin_member(others, own_url).value(), std::nullopt);
}

TEST(LogMembers, AreNotStartedWhereTheOthersCannotTakeThemBack) {
  OtherMembers others;
  others.agree = false;
  EXPECT_EQ(begin_member(others, own_url).error().symbol, "unavailable");
  EXPECT_EQ(others.known.size(), 2u);
}

}  // namespace
}  // namespace pizarra::cluster
