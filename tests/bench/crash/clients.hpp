#pragma once

// Who uses the board while it is killed: writers tell items, one of them more at once than a board remembers, who
// leaves before all of it is answered; takers turn each into one effect, watchers follow the writers' counters and look
// for a gap. Each is a process, and reports what it knows for sure.
//
//   (item WRITER N)            durable, to be taken
//   (counter WRITER N)         durable, replaced with every item
//   (effect WRITER N SERIAL)   durable, what was made of an item; SERIAL differs each time one is made

#include <cstdint>
#include <string>
#include <vector>

#include "blackboard/relation.hpp"

namespace pizarra::bench {

struct Report {
  enum class Kind : std::int32_t { told, made, gap } kind;
  std::int32_t writer;
  std::int64_t n;
};

std::vector<Relation> crash_relations();

// They go on until they are killed. `who` is a number that no other client has.
void write_items(const std::string& address, int who, int reports);
void flood_items(const std::string& address, int who, int reports);
void take_items(const std::string& address, int who, int reports);
void watch_counters(const std::string& address, int who, int reports);

}  // namespace pizarra::bench
