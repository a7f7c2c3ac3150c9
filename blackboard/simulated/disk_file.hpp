#pragma once

// A file of a SimulatedDisk: what stands in it, what of that was not flushed yet, and who has locked what of it.
//
//   file.write(offset, text);
//   file.flushed();                        // what was written until now survives
//   file.lose_some(random);                // what was not, piece by piece, or does not

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "blackboard/time/random.hpp"

namespace pizarra::simulated {

struct DiskFile {
  explicit DiskFile(std::uint64_t the_number) : number(the_number) {}

  void write(std::int64_t offset, std::string_view text);
  void cut(std::int64_t bytes);
  void flushed() { unflushed.clear(); }
  void lose_some(Random& random);
  // Whoever has it open was killed: the system lets go of what they had.
  void forget_its_users();

  const std::uint64_t number;
  std::string data;
  std::int64_t set_aside = 0;  // bytes beyond what is written that nobody else may have
  bool locked = false;         // by a board, for as long as it lives

  // The contents that an unflushed write replaced.
  struct Before {
    std::int64_t offset;
    std::string text;
    std::size_t bytes;  // of the whole file
  };
  std::vector<Before> unflushed;

  // SQLite's locks: readers of the file, one who is about to write, one who writes alone.
  int shared = 0;
  bool reserved = false;
  bool exclusive = false;
  // Its index of the log, which its connections share, and the locks on that.
  static constexpr std::size_t shared_locks = 8;
  std::vector<std::unique_ptr<std::string>> index;
  std::vector<std::unique_ptr<std::string>> former_indexes;  // of connections whose process was killed
  int index_users = 0;
  std::array<int, shared_locks> index_shared{};
  std::array<bool, shared_locks> index_exclusive{};
};

}  // namespace pizarra::simulated
