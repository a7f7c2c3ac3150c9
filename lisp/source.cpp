#include <array>
#include <fmt/format.h>
#include <fstream>
#include <utility>

#include "lisp/characters.hpp"
#include "lisp/reader.hpp"

namespace pizarra {

Failure Source::failure_at(const std::vector<std::size_t>& path, std::string symbol, std::string sentence,
                           const std::vector<std::string>& context) const {
  const std::vector<Spot>* level = &spots_;
  std::span<const Datum> elements = data_;
  std::size_t offset = 0;
  Datum subject;
  for (const std::size_t index : path) {
    if (index >= level->size()) break;
    const Spot& spot = (*level)[index];
    offset = spot.offset;
    subject = elements[index];
    elements = subject.items();
    level = &spot.items;
  }
  Failure out{std::move(symbol), std::move(sentence), std::move(subject), place_of(file_, text_, offset)};
  for (const std::string& line : context) out.place += "\n  " + line;
  return out;
}

Result<Source> read_source_file(const std::string& path, const ReadLimits& limits) {
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
  return read_source(text, path, limits);
}

}  // namespace pizarra
