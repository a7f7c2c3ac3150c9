#pragma once

// The strict reader: text to Datum, with limits, refusing whatever it does not know exactly.
//
// The language: `(` `)` lists, `"..."` strings (escapes \" \\ \n \t), integers, reals, symbols (letters, digits and
// !$%&*/:<=>?^_~+-.@), `;` comments to the end of the line. Nothing else: no quotes, dots, commas, vectors, `#`.
// Numbers that do not fit, NUL bytes, invalid UTF-8, unclosed lists and strings are failures that name their place. A
// number has digits on both sides of its point (`0.5`, `-2`, `+3.0`, `1e20`); what begins like a number must be one.
//
//   Result<Datum> fact = read_one("(on circle triangle)");
//   Result<Source> file = read_source(text, "blocks.scm");   // many data, each element knows where it stood

#include <string>
#include <string_view>
#include <vector>

#include "lisp/balance.hpp"
#include "lisp/result.hpp"

namespace pizarra {

struct ReadLimits {
  std::size_t bytes = 1 << 20;
  std::size_t depth = 64;
  std::size_t elements = 100'000;
  // Reads a comma as a datum of its own, the symbol `,`, so that `(1, 2)`, `(1 ,2)` and `(1,2)` are one text: for the
  // vision replies, which write pairs with commas. Refused otherwise.
  bool commas = false;
  // Reads symbols in lower case: for PDDL, in which case does not count.
  bool lower_case = false;
};

// Failure symbols: too-long, too-deep, too-many, bad-character, bad-number, bad-escape, bad-text, unclosed-list,
// unclosed-string, unexpected-close, nothing-to-read, more-than-one, unreadable-file.

// Exactly one datum with nothing but blanks and comments around it.
Result<Datum> read_one(std::string_view text, const ReadLimits& limits = {}, std::string_view file = "input");
// The same, of one datum or more.
Result<std::vector<Datum>> read_all(std::string_view text, const ReadLimits& limits = {},
                                    std::string_view file = "input");

// Where an element began and its last byte, from the beginning of the text, and its elements.
struct Spot {
  std::size_t offset = 0;
  std::size_t last = 0;
  std::vector<Spot> items = {};
  // Which of the texts of its source it stands in: 0 is the source's own, others came with Source::replace_first.
  std::size_t text = 0;
};

// A text a person wrote, read whole, that remembers where every element stood.
class Source {
 public:
  const std::vector<Datum>& data() const { return data_; }
  const std::vector<Spot>& spots() const { return spots_; }
  const std::string& file() const { return texts_.front().file; }
  const std::string& text() const { return texts_.front().text; }
  // Puts another datum in place of the first, which must be there. Its elements may come from `other` too, whose texts
  // are taken in behind those that are here: their spots' `text` must have been raised by as many as these.
  void replace_first(const Datum& datum, Spot spot, const Source& other);
  std::size_t text_count() const { return texts_.size(); }
  // A failure about the element that `path` leads to: {2, 0} is the first element of the third datum. The place gets
  // file:line:column, the line, a caret, and `context` (outermost first). An index one behind a list's last element
  // means the place where the list is closed, or behind all of the text; any other path that leads nowhere its longest
  // existing part.
  Failure failure_at(const std::vector<std::size_t>& path, std::string symbol, std::string sentence,
                     const std::vector<std::string>& context = {}) const;
  std::size_t offset_at(const std::vector<std::size_t>& path) const;
  // The faults that were mended while reading, in the order of the text: then the data are only good for finding more
  // that is wrong.
  const std::vector<SourceError>& errors() const { return errors_; }
  Failure failure_of(const SourceError& error) const;

 private:
  friend Result<Source> read_source(std::string_view, std::string, const ReadLimits&);
  friend Result<Source> read_source_to_the_end(std::string_view, std::string, const ReadLimits&, const DepthOfForm&);
  struct Text {
    std::string file;
    std::string text;
  };
  struct Place {
    std::size_t text = 0;
    std::size_t offset = 0;
  };
  Place place_at(const std::vector<std::size_t>& path) const;

  std::vector<Text> texts_{1};
  std::vector<Datum> data_;
  std::vector<Spot> spots_;
  std::vector<SourceError> errors_;
};

// Several failures, at least one, as the first of them with the others in its place; of many, the first twenty.
Failure one_report(const std::vector<Failure>& failures);

Result<Source> read_source(std::string_view text, std::string file, const ReadLimits& limits = {});
// The same, but goes on behind what cannot be read, so that everything wrong is found in one reading: see errors().
// Fails where a limit is exceeded, or a string is not closed.
Result<Source> read_source_to_the_end(std::string_view text, std::string file, const ReadLimits& limits,
                                      const DepthOfForm& depth_of_form);
Result<std::string> read_text_file(const std::string& path, const ReadLimits& limits = {});
Result<Source> read_source_file(const std::string& path, const ReadLimits& limits = {});

}  // namespace pizarra
