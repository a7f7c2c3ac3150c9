#include "blackboard/journal/journal_room.hpp"

#include <algorithm>

#include "blackboard/journal/space_reserve.hpp"

namespace pizarra::journal {

namespace {

constexpr std::int64_t kept_for_removals = 2 << 20;
constexpr std::int64_t plenty = 2 * kept_for_removals;
// Pages have heads, and some others are written with a group's own.
constexpr std::int64_t other_pages = 192 << 10;

std::size_t bytes_of_groups(std::int64_t log, std::int64_t free_in_file) {
  return static_cast<std::size_t>(std::max<std::int64_t>(std::min(log, (log + free_in_file) / 2), 0));
}

}  // namespace

bool is_ample(std::int64_t set_aside) { return 2 * set_aside > SpaceReserve::most; }

JournalRoom room_with(std::int64_t set_aside, std::int64_t free_in_file) {
  if (is_ample(set_aside)) {
    const auto all = static_cast<std::size_t>(set_aside - set_aside / 32 - other_pages);
    return {.for_all = all, .for_removals = all, .for_passing = all};
  }
  // An eighth of it may be in the log already, waiting to be copied.
  const std::int64_t log = set_aside - set_aside / 8 - other_pages;
  const std::int64_t kept = std::max<std::int64_t>(kept_for_removals - free_in_file, 0);
  JournalRoom room;
  room.for_all = bytes_of_groups(log - kept, free_in_file);
  room.for_removals = bytes_of_groups(log, free_in_file);
  const std::int64_t to_grow = std::max<std::int64_t>(set_aside - kept_for_removals, 0);
  room.for_passing = to_grow + std::max<std::int64_t>(free_in_file - other_pages, 0);
  room.is_scarce = room.for_all == 0 || set_aside + free_in_file < plenty;
  return room;
}

}  // namespace pizarra::journal
