#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>

#include "tests/tree/tree.hpp"

namespace pizarra {
namespace {

const std::vector<std::string> layers = {"lisp", "blackboard", "drivers", "agents"};

std::string part(std::string_view path, int index) {
  std::size_t begin = 0;
  for (int i = 0; i < index; ++i) {
    const std::size_t slash = path.find('/', begin);
    if (slash == std::string_view::npos) return "";
    begin = slash + 1;
  }
  return std::string(path.substr(begin, path.find('/', begin) - begin));
}

struct Include {
  std::string from;
  std::string to;
};

std::vector<Include> own_includes() {
  static const std::regex line(R"re((?:^|\n)#include "([^"]+)")re");
  std::vector<Include> includes;
  for (const SourceFile& file : sources_below(layers)) {
    for (std::sregex_iterator it(file.text.begin(), file.text.end(), line), end; it != end; ++it) {
      includes.push_back({file.path, (*it)[1]});
    }
  }
  return includes;
}

// Which rooms of a folder each of its rooms may include from.
using Rooms = std::map<std::string, std::set<std::string>>;

void expect_rooms(const std::string& folder, const Rooms& may) {
  std::set<std::string> seen;
  for (const auto& [from, to] : own_includes()) {
    if (!from.starts_with(folder) || !to.starts_with(folder)) continue;
    const auto room = may.find(part(from, 2));
    ASSERT_NE(room, may.end()) << from << " lies in no known room";
    seen.insert(room->first);
    EXPECT_TRUE(part(to, 2) == room->first || room->second.contains(part(to, 2))) << from << " includes " << to;
  }
  EXPECT_EQ(seen.size(), may.size());
}

TEST(IncludeRule, EveryIncludeIsWrittenFromTheRootAndReachesItsOwnLayerOrOneBelow) {
  const std::vector<Include> includes = own_includes();
  ASSERT_GT(includes.size(), 50u);
  for (const auto& [from, to] : includes) {
    const auto above = std::ranges::find(layers, part(from, 0));
    const auto below = std::ranges::find(layers, part(to, 0));
    EXPECT_NE(below, layers.end()) << from << " includes " << to;
    EXPECT_LE(below, above) << from << " includes " << to << ", which is above it";
  }
}

TEST(IncludeRule, AgentsMeetThroughFactsAloneAndOnlyTheLauncherKnowsThemAll) {
  for (const auto& [from, to] : own_includes()) {
    if (part(from, 0) != "agents" || part(to, 0) != "agents") continue;
    const std::string agent = part(from, 1);
    const std::string other = part(to, 1);
    EXPECT_TRUE(agent == other || other == "runtime" || agent == "launcher") << from << " includes " << to;
    EXPECT_FALSE(agent == "runtime" && other != "runtime") << from << " includes " << to;
  }
}

TEST(IncludeRule, EachRoomOfThePlannerIncludesOnlyTheRoomsItStandsOn) {
  const Rooms may = {{"task", {}},
                     {"files", {"task"}},
                     {"external", {"task", "files"}},
                     {"reach", {"task"}},
                     {"distance", {"task"}},
                     {"guided", {"task", "reach", "distance"}},
                     {"judge", {"task"}},
                     {"graphplan", {"task", "reach"}},
                     {"optimal", {"task", "reach", "distance", "guided", "graphplan"}},
                     {"fast", {"task", "reach", "distance", "guided"}},
                     {"explanation", {"task", "reach", "optimal"}},
                     {"agent", {"task", "explanation", "optimal", "fast"}}};
  expect_rooms("agents/planner/", may);
}

TEST(IncludeRule, EachRoomOfTheEyesIncludesOnlyTheRoomsItStandsOn) {
  const Rooms may = {{"image", {}},
                     {"marks", {"image"}},
                     {"objects", {"marks"}},
                     {"memory", {"marks", "objects"}},
                     {"sight", {"image", "marks", "objects"}},
                     {"agent", {"marks", "objects", "memory", "sight"}}};
  expect_rooms("agents/vision/", may);
}

TEST(IncludeRule, TheSimulatedWorldIsReachedByDriversThePersonAndTheLauncherAlone) {
  for (const auto& [from, to] : own_includes()) {
    if (!to.starts_with("drivers/simulation/")) continue;
    const bool may = from.starts_with("drivers/simulation/") || from.starts_with("agents/person/") ||
                     from.starts_with("agents/launcher/");
    EXPECT_TRUE(may) << from << " includes " << to;
  }
}

TEST(IncludeRule, TheSimulatedWorldCannotReachTheBoard) {
  for (const auto& [from, to] : own_includes()) {
    if (!from.starts_with("drivers/")) continue;
    const bool board =
        to.starts_with("blackboard/") && !to.starts_with("blackboard/time/") && to != "blackboard/stream.hpp";
    EXPECT_FALSE(board) << from << " includes " << to;
  }
}

TEST(IncludeRule, TheLanguageAndTheBoardDependOnNoDeviceLibrary) {
  static const std::regex foreign(R"re((?:^|\n)#include <(opencv2|Eigen|bt|libguile)[^>]*>)re");
  for (const SourceFile& file : sources_below({"lisp", "blackboard"})) {
    std::smatch found;
    if (!std::regex_search(file.text, found, foreign)) continue;
    EXPECT_TRUE(found[1] == "libguile" && file.path.starts_with("lisp/guile/")) << file.path << found[0];
  }
}

}  // namespace
}  // namespace pizarra
