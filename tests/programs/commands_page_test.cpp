// docs/commands.md says what --help says: every command and every option of each program, and none that is not there.

#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/programs/shell.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

using Options = std::set<std::string>;
using Commands = std::map<std::string, Options>;  // by their words, as in `keys new`

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// The first group of the expression, in every line that fits it.
std::vector<std::string> found(const std::vector<std::string>& lines, const std::regex& expression) {
  std::vector<std::string> all;
  for (const std::string& line : lines) {
    std::smatch match;
    if (std::regex_search(line, match, expression)) all.push_back(match[1]);
  }
  return all;
}

// The lines below a title, until an empty one.
std::vector<std::string> part_of(const std::string& help, const std::string& title) {
  std::vector<std::string> part;
  bool is_in = false;
  for (const std::string& line : lines_of(help)) {
    if (line.empty()) is_in = false;
    if (is_in) part.push_back(line);
    if (line == title) is_in = true;
  }
  return part;
}

// A command with subcommands is these, and itself where it has options of its own; one without is itself.
void add_helped(const std::string& program, const std::string& command, Commands& commands) {
  const Said said = shell(program + " " + command + " --help 2>&1");
  ASSERT_EQ(said.status, 0) << program << " " << command << "\n" << said.text;
  const std::vector<std::string> below =
      found(part_of(said.text, "Subcommands:"), std::regex("^  ([a-z]+(?:-[a-z]+)*)"));
  for (const std::string& one : below) add_helped(program, command + (command.empty() ? "" : " ") + one, commands);
  Options options;
  for (const std::string& option : found(lines_of(said.text), std::regex("^  (?:-[a-z],)?(--[a-z-]+)"))) {
    if (option != "--help") options.insert(option);
  }
  if (below.empty() || (!command.empty() && !options.empty())) commands[command.empty() ? "board" : command] = options;
}

Commands asked_of_the_programs() {
  Commands commands;
  for (const char* program : {PIZARRA_CELL, PIZARRA_BOARD, PIZARRA_AGENT, PIZARRA_DOOR, PIZARRA_PLAN, PIZARRA_EMULATE,
                              PIZARRA_KEYS, PIZARRA_SCHEME}) {
    add_helped(program, "", commands);
  }
  return commands;
}

const Commands& of_the_programs() {
  static const Commands asked = asked_of_the_programs();
  return asked;
}

// A heading, as in ### `ask QUERY`, begins the section of a command, or of several that have the same options.
std::vector<std::string> commands_of_heading(const std::string& heading) {
  std::vector<std::string> commands;
  const std::regex quoted("`([a-z]+(?:[ -][a-z]+)*)");
  for (std::sregex_iterator at(heading.begin(), heading.end(), quoted), end; at != end; ++at) {
    commands.push_back((*at)[1]);
  }
  return commands;
}

Commands of_the_page() {
  std::ifstream in(source_dir() + "/docs/commands.md");
  Commands commands;
  std::vector<std::string> described;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#")) {
      described = line.starts_with("### ") ? commands_of_heading(line) : std::vector<std::string>();
    }
    for (const std::string& command : described) {
      Options& options = commands[command];
      for (const std::string& option : found({line}, std::regex("^\\| `(--[a-z-]+)"))) options.insert(option);
    }
  }
  return commands;
}

// The lines that the first has and the second lacks.
std::string lacking(const Commands& first, const Commands& second) {
  std::string all;
  for (const auto& [command, options] : first) {
    const auto other = second.find(command);
    if (other == second.end()) {
      all += command + "\n";
      continue;
    }
    for (const std::string& option : options) {
      if (!other->second.contains(option)) all += command + " " + option + "\n";
    }
  }
  return all;
}

TEST(CommandsPage, HasEveryCommandAndOptionThatHelpLists) {
  const Commands& programs = of_the_programs();
  ASSERT_GT(programs.size(), 20U);
  EXPECT_EQ(lacking(programs, of_the_page()), "");
}

TEST(CommandsPage, HasNoCommandOrOptionThatHelpDoesNotList) {
  const Commands page = of_the_page();
  ASSERT_GT(page.size(), 20U);
  EXPECT_EQ(lacking(page, of_the_programs()), "");
}

TEST(CommandsPage, HasOnlyCommandsThatTheScriptListsToo) {
  const Said said = shell(source_dir() + "/pizarra help");
  ASSERT_EQ(said.status, 0);
  for (const auto& [command, options] : of_the_page()) {
    const std::string first = command.substr(0, command.find(' '));
    EXPECT_TRUE(std::regex_search(said.text, std::regex("\n  (?:[a-z]+, )*" + first + "[, \n]"))) << first;
  }
}

}  // namespace
}  // namespace pizarra::programs
