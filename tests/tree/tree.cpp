#include "tests/tree/tree.hpp"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/source_dir.hpp"

namespace pizarra {

namespace fs = std::filesystem;

std::vector<SourceFile> sources_below(const std::vector<std::string>& folders) {
  const fs::path root = source_dir();
  std::vector<SourceFile> files;
  for (const std::string& folder : folders) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".cpp" && path.extension() != ".hpp") continue;
      std::ostringstream text;
      text << std::ifstream(path).rdbuf();
      files.push_back({fs::relative(path, root).generic_string(), text.str()});
    }
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::string without_comments_and_literals(std::string_view text) {
  static const std::regex blanked(
      R"(//[^\n]*|/\*[^]*?\*/|R"([^(\s]*)\([^]*?\)\1"|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')");
  std::string out(text);
  for (std::cregex_iterator it(text.data(), text.data() + text.size(), blanked), end; it != end; ++it) {
    for (auto i = it->position(); i < it->position() + it->length(); ++i) {
      char& c = out[static_cast<std::size_t>(i)];
      if (c != '\n') c = ' ';
    }
  }
  return out;
}

std::size_t line_of(std::string_view text, std::size_t offset) {
  return 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, offset), '\n'));
}

}  // namespace pizarra
