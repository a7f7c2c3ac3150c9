#pragma once

// Where parentheses are missing or too many, told by forms that can stand at one depth only.
//
//   const Balanced balanced = balance("(define (domain d)\n (:types a\n (:predicates (p)))", depth_in_pddl);
//   balanced.text;        // ... (:types a )(:predicates (p)))
//   balanced.errors;      // at (:types: this list is not closed
//
// So that a person is shown the list that lacks its end, and not the last one of the file, and everything behind it can
// be read too.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pizarra {

struct SourceError {
  std::size_t offset = 0;  // in the text as it was
  std::string symbol;
  std::string sentence;
};

struct Balanced {
  std::string text;
  // Where characters were put in, as offsets of the text as it was, ascending.
  std::vector<std::size_t> inserted;
  std::vector<SourceError> errors;

  std::size_t original_offset(std::size_t offset) const;
};

// How many lists a form that begins with this name stands in; none for names that may stand anywhere.
using DepthOfForm = std::function<std::optional<std::size_t>(std::string_view)>;

Balanced balance(std::string_view text, const DepthOfForm& depth_of_form);

}  // namespace pizarra
