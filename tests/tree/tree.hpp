#pragma once

// The source tree as text, for the tests that hold it to its own rules.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pizarra {

struct SourceFile {
  std::string path;  // from the tree's root
  std::string text;
};

// Every C++ file below the folders named, by path.
std::vector<SourceFile> sources_below(const std::vector<std::string>& folders);

// The text with comments, string and character literals blanked, line breaks kept.
std::string without_comments_and_literals(std::string_view text);

std::size_t line_of(std::string_view text, std::size_t offset);

}  // namespace pizarra
