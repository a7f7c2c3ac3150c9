#include "lisp/keyed_hash.hpp"

#include <array>
#include <cassert>
#include <cstring>
#include <stdexcept>
#include <sys/random.h>

namespace pizarra {

HashKey draw_hash_key() {
  HashKey random;
  if (getrandom(random.data(), sizeof random, 0) != sizeof random)
    throw std::runtime_error("no random numbers to be had");
  return random;
}

std::uint64_t keyed_hash(std::string_view text) {
  std::array<std::uint64_t, 2> words;
  assert(text.size() >= sizeof words);
  std::uint64_t hash = text.size();
  const auto mix_at = [&](std::size_t at) {
    std::memcpy(words.data(), text.data() + at, sizeof words);
    hash = keyed_mix(keyed_mix(hash, words[0]), words[1]);
  };
  const std::size_t last = text.size() - sizeof words;
  for (std::size_t at = 0; at < last; at += sizeof words) mix_at(at);
  mix_at(last);
  return hash;
}

}  // namespace pizarra
