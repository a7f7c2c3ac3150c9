#pragma once

// Which parenthesis is missing or too many, told by how its writer has indented the text.
//
//   list_ended_by_indentation("(domain d\n  (types A\n  (predicates))");     // 12, the offset of (types
//   end_before_indentation("(domain d\n  (types A))\n  (predicates))");      // 21, that of its second parenthesis
//
// The mistake may be hundreds of lines away from where the parentheses cease to add up: at the outermost list, or at
// the end of the file. An editor indents what stands in a list further than the list. So an open list probably lacks
// its end where a line begins another one no further to the right. An outermost list probably ended too early where the
// next line begins another one further to the right.

#include <cstddef>
#include <optional>
#include <string_view>

namespace pizarra {

// The first list that lacks its end, of a text that has one open; none where the indentation says nothing.
std::optional<std::size_t> list_ended_by_indentation(std::string_view text);

// The first parenthesis that ended an outermost list too early, of a text that closes more lists than it opens; none
// where the indentation says nothing.
std::optional<std::size_t> end_before_indentation(std::string_view text);

}  // namespace pizarra
