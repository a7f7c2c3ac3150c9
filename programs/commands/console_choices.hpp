#pragma once

// The options of `pizarra console`.
//
//   ConsoleChoices choices;
//   add_console_options(command, choices);
//   abroad_of(choices);                     // how other machines reach it; a failure where its files do not serve

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "agents/console/console.hpp"
#include "programs/commands/board_session.hpp"

namespace pizarra::programs {

struct ConsoleChoices {
  BoardChoices board;
  std::string cell_file;
  std::uint64_t seed = 1;
  bool seed_given = false;
  int port = 0;
  std::string addresses;  // where they go as well
  bool foxglove = false;
  std::vector<std::string> foxglove_origins;
  std::string listen;  // an address that other machines reach
  std::vector<std::string> hosts;
  std::string certificate;
  std::string certificate_key;
  std::string keys;      // the folder of the operators' keys and tokens
  std::string journal;   // of the board; empty: that of the cell that runs here
  std::string pictures;  // the folder; empty: one of its own, gone with it
  int pictures_mb = static_cast<int>(console::PictureStore::usual_bytes / 1'000'000);

  std::optional<console::Console::Foxglove> viewers() const {
    if (!foxglove) return std::nullopt;
    return console::Console::Foxglove{foxglove_origins};
  }
};

void add_console_options(CLI::App& command, ConsoleChoices& choices);
// Nothing where the console stays on loopback. Nobody else's browser comes without TLS and the token of a key.
// Failures: bad-certificate, exposed-key.
Result<std::optional<console::Console::Abroad>> abroad_of(const ConsoleChoices& choices);

}  // namespace pizarra::programs
