#include "tests/programs/shell.hpp"

#include <array>
#include <cstdio>
#include <sys/wait.h>

#include "tests/scratch.hpp"

namespace pizarra::programs {

Said shell(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> buffer{};
  for (std::size_t got = fread(buffer.data(), 1, buffer.size(), pipe); got > 0;
       got = fread(buffer.data(), 1, buffer.size(), pipe)) {
    text.append(buffer.data(), got);
  }
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text};
}

Said shell_in_scratch(const std::string& command) {
  return shell("cd " + scratch_folder() + " && " + command + " 2>&1");
}

bool contains(const Said& said, const std::string& text) { return said.text.find(text) != std::string::npos; }

}  // namespace pizarra::programs
