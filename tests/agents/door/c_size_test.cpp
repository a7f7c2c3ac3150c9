// How much room the client in C takes on a small processor: text, and memory with its stack, where Debian's compiler
// for one is installed.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::door {
namespace {

constexpr const char* compiler = "arm-none-eabi-gcc";

bool runs(const std::string& command) { return std::system((command + " > /dev/null 2>&1").c_str()) == 0; }

// As `size` tells it of an object: text, data and bss.
struct Sizes {
  int text = 0;
  int data = 0;
  int bss = 0;
};

Sizes sizes_of(const std::string& object) {
  const std::string out = scratch_folder() + "sizes";
  EXPECT_EQ(std::system(("arm-none-eabi-size " + object + " | tail -1 > " + out).c_str()), 0);
  Sizes sizes;
  std::ifstream(out) >> sizes.text >> sizes.data >> sizes.bss;
  return sizes;
}

// Of all functions together, each once: none calls itself.
int stack_of(const std::string& file) {
  int sum = 0;
  std::istringstream lines(whole_file(file));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream columns(line.substr(line.find('\t')));
    int bytes = 0;
    std::string kind;
    columns >> bytes >> kind;
    EXPECT_EQ(kind, "static") << line;
    sum += bytes;
  }
  return sum;
}

TEST(SmallDeviceSize, FitsASmallProcessor) {
  const std::string folder = scratch_folder() + "small/";
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "empty.c") << "#include <string.h>\n#include <stdint.h>\n";
  const std::string compile =
      std::string(compiler) +
      " -std=c99 -Os -mcpu=cortex-m0plus -mthumb -Wall -Wextra -pedantic -Werror -fstack-usage -c ";
  if (!runs(compile + folder + "empty.c -o " + folder + "empty.o")) {
    GTEST_SKIP() << "needs Debian's packages gcc-arm-none-eabi and libnewlib-arm-none-eabi";
  }
  const std::string client = source_dir() + "/blackboard/c/";
  ASSERT_TRUE(runs(compile + client + "pizarra_device.c -o " + folder + "client.o"));
  std::ofstream(folder + "one.c") << "#include \"" << client << "pizarra_device.h\"\npizarra_device device;\n";
  ASSERT_TRUE(runs(compile + folder + "one.c -o " + folder + "one.o"));
  const Sizes code = sizes_of(folder + "client.o");
  const int memory = sizes_of(folder + "one.o").bss + code.data + code.bss + stack_of(folder + "client.su");
  EXPECT_GT(code.text, 1000);
  EXPECT_LT(code.text, 12 << 10);
  EXPECT_GT(memory, 500);
  EXPECT_LT(memory, 2 << 10);
  RecordProperty("text", code.text);
  RecordProperty("memory", memory);
  std::printf("%d bytes of text, %d of memory with all of its stack\n", code.text, memory);
}

// It calls nothing but string.h, and what a compiler may take for granted.
TEST(SmallDeviceSize, NeedsNothingOfTheCLibraryButStrings) {
  const std::string out = scratch_folder() + "symbols";
  ASSERT_EQ(std::system(("nm -u " PIZARRA_DEVICE_LIBRARY " | grep ' U ' > " + out).c_str()), 0);
  std::istringstream lines(whole_file(out));
  for (std::string kind, name; lines >> kind >> name;) {
    const bool ours = name == "memcpy" || name == "memmove" || name == "memset" || name == "memcmp" || name == "strlen";
    EXPECT_TRUE(ours || name.starts_with("__")) << name;
  }
}

}  // namespace
}  // namespace pizarra::door
