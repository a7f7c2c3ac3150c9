#pragma once

// Random data for property tests: any datum that the language can write.

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "lisp/datum.hpp"

namespace pizarra {

class RandomDatum {
 public:
  explicit RandomDatum(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t below(std::uint64_t bound) { return engine_() % bound; }

  Datum any(int depth) {
    switch (below(depth > 0 ? 7 : 5)) {
      case 0:
        return Datum::symbol(symbol_name());
      case 1:
        return Datum::string(text());
      case 2:
        return Datum::integer(static_cast<std::int64_t>(engine_() >> below(64)));
      case 3:
        return Datum::real(real());
      case 4:
        return {};
      default:
        break;
    }
    std::vector<Datum> items(below(6));
    for (Datum& item : items) item = any(depth - 1);
    return Datum::list(std::move(items));
  }

 private:
  std::string symbol_name() {
    static constexpr std::string_view chars = "abcXYZ019!$%&*/:<=>?^_~+-.@";
    while (true) {
      std::string out(1 + below(30), 'a');
      for (char& c : out) c = chars[below(chars.size())];
      if (is_symbol_name(out)) return out;
    }
  }

  std::string text() {
    static constexpr std::string_view parts[] = {"a", " ",    "\n", "\t", "\"", "\\", "(",
                                                 ";", "\x01", "ñ",  "€",  "🤖", "\r"};
    std::string out;
    for (auto n = below(20); n > 0; --n) out += parts[below(std::size(parts))];
    return out;
  }

  double real() {
    while (true) {
      const double value =
          below(2) ? std::bit_cast<double>(engine_()) : static_cast<double>(below(100'000)) / 100 - 500;
      if (std::isfinite(value)) return value;
    }
  }

  std::mt19937_64 engine_;
};

}  // namespace pizarra
