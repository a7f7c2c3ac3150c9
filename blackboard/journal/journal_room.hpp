#pragma once

// How much more may wait to be written to a journal, by the space that there is for it.
//
//   const JournalRoom room = room_with(set_aside, free_in_file);
//
// A group goes into SQLite's log first, which grows into the space set aside; from there it is copied to where it
// belongs, which takes as much again unless the file has pages that are free. The last of the space is for changes that
// take facts away and add none, and for compaction, which makes pages free: a journal that fills its disk all by itself
// has a way out.

#include <cstddef>
#include <cstdint>
#include <string>

namespace pizarra::journal {

struct JournalRoom {
  std::size_t for_all = 0;  // bytes of groups
  std::size_t for_removals = 0;
  std::size_t for_passing = 0;  // on a full disk: what the last of the space is not needed for
  bool is_scarce = false;
  bool past_goes = false;    // it should make room, or there is too much of it
  std::string lacking = {};  // why there is none; otherwise the disk is full
};

JournalRoom room_with(std::int64_t set_aside, std::int64_t free_in_file);
// Whether so much is set aside that it does not matter what is free in the file.
bool is_ample(std::int64_t set_aside);

}  // namespace pizarra::journal
