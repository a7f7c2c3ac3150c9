#pragma once

// The servo's states and the objects that came into sight since the console began. A page that is opened later shows
// hours of work by them: the board holds only the state of this moment.
//
//   KeptChanges kept(executor, std::move(board));
//   kept.servo();        // a state and its object, from when it was told until when
//   kept.sightings();    // a state of an object, from when it was told
//
// The newest 4000 of each are kept. They are what the console may read: a page is shown them only where its own session
// may read these relations.

#include <deque>
#include <memory>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/time/task.hpp"

namespace pizarra::console {

struct KeptChange {
  Fact fact;
  Time until{};
};

class KeptChanges {
 public:
  static constexpr std::size_t most = 4000;

  KeptChanges(Executor& executor, std::unique_ptr<Board> board);

  static Datum servo_pattern();
  static Datum sighting_pattern();
  const std::deque<KeptChange>& servo() const { return servo_; }
  const std::deque<KeptChange>& sightings() const { return sightings_; }

 private:
  Task<void> follow_servo();
  Task<void> follow_sightings();

  std::unique_ptr<Board> board_;
  std::deque<KeptChange> servo_;
  std::deque<KeptChange> sightings_;
  Job following_servo_;
  Job following_sightings_;
};

}  // namespace pizarra::console
