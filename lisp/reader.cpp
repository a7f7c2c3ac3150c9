#include "lisp/reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <fmt/format.h>
#include <optional>

#include "lisp/characters.hpp"
#include "lisp/decimal.hpp"
#include "lisp/indentation.hpp"
#include "lisp/shortened.hpp"
#include "lisp/strict_reading.hpp"

namespace pizarra {

namespace {

constexpr bool may_begin_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+'; }

// The bytes that stand for themselves in a string, each a character of its own.
constexpr std::array<bool, 256> plain_bytes = [] {
  std::array<bool, 256> out{};
  for (unsigned c = 1; c < 0x80; ++c) out[c] = c != '"' && c != '\\';
  return out;
}();

// The length of the plain characters at the beginning of `text`.
std::size_t length_of_plain(std::string_view text) {
  const auto is_plain = [](char c) { return plain_bytes[static_cast<unsigned char>(c)]; };
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_plain) - text.begin());
}
std::size_t length_of_token(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_symbol_char) - text.begin());
}

// One pass over the text with an explicit stack: elements of open lists wait in `waiting_`, in the order they came.
// Code for forms that are rare in a board's frames is marked cold, so that the compiler moves it out of the way.
class Reader {
 public:
  Reader(std::string_view text, const ReadLimits& limits, std::vector<Spot>* spots)
      : text_(text), limits_(limits), spots_(spots) {
    waiting_.reserve(16);
    open_.reserve(8);
  }

  // The elements that stand outside of every list.
  std::optional<std::vector<Datum>> read_all() {
    if (text_.size() > limits_.bytes) {
      refuse(0, "too-long", fmt::format("the text has {} bytes; at most {} are read", text_.size(), limits_.bytes));
      return {};
    }
    while (at_ < text_.size()) {
      if (!step()) return {};
    }
    if (!open_.empty()) {
      refuse_unclosed();
      return {};
    }
    if (spots_) *spots_ = std::move(waiting_spots_);
    return std::move(waiting_);
  }

  const SourceError& trouble() const { return trouble_; }

 private:
  struct Open {
    std::size_t offset;
    std::size_t first;  // of its elements in waiting_
  };

  [[gnu::cold]] bool refuse(std::size_t offset, const char* symbol, std::string sentence) {
    trouble_ = {offset, symbol, std::move(sentence)};
    return false;
  }

  bool step() {
    const char c = text_[at_];
    if (is_symbol_char(c)) return read_token();
    switch (c) {
      case ' ':
      case '\n':
      case '\t':
      case '\r':
        return ++at_, true;
      case '(':
        return open_list();
      case ')':
        return close_list();
      case '"':
        return read_string();
      case ';':
        return skip_comment();
      case ',':
        if (limits_.commas) return add(Datum::symbol(","), at_++);
        break;
      default:
        break;
    }
    return refuse_character();
  }

  [[gnu::cold]] bool refuse_character() {
    const std::size_t length = utf8_length(text_.substr(at_));
    const auto byte = static_cast<unsigned char>(text_[at_]);
    if (length == 0) return refuse(at_, "bad-text", "this is not UTF-8");
    if (byte < 0x20 || byte == 0x7F) {
      return refuse(at_, "bad-character", fmt::format("a control character ({:#04x}) cannot stand here", byte));
    }
    return refuse(at_, "bad-character", fmt::format("`{}` has no meaning here", text_.substr(at_, length)));
  }

  [[gnu::cold]] bool refuse_unclosed() {
    const std::optional<std::size_t> indented = list_ended_by_indentation(text_);
    if (!indented) return refuse(open_.back().offset, "unclosed-list", "this list is not closed");
    return refuse(*indented, "unclosed-list", "a list is not closed; by the indentation it is this one");
  }

  [[gnu::cold]] bool refuse_close() {
    const std::optional<std::size_t> early = end_before_indentation(text_.substr(0, at_));
    if (!early) return refuse(at_, "unexpected-close", "nothing is open that this could close");
    return refuse(*early, "unexpected-close", "there is a parenthesis too many; by the indentation it is this one");
  }

