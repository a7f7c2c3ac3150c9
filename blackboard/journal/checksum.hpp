#pragma once

// The checksum of a row, because SQLite keeps none: FNV-1a, 64 bits.
//
//   std::int64_t sum = Checksum().add("(on a b)").add(7).value();
//   std::int64_t sum_of_long_text = Checksum().add_words(lines).value();      // eight bytes at a time, and their
//   number

#include <cstdint>
#include <cstring>
#include <string_view>

namespace pizarra::journal {

class Checksum {
 public:
  Checksum& add(std::string_view text) {
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
    return *this;
  }
  Checksum& add(std::uint64_t number) {
    for (int shift = 0; shift < 64; shift += 8) add_byte(static_cast<unsigned char>(number >> shift));
    return *this;
  }
  Checksum& add_words(std::string_view text) {
    add_word(text.size());
    for (; text.size() >= sizeof(std::uint64_t); text.remove_prefix(sizeof(std::uint64_t))) add_word(word_of(text));
    if (!text.empty()) add_word(word_of(text));
    return *this;
  }
  std::int64_t value() const { return static_cast<std::int64_t>(sum_); }

 private:
  void add_byte(unsigned char byte) { sum_ = (sum_ ^ byte) * 1099511628211U; }
  // Both steps can be undone, so that no two words lead from one sum to the same.
  void add_word(std::uint64_t word) {
    sum_ = (sum_ ^ word) * 0x9e3779b97f4a7c15U;
    sum_ ^= sum_ >> 32;
  }
  // What a text begins with, zeros behind it.
  static std::uint64_t word_of(std::string_view text) {
    std::uint64_t word = 0;
    std::memcpy(&word, text.data(), text.size() < sizeof word ? text.size() : sizeof word);
    return word;
  }
  std::uint64_t sum_ = 14695981039346656037U;
};

}  // namespace pizarra::journal
