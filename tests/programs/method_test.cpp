// The method: the thesis' own figures, patterns by its tables, and faults that a recorded cell has.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>

#include "agents/console/console_contract.hpp"
#include "agents/robot/robot_contract.hpp"
#include "lisp/reader.hpp"
#include "programs/method/connect.hpp"
#include "programs/method/description.hpp"
#include "programs/method/divide.hpp"
#include "programs/method/faults.hpp"
#include "programs/method/journal_traffic.hpp"
#include "programs/method/report.hpp"
#include "programs/method/wrap.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::method {
namespace {

Datum form(std::string_view text) { return read_one(text).value(); }

// Two agents and a visitor; the arm tells what it does not post, and posts what nobody reads.
constexpr std::string_view journal =
    "(0 0 \"arm\" (declare (relation agent ((name symbol) (kind symbol) (host string)) (key name))))\n"
    "(1 0 \"arm\" (tell 1 (agent arm robot \"here\")) (tell 2 (contract arm (contract robot (offers (home)) "
    "(posts (relation pose ((x number))) (relation load ((x number))))))))\n"
    "(2 0 \"head\" (tell 3 (agent head coordinator \"here\")) (tell 4 (contract head (contract coordinator (offers "
    "(go)) "
    "(reads pose)))))\n"
    "(3 0 \"desk/prompt-7\" (tell 5 (agent prompt-7 prompt \"here\")))\n"
    "(4 1000000 \"head\" (tell 6 (request head-1-1 arm (home))))\n"
    "(5 1250000 \"arm\" (tell 7 (reply head-1-1 (ok true))) (tell 8 (pose 1)) (tell 9 (load 2)) (tell 10 (secret 3)))\n"
    "(6 2000000 \"head\" (tell 11 (request head-1-2 ghost (boo))) (tell 12 (request head-1-send-3 arm (home))))\n"
    "(7 3000000 \"head\" (tell 14 (request head-1-4 arm (dance))))\n"
    "(8 3100000 \"arm\" (tell 15 (reply head-1-4 (fail unknown-operation \"robot does not offer (dance)\" dance))))\n"
    "(9 20000000 \"arm\" (tell 13 (pose 2)))\n";

bool has(const std::vector<Fault>& faults, const std::string& symbol, const std::string& subject) {
  return std::ranges::any_of(faults,
                             [&](const Fault& fault) { return fault.symbol == symbol && fault.subject == subject; });
}

const Connection* between(const System& system, const std::string& from, const std::string& to,
                          const std::string& pattern) {
  const auto found = std::ranges::find_if(system.connections, [&](const Connection& connection) {
    return connection.from == from && connection.to == to && connection.pattern == pattern;
  });
  return found == system.connections.end() ? nullptr : &*found;
}

TEST(Method, DividesTheThesisSixComponentsAsTheThesisDoes) {
  const Result<System> system = read_system(source_dir() + "/examples/09-method/thesis.scm");
  ASSERT_TRUE(system) << describe(system.error());
  const Division division = divide(*system);
  EXPECT_EQ(division.components, 6U);
  EXPECT_DOUBLE_EQ(division.i_cpx, 1);
  EXPECT_NEAR(division.i_struct, 1.667, 0.0005);
  EXPECT_NEAR(division.i_cnx, 0.467, 0.0005);
  const std::string text = text_of(report_on(*system));
  for (const char* figure : {"= 1.000", "= 1.667", "= 0.467"}) EXPECT_NE(text.find(figure), std::string::npos) << text;
}

TEST(Method, ADescriptionThatIsWrongIsRefusedAtItsPlace) {
  const std::string file = scratch_folder() + "system.scm";
  std::ofstream(file) << "(system \"s\"\n  (component a (phisical)))\n";
  const Result<System> system = read_system(file);
  ASSERT_FALSE(system);
  EXPECT_EQ(system.error().symbol, "bad-description");
  EXPECT_NE(system.error().place.find("system.scm:2:"), std::string::npos) << system.error().place;
}

TEST(Method, TheRobotInterfaceHidesWhatTheThesisCounted) {
  Traffic traffic;
  traffic.agents["robot"] = {"robot", form(robot::robot_contract)};
  const std::vector<Wrapping> wrappings = wrap(traffic, known_wrapped().value(), known_components("").value());
  ASSERT_EQ(wrappings.size(), 1U);
  std::vector<AbstractionIndex> indices = wrappings.front().indices;
  ASSERT_EQ(indices.size(), 2U);
  EXPECT_EQ(indices[0].operations, 17U);
  EXPECT_EQ(indices[0].functions, 182U);
  EXPECT_NEAR(indices[0].value, 0.093, 0.0005);
  EXPECT_EQ(indices[1].functions, 82U);
  EXPECT_NEAR(indices[1].value, 0.207, 0.0005);
  EXPECT_EQ(wrappings.front().parts.size(), wrapper_parts.size());
}

TEST(Method, RecommendsThePatternsOfTheTables) {
  EXPECT_EQ(recommend({.addressees = 1, .waits = true, .bytes = 40, .bytes_back = 20}), "QUERY");
  EXPECT_EQ(recommend({.addressees = 1, .waits = false, .bytes = 40, .bytes_back = 20}), "SEND");
  EXPECT_EQ(recommend({.addressees = 3, .waits = true, .bytes = 40, .bytes_back = 20}), "not available");
  EXPECT_EQ(recommend({.addressees = 3, .waits = false, .bytes = 40, .bytes_back = 20}), "PUSH");
  EXPECT_EQ(recommend({.addressees = 1, .waits = true, .bytes = 40, .bytes_back = 9000}), "SEND + PUSH");
  EXPECT_EQ(recommend({.addressees = 3, .waits = false, .bytes = 9000, .bytes_back = 20}), "PUSH + SEND");
}

TEST(Method, AJournalShowsWhoAskedAndToldWhat) {
  const Result<Traffic> traffic = traffic_of_journal(journal);
  ASSERT_TRUE(traffic) << describe(traffic.error());
  EXPECT_EQ(traffic->agents.size(), 2U);
  EXPECT_DOUBLE_EQ(traffic->seconds, 20);
  const System system = system_of(*traffic, known_components("").value());
  const Connection* query = between(system, "head", "arm", "QUERY");
  ASSERT_NE(query, nullptr);
  EXPECT_EQ(query->about, (std::set<std::string>{"dance", "home"}));
  EXPECT_DOUBLE_EQ(query->p99_ms, 100);
  EXPECT_NE(between(system, "head", "arm", "SEND"), nullptr);
  const Connection* push = between(system, "arm", "head", "PUSH");
  ASSERT_NE(push, nullptr);
  EXPECT_EQ(push->about, std::set<std::string>{"pose"});
  EXPECT_EQ(push->recommended, "SEND");
  EXPECT_NE(push->remark.find("head alone reads"), std::string::npos) << push->remark;
  // Head begins two connections, the arm one.
  EXPECT_EQ(divide(system).connections, 3U);
}

// A cell that hands jobs to whoever is free, and shows images.
constexpr std::string_view journal_of_jobs =
    "(0 0 \"office\" (declare (relation job ((n integer)) (key n))))\n"
    "(1 0 \"office\" (tell 1 (agent office office \"here\")) (tell 2 (contract office (contract office (offers (go)) "
    "(posts (relation job ((n integer)))) (reads stream)))))\n"
    "(2 0 \"worker\" (tell 3 (agent worker worker \"here\")) (tell 4 (contract worker (contract worker (offers (go)) "
    "(posts (relation done ((n integer))) (relation stream ((name symbol) (kind symbol) (place list)))) (takes job) "
    "(monitors done)))))\n"
    "(3 0 \"idle\" (tell 5 (agent idle worker \"here\")) (tell 6 (contract idle (contract worker (offers (go)) "
    "(posts)))))\n"
    "(4 0 \"worker\" (tell 7 (stream worker-left left ())))\n"
    "(5 1000000 \"office\" (tell 8 (job 1)) (tell 9 (job 2)) (tell 10 (job 3)))\n"
    "(6 2000000 \"worker\" (take 8))\n"
    "(7 3000000 \"worker\" (take 9) (tell 11 (done 1)))\n"
    "(8 4000000 \"idle\" (take 10))\n";

TEST(Method, AJournalShowsWhoTookWhatAndWhoHasImages) {
  const Result<Traffic> traffic = traffic_of_journal(journal_of_jobs);
  ASSERT_TRUE(traffic) << describe(traffic.error());
  const Report report = report_on(*traffic, known_components("").value(), {});
  const Connection* event = between(report.system, "office", "worker", "EVENT");
  ASSERT_NE(event, nullptr);
  EXPECT_EQ(event->about, std::set<std::string>{"job"});
  EXPECT_EQ(event->count, 2U);
  EXPECT_EQ(event->recommended, "EVENT");
  EXPECT_EQ(between(report.system, "office", "idle", "EVENT")->count, 1U);
  const Connection* stream = between(report.system, "worker", "office", "STREAM");
  ASSERT_NE(stream, nullptr);
  EXPECT_EQ(stream->about, std::set<std::string>{"worker-left"});
  EXPECT_EQ(stream->recommended, "SEND + PUSH");
  EXPECT_EQ(between(report.system, "worker", "office", "PUSH"), nullptr);
  const std::string text = text_of(report), json = json_of(report), picture = svg_of(report.system);
  for (const char* pattern : {"EVENT", "STREAM"}) {
    EXPECT_NE(text.find(pattern), std::string::npos) << text;
    EXPECT_NE(json.find(std::string("\"pattern\":\"") + pattern), std::string::npos) << json;
    EXPECT_NE(picture.find(std::string(">") + pattern + "<"), std::string::npos) << picture;
  }
  EXPECT_TRUE(has(report.faults, "false-contract", "idle")) << "it takes jobs, and its contract does not say so";
  EXPECT_FALSE(has(report.faults, "false-contract", "worker"));
  EXPECT_FALSE(has(report.faults, "never-read", "job"));
  EXPECT_FALSE(has(report.faults, "never-read", "done")) << "it is for people to look at";
}

// Pages and programs that come and go read what no agent does.
TEST(Method, WhatAPageOrAProgramReadsIsRead) {
  Traffic traffic = traffic_of_journal(journal).value();
  traffic.watches_seen = true;
  EXPECT_TRUE(has(faults_of(traffic), "never-read", "load"));
  traffic.flows["load"].askers = {"prompt-7"};
  EXPECT_FALSE(has(faults_of(traffic), "never-read", "load"));
}

TEST(Method, TheConsolesContractHasWhatItsPagesFollow) {
  const std::set<std::string> reads =
      names_in(list("contract"_sym, "console"_sym, form(console::reads_of_pages)), "reads");
  // `follow('(place ?name ...)'`, of now alone or not, and of what a role's server tells; `query = [sym('place'), ...`.
  const std::regex following(R"((?:follow(?:Always)?\((?:'[a-z]+', )?'\(|query = \[sym\(')([a-z-]+)[ '])");
  std::set<std::string> followed;
  for (const auto& file : std::filesystem::directory_iterator(source_dir() + "/agents/console/page/src")) {
    const std::string text = whole_file(file.path());
    const std::sregex_iterator found(text.begin(), text.end(), following);
    for (auto each = found; each != std::sregex_iterator(); ++each) followed.insert((*each)[1]);
  }
  EXPECT_GT(followed.size(), 20U);
  EXPECT_TRUE(followed.contains("plan-needs") && followed.contains("stop")) << "both ways are found";
  for (const std::string& relation : followed) EXPECT_TRUE(reads.contains(relation)) << relation;
}

TEST(Method, FindsWhatIsWrongWithASystem) {
  Traffic traffic = traffic_of_journal(journal).value();
  const std::vector<Fault> faults = faults_of(traffic);
  EXPECT_TRUE(has(faults, "false-contract", "arm"));
  EXPECT_TRUE(has(faults, "never-read", "load"));
  EXPECT_FALSE(has(faults, "never-read", "pose"));
  EXPECT_TRUE(has(faults, "never-answered", "ghost"));
  // What was sent is not waited for.
  EXPECT_FALSE(has(faults, "never-answered", "arm"));
  EXPECT_FALSE(has(faults, "does-not-scale", "pose"));
  traffic.flows["pose"].watchers = {"head"};
  traffic.flows["pose"].told["arm"] = 20'000;
  traffic.flows["pose"].delivered_p99_ms = 5;
  EXPECT_TRUE(has(faults_of(traffic), "does-not-scale", "pose"));
}

TEST(Method, APictureShowsNamesAsTheyAreTold) {
  System system;
  system.components.resize(1);
  system.components.front().name = "<script>";
  const std::string svg = svg_of(system);
  EXPECT_EQ(svg.find("<script>"), std::string::npos);
  EXPECT_NE(svg.find("&lt;script&gt;"), std::string::npos);
}

// An arrow whose head is behind a box shows no direction.
TEST(Method, APictureShowsEachArrowBetweenItsBoxes) {
  System system;
  for (const char* name : {"a", "b", "c", "d", "e"}) system.components.emplace_back().name = name;
  for (const Component& from : system.components) {
    for (const Component& to : system.components) {
      if (&from != &to) system.connections.push_back({from.name, to.name, "QUERY", {}});
    }
  }
  const std::string svg = svg_of(system);
  const auto number = [&svg](std::size_t at, const std::string& name) {
    return std::stod(svg.substr(svg.find(name + "=\"", at) + name.size() + 2));
  };
  std::vector<std::array<double, 4>> boxes;
  for (std::size_t at = svg.find("<rect x="); at != std::string::npos; at = svg.find("<rect x=", at + 1)) {
    const double x = number(at, "x"), y = number(at, "y");
    boxes.push_back({x, y, x + number(at, "width"), y + number(at, "height")});
  }
  ASSERT_EQ(boxes.size(), 5U);
  std::size_t arrows = 0;
  for (std::size_t at = svg.find("<line"); at != std::string::npos; at = svg.find("<line", at + 1), ++arrows) {
    for (const auto& [left, top, right, bottom] : boxes) {
      for (const char* end : {"1", "2"}) {
        const double x = number(at, std::string("x") + end), y = number(at, std::string("y") + end);
        EXPECT_FALSE(x > left + 0.2 && x < right - 0.2 && y > top + 0.2 && y < bottom - 0.2) << x << " " << y;
      }
    }
  }
  EXPECT_EQ(arrows, 20U);
}

TEST(Method, SaysOfACellFileWhatItsContractsPromise) {
  const programs::Said said =
      programs::shell(std::string(PIZARRA_CELL) + " method " + source_dir() + "/examples/01-blocks/cell.scm --json");
  EXPECT_EQ(said.status, 0);
  for (const char* part : {"\"i_cpx\":1.000", "\"i_abstract\":0.093", "\"i_abstract\":0.207",
                           "\"from\":\"coordinator\",\"to\":\"vision\",\"pattern\":\"QUERY\"",
                           "\"from\":\"vision\",\"to\":\"coordinator\",\"pattern\":\"PUSH\""}) {
    EXPECT_NE(said.text.find(part), std::string::npos) << part << "\n" << said.text;
  }
  EXPECT_EQ(said.text.find("false-contract"), std::string::npos);
  EXPECT_EQ(said.text.find("arm-joints is posted"), std::string::npos) << "the console's pages read it\n" << said.text;
}

TEST(Method, ARecordedDemoShowsItsTraffic) {
  const std::string journal_file = scratch_folder() + "journal.txt";
  const std::string cell = source_dir() + "/examples/01-blocks/cell.scm";
  const std::string demo =
      std::string(PIZARRA_CELL) + " demo " + cell + " --seed 11 --png '' --journal " + journal_file;
  ASSERT_EQ(programs::shell(demo).status, 0);
  const programs::Said said = programs::shell(std::string(PIZARRA_CELL) + " method --journal " + journal_file);
  EXPECT_EQ(said.status, 0);
  EXPECT_EQ(said.text.find("false-contract"), std::string::npos) << said.text;
  EXPECT_NE(said.text.find("person -> vision"), std::string::npos) << said.text;
}

TEST(Method, OneThingIsLookedAt) {
  EXPECT_EQ(programs::shell(std::string(PIZARRA_CELL) + " method 2>&1").status, 2);
  EXPECT_EQ(programs::shell(std::string(PIZARRA_CELL) + " method --live --for never 2>&1").status, 2);
}

}  // namespace
}  // namespace pizarra::method
