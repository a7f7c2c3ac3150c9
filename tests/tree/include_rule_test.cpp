#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>

#include "tests/tree/tree.hpp"

namespace pizarra {
namespace {

const std::vector<std::string> layers = {"lisp", "blackboard", "drivers", "agents", "programs"};

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

// Which rooms of a folder each of its rooms may include from; "" is the folder itself.
using Rooms = std::map<std::string, std::set<std::string>>;

std::string room_of(std::string_view path, std::string_view folder) {
  const std::string_view inside = path.substr(folder.size());
  return inside.contains('/') ? part(inside, 0) : "";
}

void expect_rooms(const std::string& folder, const Rooms& may) {
  std::set<std::string> seen;
  for (const auto& [from, to] : own_includes()) {
    if (!from.starts_with(folder) || !to.starts_with(folder)) continue;
    const auto room = may.find(room_of(from, folder));
    ASSERT_NE(room, may.end()) << from << " lies in no known room";
    seen.insert(room->first);
    const std::string other = room_of(to, folder);
    EXPECT_TRUE(other == room->first || room->second.contains(other)) << from << " includes " << to;
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

TEST(IncludeRule, EachRoomOfTheLanguageIncludesOnlyTheRoomsItStandsOn) {
  const Rooms may = {{"", {}}, {"guile", {""}}, {"forms", {"", "guile"}}};
  expect_rooms("lisp/", may);
}

TEST(IncludeRule, EachRoomOfTheBoardIncludesOnlyTheRoomsItStandsOn) {
  const Rooms may = {{"time", {}},
                     {"", {"time"}},
                     {"store", {"", "time"}},
                     {"watch", {"", "store"}},
                     {"wire", {"", "time"}},
                     {"journal", {"", "time", "store", "wire"}},
                     {"cluster", {"", "time", "store", "wire", "journal"}},
                     {"memory", {"", "time", "store", "watch", "journal"}},
                     {"server", {"", "time", "store", "watch", "wire", "journal", "memory"}},
                     {"client", {"", "time", "store", "wire"}},
                     {"streams", {"", "time", "wire"}},
                     {"simulated", {"", "time", "wire", "journal", "memory", "server"}}};
  expect_rooms("blackboard/", may);
}

TEST(IncludeRule, EachRoomOfTheCoordinatorIncludesOnlyTheRoomsItStandsOn) {
  const Rooms may = {{"plan", {}},
                     {"geometry", {}},
                     {"", {"geometry"}},
                     {"perceive", {"", "plan", "geometry"}},
                     {"act", {"", "plan", "geometry", "perceive"}},
                     {"pursue", {"", "plan", "geometry", "perceive", "act"}}};
  expect_rooms("agents/coordinator/", may);
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
                     {"database", {"marks", "objects"}},
                     {"sight", {"image", "marks", "objects"}},
                     {"agent", {"marks", "objects", "database", "sight"}}};
  expect_rooms("agents/vision/", may);
}

TEST(IncludeRule, EachRoomOfTheDriversIncludesOnlyTheRoomsItStandsOn) {
  const Rooms may = {
      {"line", {}},      {"web", {}},          {"camera", {}},
      {"plugin", {}},    {"arm", {"line"}},    {"gripper", {"arm"}},
      {"ptu", {"line"}}, {"pddl_planner", {}}, {"simulation", {"line", "arm", "camera", "gripper", "ptu"}}};
  expect_rooms("drivers/", may);
}

TEST(IncludeRule, EachProgramIncludesOnlyTheRoomsItStandsOn) {
  const Rooms may = {{"command_line", {}},
                     {"story", {}},
                     {"method", {}},
                     {"play", {"command_line", "story"}},
                     {"chaos", {"story"}},
                     {"hand_eye", {}},
                     {"host", {"command_line"}},
                     {"commands", {"command_line", "story", "play", "method", "chaos", "hand_eye", "host"}},
                     {"agent", {"command_line"}},
                     {"board", {"command_line"}},
                     {"door", {"command_line"}},
                     {"emulate", {"command_line"}},
                     {"keys", {"command_line"}},
                     {"plan", {"command_line"}},
                     {"plugin", {"command_line"}},
                     {"scheme", {"command_line"}}};
  expect_rooms("programs/", may);
}

TEST(IncludeRule, TheSimulatedWorldIsReachedByDriversThePersonAndTheLauncherAlone) {
  for (const auto& [from, to] : own_includes()) {
    if (!to.starts_with("drivers/simulation/")) continue;
    const bool may = from.starts_with("drivers/simulation/") || from.starts_with("agents/person/") ||
                     from.starts_with("agents/launcher/") || from.starts_with("programs/");
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
