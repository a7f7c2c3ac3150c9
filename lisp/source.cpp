#include <algorithm>
#include <array>
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

std::size_t Source::offset_at(const std::vector<std::size_t>& path) const {
  const std::vector<Spot>* level = &spots_;
  std::size_t offset = 0;
  for (const std::size_t index : path) {
    if (index >= level->size()) break;
    offset = (*level)[index].offset;
    level = &(*level)[index].items;
  }
  return offset;
}

Failure Source::failure_of(const SourceError& error) const {
  return {error.symbol, error.sentence, {}, place_of(file_, text_, error.offset)};
}

Failure Source::failure_at(const std::vector<std::size_t>& path, std::string symbol, std::string sentence,
                           const std::vector<std::string>& context) const {
  std::span<const Datum> elements = data_;
  Datum subject;
  for (const std::size_t index : path) {
    if (index >= elements.size()) break;
    subject = elements[index];
    elements = subject.items();
  }
  Failure out{std::move(symbol), std::move(sentence), std::move(subject), place_of(file_, text_, offset_at(path))};
  for (const std::string& line : context) out.place += "\n  " + line;
  return out;
}

Result<std::string> read_text_file(const std::string& path, const ReadLimits& limits) {
  std::ifstream in(path, std::ios::binary);
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
  return text;
}

Result<Source> read_source_file(const std::string& path, const ReadLimits& limits) {
  const Result<std::string> text = read_text_file(path, limits);
  if (!text) return fail(text);
  return read_source(*text, path, limits);
}

}  // namespace pizarra
