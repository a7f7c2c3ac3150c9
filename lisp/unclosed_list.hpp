#pragma once

// Which list lacks its end, told by how its writer has indented the text.
//
//   list_ended_by_indentation("(domain d\n  (types A\n  (predicates))");   // 12, the offset of (types
//
// One missing parenthesis leaves the outermost list open, and the mistake may be hundreds of lines further on. An
// editor indents what stands in a list further than the list. So a list that is open where a line begins another one no
// further to the right is likely to be the one.

#include <cstddef>
#include <optional>
#include <string_view>

namespace pizarra {

// The first such list of a text that has a list too many open; none where the indentation says nothing.
std::optional<std::size_t> list_ended_by_indentation(std::string_view text);

}  // namespace pizarra
