#pragma once

// What one of our Scheme modules answers by name: ((NAME VALUE) ...), in any order. A program may meet modules of
// another version than its own, so the names that it needs are looked for before any value is read.
//
//   const Result<NamedParts> cell = NamedParts::of(*interpreted, "cell", names);
//   cell->at("hosts");

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

#include "lisp/datum.hpp"
#include "lisp/result.hpp"

namespace pizarra::forms {

class NamedParts {
 public:
  // Failure scheme-error: the module does not tell one of the `names`.
  static Result<NamedParts> of(Datum parts, std::string_view module, std::span<const std::string_view> names) {
    NamedParts out(std::move(parts));
    const auto missing = std::ranges::find_if(names, [&](std::string_view name) { return out.find(name) == nullptr; });
    if (missing == names.end()) return out;
    return fail("scheme-error",
                fmt::format("the module (pizarra {}) is of another version: it tells no {}", module, *missing));
  }

  // One of the names that were looked for.
  const Datum& at(std::string_view name) const {
    const Datum* value = find(name);
    assert(value != nullptr);
    return *value;
  }

 private:
  explicit NamedParts(Datum parts) : parts_(std::move(parts)) {}

  const Datum* find(std::string_view name) const {
    const auto is_it = [&](const Datum& part) { return part.is_form(name) && part.size() == 2; };
    const auto found = std::ranges::find_if(parts_.items(), is_it);
    return found == parts_.items().end() ? nullptr : &(*found)[1];
  }

  Datum parts_;
};

}  // namespace pizarra::forms
