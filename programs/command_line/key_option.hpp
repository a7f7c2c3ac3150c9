#pragma once

// The option `--key FILE` of the words that come to a board as a client; without it the environment's PIZARRA_KEY.
//
//   add_key_option(word, choices.key);
//   const auto board = client::keyed_board(executor, choices.board, choices.key, "look");

#include <CLI/CLI.hpp>
#include <string>

namespace pizarra::programs {

inline void add_key_option(CLI::App* word, std::string& file) {
  word->add_option("--key", file, "Your secret key, NAME.secret; the board's board.key must be beside it")
      ->envname("PIZARRA_KEY")
      ->type_name("FILE");
}

}  // namespace pizarra::programs