  bool add(Datum&& datum, std::size_t offset) {
    if (++elements_ > limits_.elements) return refuse_element(offset);
    waiting_.push_back(std::move(datum));
    if (spots_) note_spot(offset);
    return true;
  }

  [[gnu::cold]] void note_spot(std::size_t offset) { waiting_spots_.push_back({offset, at_ - 1, {}}); }

  [[gnu::cold]] bool refuse_element(std::size_t offset) {
    return refuse(offset, "too-many", fmt::format("more than {} elements", limits_.elements));
  }

  bool open_list() {
    if (open_.size() >= limits_.depth) {
      return refuse(at_, "too-deep", fmt::format("lists nest deeper than {}", limits_.depth));
    }
    open_.push_back({at_++, waiting_.size()});
    return true;
  }

  bool close_list() {
    if (open_.empty()) return refuse_close();
    const Open open = open_.back();
    open_.pop_back();
    ++at_;
    Datum closed = Datum::list_of(std::span(waiting_).subspan(open.first));
    waiting_.resize(open.first);
    if (!spots_) return add(std::move(closed), open.offset);
    const auto first_spot = waiting_spots_.begin() + static_cast<std::ptrdiff_t>(open.first);
    std::vector<Spot> inner(std::make_move_iterator(first_spot), std::make_move_iterator(waiting_spots_.end()));
    waiting_spots_.erase(first_spot, waiting_spots_.end());
    if (!add(std::move(closed), open.offset)) return false;
    waiting_spots_.back().items = std::move(inner);
    return true;
  }

  bool read_token() {
    const std::size_t start = at_;
    const std::string_view rest = text_.substr(start);
    if (may_begin_number(rest.front())) {
      Decimal decimal = read_decimal(rest);
      at_ += decimal.length;
      if (decimal.length != 0) return add(std::move(decimal.number), start);
    }
    const std::string_view token = rest.substr(0, length_of_token(rest));
    at_ += token.size();
    if (begins_like_number(token)) return read_number(token, start);
    if (token == ".") return refuse(start, "bad-character", "a dot has no meaning here");
    return add(Datum::checked_symbol(limits_.lower_case ? lower_case(token) : token), start);
  }

  // As it stands in a buffer of the reader's until the next.
  std::string_view lower_case(std::string_view token) {
    lower_.assign(token);
    for (char& c : lower_) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower_;
  }

  bool read_number(std::string_view token, std::size_t start) {
    const bool signed_plus = token.front() == '+';
    const char* begin = token.data() + (signed_plus ? 1 : 0);
    const char* end = token.data() + token.size();
    std::int64_t whole = 0;
    const auto read_whole = std::from_chars(begin, end, whole);
    if (read_whole.ec == std::errc() && read_whole.ptr == end) return add(Datum::integer(whole), start);
    if (read_whole.ec == std::errc::result_out_of_range && read_whole.ptr == end) {
      return refuse(start, "bad-number", "this whole number does not fit in 64 bits");
    }
    double real = 0;
    const auto read_real = std::from_chars(begin, end, real);
    const std::size_t point = token.find('.');
    const bool bare_point =
        point != std::string_view::npos && (!is_digit_at(token, point - 1) || !is_digit_at(token, point + 1));
    if (read_real.ptr != end || bare_point || read_real.ec == std::errc::invalid_argument) {
      return refuse(start, "bad-number", fmt::format("`{}` begins like a number but is none", shortened(token, 40)));
    }
    if (read_real.ec != std::errc()) return refuse(start, "bad-number", "this number is too large or too small");
    return add(Datum::real(real), start);
  }

  static bool is_digit_at(std::string_view token, std::size_t at) {
    return at < token.size() && token[at] >= '0' && token[at] <= '9';
  }

