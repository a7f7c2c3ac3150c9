#include "tests/bench/console/measured.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <sstream>

namespace pizarra::bench {

namespace {

// Within single quotes nothing means anything to a shell but these.
std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

std::optional<double> Measured::value(const std::string& name) const {
  const auto found = values.find(name);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

Measured measure(const std::vector<std::string>& command, const std::function<void(const std::string&)>& obey) {
  std::string line;
  for (const std::string& word : command) line += quoted(word) + " ";
  Measured out;
  std::FILE* said = popen(line.c_str(), "r");
  if (said == nullptr) return out;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), said) != nullptr) {
    std::istringstream words(buffer.data());
    std::string name;
    double value = 0;
    if (words >> name >> value) {
      out.values[name] = value;
    } else if (obey && words.eof()) {
      obey(name);
    } else {
      out.trouble = buffer.data();
    }
  }
  const int status = pclose(said);
  if (status != 0 && out.trouble.empty()) out.trouble = fmt::format("the measurement ended with {}", status);
  return out;
}

}  // namespace pizarra::bench
