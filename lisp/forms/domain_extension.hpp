#pragma once

// A domain that says only how it differs from another one:
//
//   (domain numbered-places
//     (extends "blocks.scm")              ; a file as seen from this file's folder
//     (without on-table PICK-UP)          ; names of the other domain that this one does not have
//     (operator TAKE ...) ...)            ; what is added, or replaced: see domain_merge.hpp
//
// The other domain may itself extend a third. Places in failures name the file that holds the element.

#include "lisp/reader.hpp"

namespace pizarra::forms {

// The domain as one form, without `extends` and `without`. A domain that extends nothing stays as it is.
// Failures: malformed, repeated, unreadable-file, extends-itself, too-many (more than 8 files), unknown-name (in
// `without`), wrong-file (the other is no domain), and the reader's.
Result<Source> extended_domain(Source source);

bool extends_another(const Source& source);

}  // namespace pizarra::forms
