#pragma once

// Text of what comes from outside: names of files, devices' messages, arguments, the environment. Its bytes need not be
// UTF-8, and may be what moves a terminal's cursor or turns its colours. Bytes that are no text, or that must not be
// shown, stand as the escape that a programmer would type. So both a Datum and a terminal can take it.
//
//   text_of_bytes("f\xFCr.jpg")             // f\xfcr.jpg, in eleven characters
//   lines_of_bytes("red\x1b[31m\nend")      // red\x1b[31m, then another line
//
// Text stays as it is, backslashes as well: this is for people to read, and not read back.

#include <string>
#include <string_view>

namespace pizarra {

// Valid UTF-8 without control characters: for what is one line, as the name of a file.
std::string text_of_bytes(std::string_view bytes);
// The same, but line breaks and tabs stay: for what may be several lines, as a message.
std::string lines_of_bytes(std::string_view bytes);

// Whether a terminal shows this character of UTF-8, and does nothing else.
bool is_shown(std::string_view character);

}  // namespace pizarra
