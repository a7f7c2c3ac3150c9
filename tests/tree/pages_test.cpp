// The pages in Markdown: every link leads to a file or heading that is there, and no cell of a table is long.

#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/source_dir.hpp"

namespace pizarra {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_cell = 200;

// The lines outside of code, where links and headings stand.
std::vector<std::string> prose(const fs::path& page) {
  std::vector<std::string> lines;
  bool code = false;
  std::ifstream in(page);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```")) {
      code = !code;
    } else if (!code) {
      lines.push_back(line);
    }
  }
  return lines;
}

std::vector<fs::path> pages() {
  const fs::path root = source_dir();
  std::vector<fs::path> found = {root / "README.md", root / "CONTRIBUTING.md"};
  for (const char* folder : {"docs", "examples"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() == ".md") found.push_back(entry.path());
    }
  }
  return found;
}

// As pages name their headings: small letters, hyphens between words, a number after what stands there already.
std::set<std::string> headings(const fs::path& page) {
  std::set<std::string> names;
  std::map<std::string, int> before;
  for (const std::string& line : prose(page)) {
    const std::size_t begin = line.find_first_not_of('#');
    if (!line.starts_with('#') || begin == std::string::npos) continue;
    std::string name;
    for (const char c : line.substr(begin + 1)) {
      const auto letter = static_cast<unsigned char>(c);
      if (std::isalnum(letter) || c == '-' || c == '_') name += static_cast<char>(std::tolower(letter));
      if (c == ' ') name += '-';
    }
    const int number = before[name]++;
    names.insert(number == 0 ? name : name + "-" + std::to_string(number));
  }
  return names;
}

// What links of the line lead to.
std::vector<std::string> targets(const std::string& line) {
  static const std::regex quoted("`[^`]*`");
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  const std::string text = std::regex_replace(line, quoted, "");
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) found.push_back((*it)[1]);
  return found;
}

bool is_there(const fs::path& page, const std::string& target) {
  static const std::regex elsewhere("[a-z]+:.*");
  if (std::regex_match(target, elsewhere)) return true;
  const std::size_t hash = target.find('#');
  const fs::path file = hash == 0 ? page : page.parent_path() / target.substr(0, hash);
  if (!fs::exists(file)) return false;
  return hash == std::string::npos || headings(file).contains(target.substr(hash + 1));
}

TEST(Pages, TheCheckItselfSeesALinkThatLeadsNowhere) {
  const fs::path readme = fs::path(source_dir()) / "README.md";
  EXPECT_EQ(targets("see [a](docs/x.md#y) and `[b](c)`, [d](#e)"), (std::vector<std::string>{"docs/x.md#y", "#e"}));
  EXPECT_TRUE(is_there(readme, "docs/README.md"));
  EXPECT_FALSE(is_there(readme, "docs/no-such-page.md"));
  EXPECT_FALSE(is_there(readme, "docs/README.md#no-such-heading"));
}

TEST(Pages, LeadToFilesAndHeadingsThatAreThere) {
  for (const fs::path& page : pages()) {
    for (const std::string& line : prose(page)) {
      for (const std::string& target : targets(line)) {
        EXPECT_TRUE(is_there(page, target)) << page << " leads to " << target;
      }
    }
  }
}

TEST(Pages, HaveTablesOfShortCells) {
  for (const fs::path& page : pages()) {
    for (const std::string& line : prose(page)) {
      if (!line.starts_with('|')) continue;
      std::istringstream row(line);
      for (std::string cell; std::getline(row, cell, '|');) EXPECT_LE(cell.size(), longest_cell + 2) << page << cell;
    }
  }
}

}  // namespace
}  // namespace pizarra
