#pragma once

// Tokens, with which somebody without the secret of a key logs in as its owner where that secret is kept: a person, in
// a browser, at a console. NAME.token stands beside NAME.secret, as much its owner's alone:
//
//   (token anna "64 HEXADECIMAL DIGITS")
//
//   Result<std::string> token = make_token("keys", "anna");                    // "anna.8f3c..."; the one before is
//   void std::optional<std::string> key = key_of_token("keys", "anna.8f3c...");     // "anna"; nothing: it is wrong
//
// It is looked for in the file each time: a file that is removed lets nobody in any more.

#include <optional>
#include <string>
#include <string_view>

#include "lisp/result.hpp"

namespace pizarra::wire {

// 256 bits that nobody guesses, as hexadecimal digits.
std::string random_secret();
// In a time that does not tell how much of it is right.
bool is_same_secret(std::string_view a, std::string_view b);

// Failures bad-name, no-key, cannot-write.
Result<std::string> make_token(const std::string& folder, const std::string& name);
std::optional<std::string> key_of_token(const std::string& folder, std::string_view token);

}  // namespace pizarra::wire