  bool read_string() {
    const std::size_t start = at_++;
    const std::size_t plain = at_;
    at_ += length_of_plain(text_.substr(at_));
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"') return add(Datum::checked_string(text_.substr(plain, at_++ - plain)), start);
      if (c == '\\') return read_escaped_string(start, std::string(text_.substr(plain, at_ - plain)));
      if (!skip_character()) return false;
    }
    return refuse(start, "unclosed-string", "this string is not closed");
  }

  [[gnu::cold]] bool read_escaped_string(std::size_t start, std::string value) {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"') {
        ++at_;
        return add(Datum::checked_string(value), start);
      }
      if (c == '\\') {
        if (!read_escape(value)) return false;
        continue;
      }
      const std::size_t before = at_;
      if (!skip_character()) return false;
      value += text_.substr(before, at_ - before);
    }
    return refuse(start, "unclosed-string", "this string is not closed");
  }

  bool read_escape(std::string& value) {
    const char escaped = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
    switch (escaped) {
      case '"':
      case '\\':
        value += escaped;
        break;
      case 'n':
        value += '\n';
        break;
      case 't':
        value += '\t';
        break;
      default:
        return refuse(at_, "bad-escape", "a backslash is followed by one of \" \\ n t");
    }
    at_ += 2;
    return true;
  }

  // One character inside a string or comment.
  bool skip_character() {
    const char c = text_[at_];
    if (static_cast<unsigned char>(c) < 0x80) {
      if (c == '\0') return refuse(at_, "bad-text", "a NUL byte cannot stand in a text");
      ++at_;
      return true;
    }
    const std::size_t length = utf8_length(text_.substr(at_));
    if (length == 0) return refuse(at_, "bad-text", "this is not UTF-8");
    at_ += length;
    return true;
  }

  [[gnu::cold]] bool skip_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') {
      if (!skip_character()) return false;
    }
    return true;
  }

  std::string_view text_;
  const ReadLimits& limits_;
  std::vector<Spot>* spots_;
  std::size_t at_ = 0;
  std::size_t elements_ = 0;
  std::vector<Datum> waiting_;
  std::vector<Spot> waiting_spots_;
  std::vector<Open> open_;
  std::string lower_;
  SourceError trouble_;
};

Failure failure_of(const SourceError& trouble, std::string_view file, std::string_view text) {
  return {trouble.symbol, trouble.sentence, {}, place_of(file, text, trouble.offset)};
}

}  // namespace

StrictReading read_strictly(std::string_view text, const ReadLimits& limits, std::vector<Spot>* spots) {
  Reader reader(text, limits, spots);
  std::optional<std::vector<Datum>> data = reader.read_all();
  return {std::move(data), reader.trouble()};
}

Result<std::vector<Datum>> read_all(std::string_view text, const ReadLimits& limits, std::string_view file) {
  Reader reader(text, limits, nullptr);
  auto data = reader.read_all();
  if (!data) return fail(failure_of(reader.trouble(), file, text));
  if (data->empty()) return fail(failure_of({text.size(), "nothing-to-read", "nothing is written here"}, file, text));
  return std::move(*data);
}

Result<Datum> read_one(std::string_view text, const ReadLimits& limits, std::string_view file) {
  Result<std::vector<Datum>> data = read_all(text, limits, file);
  if (!data) return fail(data);
  if (data->size() == 1) return std::move(data->front());
  std::vector<Spot> spots;
  Reader(text, limits, &spots).read_all();
  return fail(failure_of({spots[1].offset, "more-than-one", "only one datum may stand here"}, file, text));
}

Result<Source> read_source(std::string_view text, std::string file, const ReadLimits& limits) {
  Source source;
  Reader reader(text, limits, &source.spots_);
  auto data = reader.read_all();
  if (!data) return fail(failure_of(reader.trouble(), file, text));
  source.data_ = std::move(*data);
  source.texts_.front() = {std::move(file), std::string(text)};
  return source;
}

}  // namespace pizarra
