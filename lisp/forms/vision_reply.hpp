#pragma once

// The vision server's replies, in the thesis' text, as data. x and y are pixels in the left image, d millimetres.
//
//   (LEARN "name" OK|FAIL)            ->  (learn "name" ok|fail)
//   (FIND "name" OK (x, y))           ->  (find "name" ok X Y)
//   (FIND "name" FAIL)                ->  (find "name" fail)
//
//   (TRACK n ("a" OK (x, y, d)) ("b" FAIL) ...)  ->  (track ("a" X Y D) ("b" fail) ...)
//   (GET n ("a", "b", ...))           ->  (get "a" "b" ...)
//
// Numbers keep their kind, so ask them with number(). A comma may touch the number before it, after it, or both.

#include <string_view>

#include "lisp/reader.hpp"

namespace pizarra::forms {

// Failures: the reader's, malformed, wrong-count (the announced number of objects is not the list's), repeated.
Result<Datum> interpret_vision_reply(std::string_view text);

// As it is read, with each comma as a symbol of its own: for the modules that interpret it. Failures: the reader's.
Result<Source> read_vision_reply(std::string_view text);

}  // namespace pizarra::forms
