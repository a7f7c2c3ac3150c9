#include "lisp/indentation.hpp"

#include <vector>

namespace pizarra {

namespace {

struct Parenthesis {
  bool opens;
  bool begins_line;
  std::size_t offset, column;
};

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

// Those outside of comments and strings.
std::vector<Parenthesis> parentheses_of(std::string_view text) {
  std::vector<Parenthesis> out;
  std::size_t line = 0;
  bool begins_line = true;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '(' || c == ')') out.push_back({c == '(', begins_line, at, at - line});
    if (c == ';' || c == '"') at = last_of_skipped(text, at);
    if (c == '\n') line = at + 1;
    begins_line = c == '\n' || (begins_line && (c == ' ' || c == '\t' || c == '\r'));
  }
  return out;
}

}  // namespace

std::optional<std::size_t> list_ended_by_indentation(std::string_view text) {
  std::vector<Parenthesis> open;
  for (const Parenthesis& one : parentheses_of(text)) {
    if (one.opens) {
      if (one.begins_line && !open.empty() && open.back().column >= one.column) return open.back().offset;
      open.push_back(one);
    } else if (!open.empty()) {
      open.pop_back();
    }
  }
  return {};
}

std::optional<std::size_t> end_before_indentation(std::string_view text) {
  std::size_t depth = 0;
  Parenthesis outermost{};
  std::optional<std::size_t> end;
  for (const Parenthesis& one : parentheses_of(text)) {
    if (one.opens) {
      if (depth == 0 && end && one.begins_line && one.column > outermost.column) return end;
      if (depth++ == 0) outermost = one;
    } else if (depth != 0 && --depth == 0) {
      end = one.offset;
    }
  }
  return {};
}

}  // namespace pizarra
