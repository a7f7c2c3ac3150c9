// Reads on behind what cannot be read, so that a person is shown everything that is wrong with a text at once.

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "lisp/characters.hpp"
#include "lisp/reader.hpp"
#include "lisp/strict_reading.hpp"

namespace pizarra {

namespace {

void restore_offsets(std::vector<Spot>& spots, const Balanced& balanced) {
  for (Spot& spot : spots) {
    spot.offset = balanced.original_offset(spot.offset);
    spot.last = balanced.original_offset(spot.last);
    restore_offsets(spot.items, balanced);
  }
}

constexpr std::size_t most_mended = 20;

bool can_be_mended(std::string_view symbol) {
  constexpr std::string_view symbols[] = {"unclosed-list", "unexpected-close", "bad-number",
                                          "bad-character", "bad-text",         "bad-escape"};
  return std::ranges::find(symbols, symbol) != std::end(symbols);
}

// Blanks in the place of every byte that is no text, and how many characters, as an old encoding counts them, those
// are.
std::size_t blank_what_is_no_text(std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(std::string_view(text).substr(at));
    if (length == 0 || text[at] == '\0') {
      text[at] = ' ';
      ++count;
    }
    at += std::max<std::size_t>(1, length);
  }
  return count;
}

// Of the alphabets from Latin to Arabic; what other signs have two bytes, such as a wide blank, comes before.
bool is_letter_of_two_bytes(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  return byte >= 0xC3 && byte <= 0xDF;
}

// Puts something that can be read in the place of what cannot, as long as that; whether there is such a thing.
bool mend(std::string& text, SourceError& trouble) {
  const std::string_view symbol = trouble.symbol;
  if (symbol == "bad-text") {
    const std::size_t count = blank_what_is_no_text(text);
    if (count > 1) trouble.sentence += fmt::format(", nor are {} more characters", count - 1);
    return true;
  }
  if (symbol == "bad-number") {
    for (std::size_t i = trouble.offset; i < text.size() && is_symbol_char(text[i]); ++i) text[i] = '_';
    return true;
  }
  if (symbol != "bad-character" && symbol != "bad-escape") return false;
  const std::size_t length = std::max<std::size_t>(1, utf8_length(std::string_view(text).substr(trouble.offset)));
  text.replace(trouble.offset, length, length, is_letter_of_two_bytes(text[trouble.offset]) ? '_' : ' ');
  return true;
}

// Whether a form that can stand in so many lists only, at least one, stands in more or in fewer: then parentheses are
// wrong, though as many are open as closed.
bool stands_elsewhere(std::span<const Datum> data, std::size_t depth, const DepthOfForm& depth_of_form) {
  return std::ranges::any_of(data, [&](const Datum& datum) {
    if (!datum.is_list() || datum.items().empty()) return false;
    const std::optional<std::size_t> only = depth_of_form(datum.head());
    const bool elsewhere = only && *only > 0 && *only != depth;
    return elsewhere || stands_elsewhere(datum.items(), depth + 1, depth_of_form);
  });
}

}  // namespace

Result<Source> read_source_to_the_end(std::string_view text, std::string file, const ReadLimits& limits,
                                      const DepthOfForm& depth_of_form) {
  Result<Source> strict = read_source(text, file, limits);
  if (strict && !stands_elsewhere(strict->data(), 0, depth_of_form)) return strict;
  if (!strict && !can_be_mended(strict.error().symbol)) return strict;
  Balanced balanced = balance(text, depth_of_form);
  Source source;
  source.texts_.front() = {std::move(file), std::string(text)};
  std::optional<std::vector<Datum>> data;
  for (bool mended = true; mended && !data;) {
    StrictReading read = read_strictly(balanced.text, limits, &source.spots_);
    data = std::move(read.data);
    if (data) break;
    mended = balanced.errors.size() + 1 < most_mended && mend(balanced.text, read.trouble);
    read.trouble.offset = balanced.original_offset(read.trouble.offset);
    balanced.errors.push_back(std::move(read.trouble));
  }
  std::ranges::stable_sort(balanced.errors, {}, &SourceError::offset);
  source.errors_ = std::move(balanced.errors);
  if (!data) {
    std::vector<Failure> failures;
    for (const SourceError& error : source.errors_) failures.push_back(source.failure_of(error));
    return fail(one_report(failures));
  }
  restore_offsets(source.spots_, balanced);
  source.data_ = std::move(*data);
  return source;
}

}  // namespace pizarra
