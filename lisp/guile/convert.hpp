#pragma once

// Datum to Scheme value and back, for lisp/guile/ alone. Both directions may be left by a non-local exit of Guile's, so
// no object with a destructor lives in their frames while Guile runs: what is built belongs to the caller's caller.
//
//   Builder builder;                            // outside of what Guile may leave
//   if (builder.take(value)) answer = builder.result();

#include <libguile.h>
#include <vector>

#include "lisp/datum.hpp"

namespace pizarra::guile {

SCM to_scheme(const Datum& datum);

// Builds one Datum from the leaves and brackets of a Scheme value.
class Builder {
 public:
  // Puts `value` into the builder; false, with `problem()` set, where it has no Datum.
  bool take(SCM value, int depth = 0);
  const char* problem() const { return problem_; }
  Datum result() { return std::move(data_.back()); }

 private:
  bool take_list(SCM value, int depth);
  bool take_text(SCM value, bool symbol);
  bool take_real(SCM value);
  bool add(Datum datum);
  bool refuse(const char* problem);

  std::vector<Datum> data_;
  std::vector<std::size_t> open_;
  std::size_t elements_ = 0;
  const char* problem_ = nullptr;
};

}  // namespace pizarra::guile
