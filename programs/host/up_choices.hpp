#pragma once

// What was typed behind `up`.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace pizarra::host {

struct UpChoices {
  std::string cell;
  std::string host;
  std::string board;
  std::string key;
  std::string keys;
  std::string world;
  std::string log;
  std::string certificates;
  std::string standby;
  std::string log_here;
  std::string log_folder;
  std::string past;
  bool log_insecure = false;
  std::uint64_t seed = 1;
  bool json = false;
  bool console = false;
};

// Those of a cell's log, of its member here, of a board that stands by, and of the past that the board here keeps.
void add_log_options(CLI::App& app, UpChoices& choices);

}  // namespace pizarra::host
