#pragma once

// What stands behind a backslash in a string that is written.

namespace pizarra {

constexpr bool needs_escape(char c) { return c == '"' || c == '\\' || c == '\n' || c == '\t'; }

}  // namespace pizarra
