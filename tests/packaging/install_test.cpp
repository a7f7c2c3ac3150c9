#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>

#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra {
namespace {

using programs::contains;
using programs::Said;
using programs::shell;

namespace fs = std::filesystem;

// Installed once for all tests.
const std::string& prefix() {
  static const std::string installed = [] {
    std::string folder = scratch_folder() + "installed";
    const Said said = shell(std::string(PIZARRA_CMAKE) + " --install " PIZARRA_BUILD " --prefix " + folder + " 2>&1");
    EXPECT_EQ(said.status, 0) << said.text;
    return folder;
  }();
  return installed;
}

Said pizarra(const std::string& words) { return shell(prefix() + "/bin/pizarra " + words + " 2>&1"); }

// Configures, builds and tests a project of others.
Said build_and_test(const std::string& source) {
  const std::string build = source + "/build";
  return shell(std::string("export PIZARRA=") + prefix() + "/bin/pizarra PYTHONPATH=" + prefix() +
               "/share/pizarra/blackboard/python; " + PIZARRA_CMAKE + " -S " + source + " -B " + build +
               " -D CMAKE_PREFIX_PATH=" + prefix() + " && " + PIZARRA_CMAKE + " --build " + build + " && " +
               PIZARRA_CTEST + " --test-dir " + build + " --output-on-failure 2>&1");
}

std::string copied(const std::string& example) {
  std::string to = scratch_folder() + example;
  fs::copy(source_dir() + "/examples/" + example, to, fs::copy_options::recursive);
  return to;
}

TEST(Installed, FindsItsFilesWhereItStands) {
  const Said version = pizarra("--version");
  EXPECT_EQ(version.status, 0) << version.text;
  const Said checked = pizarra("check " + prefix() + "/share/pizarra/examples/01-blocks/cell.scm");
  EXPECT_EQ(checked.status, 0) << checked.text;
  const Said unknown = pizarra("check --domain nowhere.scm " + prefix() + "/share/pizarra/examples/01-blocks/cell.scm");
  EXPECT_EQ(unknown.status, 2) << unknown.text;
  EXPECT_EQ(pizarra("dmeo").status, 2);
}

TEST(Installed, TheFirstPageLinksOnlyToFilesThatAreThere) {
  const std::string pages = prefix() + "/share/pizarra/docs/";
  const std::string text = whole_file(pages + "README.md");
  static const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  int links = 0;
  for (std::sregex_iterator found(text.begin(), text.end(), link); found != std::sregex_iterator(); ++found) {
    const std::string to = (*found)[1];
    EXPECT_TRUE(fs::exists(pages + to)) << to;
    ++links;
  }
  EXPECT_GT(links, 20);
}

TEST(Installed, EveryHeaderThatIsForOthersIsThereAndStandsAlone) {
  std::ifstream list(prefix() + "/share/pizarra/public-headers.txt");
  std::vector<std::string> headers;
  for (std::string header; std::getline(list, header);) headers.push_back(header);
  ASSERT_GT(headers.size(), 20U);
  std::ofstream all(scratch_folder() + "all.cpp");
  for (const std::string& header : headers) all << "#include \"" << header << "\"\n";
  all.close();
  const Said said = shell("g++ -std=c++23 -fsyntax-only -isystem /usr/include/eigen3 -I " + prefix() +
                          "/include/pizarra " + scratch_folder() + "all.cpp 2>&1");
  EXPECT_EQ(said.status, 0) << said.text;
}

TEST(Installed, TheExampleOfAnAgentIsBuiltWithItAndPassesItsTest) {
  const Said said = build_and_test(copied("own-agent"));
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "100% tests passed")) << said.text;
}

TEST(Installed, TheExamplesOfDriversAreBuiltWithIt) {
  const std::string source = copied("own-driver");
  const Said said =
      shell(std::string(PIZARRA_CMAKE) + " -S " + source + " -B " + source + "/build -D CMAKE_PREFIX_PATH=" + prefix() +
            " && " + PIZARRA_CMAKE + " --build " + source + "/build 2>&1");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(fs::exists(source + "/build/libmyarm.so"));
  EXPECT_TRUE(fs::exists(source + "/build/libmycamera.so"));
}

TEST(New, WritesASchemeAgentThatPassesItsTest) {
  const Said said = pizarra("new agent my-lamp --in " + scratch_folder());
  ASSERT_EQ(said.status, 0) << said.text;
  const std::string lamp = scratch_folder() + "my-lamp/my-lamp";
  EXPECT_TRUE(contains(said, "pizarra scheme " + lamp + ".scm --try " + lamp + "-test.scm")) << said.text;
  const Said tried = pizarra("scheme " + lamp + ".scm --try " + lamp + "-test.scm");
  EXPECT_EQ(tried.status, 0) << tried.text;
}

// Also where the PATH has a Python of another maker first, which has no zmq.
TEST(New, WritesAPythonAgentThatPassesItsTest) {
  ASSERT_EQ(pizarra("new agent py-lamp --python --in " + scratch_folder()).status, 0);
  const std::string other = scratch_folder() + "other";
  ASSERT_EQ(shell("mkdir -p " + other + " && printf '#!/bin/sh\\nexec /usr/bin/python3 -S -E \"$@\"\\n' > " + other +
                  "/python3 && chmod +x " + other + "/python3")
                .status,
            0);
  const Said tried = shell("PATH=" + other + ":$PATH PIZARRA=" + prefix() + "/bin/pizarra PYTHONPATH=" + prefix() +
                           "/share/pizarra/blackboard/python " + scratch_folder() + "py-lamp/py-lamp-test.sh 2>&1");
  EXPECT_EQ(tried.status, 0) << tried.text;
  EXPECT_TRUE(contains(tried, "py-lamp works")) << tried.text;
}

TEST(New, WritesACppAgentThatIsBuiltAndPassesItsTest) {
  ASSERT_EQ(pizarra("new agent cpp-lamp --cpp --in " + scratch_folder()).status, 0);
  const Said said = build_and_test(scratch_folder() + "cpp-lamp");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "100% tests passed")) << said.text;
}

TEST(New, RefusesNamesThatCannotBeAndFoldersThatAreThere) {
  for (const char* name : {"'my lamp'", "7up", "../lamp", "robot", "board", "-x", "''", "lamp.scm"}) {
    EXPECT_EQ(pizarra(std::string("new agent ") + name + " --in " + scratch_folder()).status, 2) << name;
  }
  EXPECT_EQ(pizarra("new agent twice --in " + scratch_folder()).status, 0);
  const Said again = pizarra("new agent twice --in " + scratch_folder());
  EXPECT_EQ(again.status, 2);
  EXPECT_TRUE(contains(again, "is there already")) << again.text;
  EXPECT_EQ(pizarra("new agent lamp --python --cpp --in " + scratch_folder()).status, 2);
  EXPECT_EQ(pizarra("new agent lamp --in /proc").status, 4);
}

}  // namespace
}  // namespace pizarra
