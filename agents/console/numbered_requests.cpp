#include "agents/console/numbered_requests.hpp"

#include <fmt/format.h>

#include "agents/console/change_text.hpp"

namespace pizarra::console {

bool NumberedRequests::begin(std::int64_t number, Task<void> task) {
  std::erase_if(under_way_, [](const auto& entry) { return entry.second.done(); });
  if (under_way_.size() >= most) {
    voice_.refuse(number, "too-many", fmt::format("{} requests are in hand already", most));
    return false;
  }
  if (under_way_.contains(number)) {
    voice_.refuse(number, "malformed", "a request of that number is in hand");
    return false;
  }
  under_way_.emplace(number, executor_.spawn(std::move(task)));
  return true;
}

void NumberedRequests::change_board(std::int64_t number, Board& board, Transaction transaction, Failure unmet) {
  begin(number, change(number, board, std::move(transaction), std::move(unmet)));
}

Task<void> NumberedRequests::change(std::int64_t number, Board& board, Transaction transaction, Failure unmet) {
  Result<Revision> changed = co_await board.transact(std::move(transaction));
  changed = if_it_stands(std::move(changed));
  const Datum done;
  if (changed) {
    voice_.say(reply_text(number, done));
  } else {
    const bool failed = changed.error().symbol == "precondition-failed";
    voice_.say(refusal_text(number, failed ? unmet : changed.error()));
  }
}

}  // namespace pizarra::console
