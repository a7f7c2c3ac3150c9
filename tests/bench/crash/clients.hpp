#pragma once

// Who uses the board while it is killed: writers tell items, one of them more at once than a board remembers, who
// leaves before all of it is answered; takers turn each into one effect, watchers follow the writers' counters and look
// for a gap; others read registers and put new values where an old one stands, and take tokens for good. Each is a
// process, and reports what it knows for sure.
//
//   (item WRITER N)            durable, to be taken
//   (counter WRITER N)         durable, replaced with every item
//   (effect WRITER N SERIAL)   durable, what was made of an item; SERIAL differs each time one is made
//   (register K VALUE)         durable, a new K every few seconds; each VALUE is written once
//   (token WHO N)              durable, taken without a lease

#include <cstdint>
#include <string>
#include <vector>

#include "blackboard/relation.hpp"
#include "tests/bench/crash/linearizable.hpp"

namespace pizarra::bench {

struct Report {
  // `called` and `answered` are of operation `n` of all, on register `writer`.
  enum class Kind : std::int32_t { told, made, gap, got, called, answered } kind;
  std::int32_t writer;
  std::int64_t n;
  Operation operation = {};
};

std::vector<Relation> crash_relations();

// They go on until they are killed. `who` is a number that no other client has.
void write_items(const std::string& address, int who, int reports);
void flood_items(const std::string& address, int who, int reports);
void take_items(const std::string& address, int who, int reports);
void watch_counters(const std::string& address, int who, int reports);
void compare_registers(const std::string& address, int who, int reports);

}  // namespace pizarra::bench
