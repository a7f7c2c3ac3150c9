#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <utility>

#include "lisp/characters.hpp"
#include "lisp/reader.hpp"

namespace pizarra {

namespace {

constexpr std::size_t most_reported = 20;

}  // namespace

Failure one_report(const std::vector<Failure>& failures) {
  Failure out = failures.front();
  if (failures.size() > 1) out.sentence += fmt::format(" (and {} more)", failures.size() - 1);
  for (std::size_t i = 1; i < std::min(failures.size(), most_reported); ++i) {
    out.place += '\n' + failures[i].sentence + '\n' + failures[i].place;
  }
  if (failures.size() > most_reported) out.place += fmt::format("\nand {} more", failures.size() - most_reported);
  return out;
}

Source::Place Source::place_at(const std::vector<std::size_t>& path) const {
  const std::vector<Spot>* level = &spots_;
  Place place;
  std::size_t end = spots_.empty() ? 0 : spots_.back().last + 1;
  for (const std::size_t index : path) {
    if (index == level->size()) return {place.text, end};
    if (index > level->size()) break;
    const Spot& spot = (*level)[index];
    place = {spot.text, spot.offset};
    end = spot.last;
    level = &spot.items;
  }
  return place;
}

std::size_t Source::offset_at(const std::vector<std::size_t>& path) const { return place_at(path).offset; }

void Source::replace_first(const Datum& datum, Spot spot, const Source& other) {
  assert(!data_.empty());
  data_.front() = datum;
  spots_.front() = std::move(spot);
  texts_.insert(texts_.end(), other.texts_.begin(), other.texts_.end());
}

Failure Source::failure_of(const SourceError& error) const {
  return {error.symbol, error.sentence, {}, place_of(file(), text(), error.offset)};
}

Failure Source::failure_at(const std::vector<std::size_t>& path, std::string symbol, std::string sentence,
                           const std::vector<std::string>& context) const {
  std::span<const Datum> elements = data_;
  Datum subject;
  for (const std::size_t index : path) {
    if (index == elements.size()) subject = Datum();
    if (index >= elements.size()) break;
    subject = elements[index];
    elements = subject.items();
  }
  const Place place = place_at(path);
  const Text& stands_in = texts_[place.text];
  Failure out{std::move(symbol), std::move(sentence), std::move(subject),
              place_of(stands_in.file, stands_in.text, place.offset)};
  for (const std::string& line : context) out.place += "\n  " + line;
  return out;
}

namespace {

// What editors on some systems put before UTF-8.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_text(std::string_view bytes) {
  constexpr std::string_view blanks = "\t\n\v\f\r";
  return std::ranges::none_of(bytes, [&](char c) {
    return (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) && blanks.find(c) == blanks.npos;
  });
}

}  // namespace

Result<std::string> read_text_file(const std::string& path, const ReadLimits& limits) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) {
    return fail("unreadable-file", fmt::format("{} is a folder, and a file must be named", path));
  }
  std::ifstream in(path, std::ios::binary);
  const bool missing = !in && !std::filesystem::exists(path, unknown);
  if (missing) return fail("unreadable-file", fmt::format("there is no file {}", path));
  if (!in) return fail("unreadable-file", fmt::format("the file {} cannot be opened", path));
  std::string text;
  std::array<char, 65536> part;
  while (text.size() <= limits.bytes && in.read(part.data(), part.size()).gcount() > 0) {
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad() || (in.fail() && !in.eof()))
    return fail("unreadable-file", fmt::format("the file {} cannot be read", path));
  if (text.size() > limits.bytes) {
    return fail("too-long", fmt::format("the file {} has more than {} bytes", path, limits.bytes));
  }
  if (!is_text(text)) return fail("unreadable-file", fmt::format("the file {} is not text", path));
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  return text;
}

Result<Source> read_source_file(const std::string& path, const ReadLimits& limits) {
  const Result<std::string> text = read_text_file(path, limits);
  if (!text) return fail(text);
  return read_source(*text, path, limits);
}

}  // namespace pizarra
