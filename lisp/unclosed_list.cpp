#include "lisp/unclosed_list.hpp"

#include <vector>

namespace pizarra {

namespace {

// The last byte of a comment, before the end of its line, or of a string.
std::size_t last_of_skipped(std::string_view text, std::size_t at) {
  const bool comment = text[at] == ';';
  for (++at; at < text.size(); ++at) {
    if (comment && text[at] == '\n') return at - 1;
    if (!comment && text[at] == '"') return at;
    if (!comment && text[at] == '\\') ++at;
  }
  return text.size();
}

struct OpenList {
  std::size_t offset, column;
};

}  // namespace

std::optional<std::size_t> list_ended_by_indentation(std::string_view text) {
  std::vector<OpenList> open;
  std::size_t line = 0;
  bool begins_line = true;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '(') {
      if (begins_line && !open.empty() && open.back().column >= at - line) return open.back().offset;
      open.push_back({at, at - line});
    }
    if (c == ')' && !open.empty()) open.pop_back();
    if (c == ';' || c == '"') at = last_of_skipped(text, at);
    if (c == '\n') line = at + 1;
    begins_line = c == '\n' || (begins_line && (c == ' ' || c == '\t' || c == '\r'));
  }
  return {};
}

}  // namespace pizarra
