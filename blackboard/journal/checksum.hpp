#pragma once

// What a row of a file is known again by, for SQLite has no sums of its own: FNV-1a, 64 bits.
//
//   std::int64_t sum = Checksum().add("(on a b)").add(7).value();

#include <cstdint>
#include <string_view>

namespace pizarra {

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
  std::int64_t value() const { return static_cast<std::int64_t>(sum_); }

 private:
  void add_byte(unsigned char byte) { sum_ = (sum_ ^ byte) * 1099511628211U; }
  std::uint64_t sum_ = 14695981039346656037U;
};

}  // namespace pizarra
