#include "lisp/forms/sentence.hpp"

#include <algorithm>
#include <cctype>

#include "lisp/guile/scheme.hpp"

namespace pizarra::forms {

namespace {

constexpr ReadLimits sentence_limits{.bytes = 500, .depth = 1, .elements = 50};

// Words alone: small letters, and no stops but those within numbers.
std::string plain(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto letter = static_cast<unsigned char>(text[i]);
    const bool within = i + 1 < text.size() && std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0;
    const bool said = std::isalnum(letter) != 0 || letter == '-' || (letter == '.' && within);
    out += said ? static_cast<char>(std::tolower(letter)) : ' ';
  }
  return out;
}

}  // namespace

Result<Sentence> read_sentence(std::string_view text) {
  const Result<Source> source =
      read_source(plain(text.substr(0, sentence_limits.bytes + 1)), "sentence", sentence_limits);
  if (!source) return fail(source);
  const Result<Datum> meant = guile::interpret(*source, "sentences");
  if (!meant) return fail(meant);
  return Sentence{std::string((*meant)[0].text()), (*meant)[1]};
}

}  // namespace pizarra::forms
