#pragma once

// The option `--key FILE` of the words that come to a board as a client; without it the environment's PIZARRA_KEY.
//
//   add_key_option(word, choices.key);
//   const Result<std::optional<ClientKeys>> keys = keys_from(choices.key);

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "blackboard/wire/keys.hpp"

namespace pizarra::programs {

inline void add_key_option(CLI::App* word, std::string& file) {
  word->add_option("--key", file, "Your secret key, NAME.secret; the board's board.key must be beside it")
      ->envname("PIZARRA_KEY")
      ->type_name("FILE");
}

// No keys where no file is named. Failures as of read_client_keys.
inline Result<std::optional<wire::ClientKeys>> keys_from(const std::string& file) {
  if (file.empty()) return std::nullopt;
  Result<wire::ClientKeys> keys = wire::read_client_keys(file);
  if (!keys) return fail(keys);
  return std::move(*keys);
}

}  // namespace pizarra::programs
