#pragma once

// The servo's states and the objects that came into sight: since the board's journal begins, where there is one to
// read, or since the console began. A page that is opened later shows hours of work by them: the board holds only the
// state of this moment.
//
//   KeptChanges kept(executor, std::move(board), "/run/.../board.journal");
//   co_await kept.read();          // what the journal has of them
//   kept.servo();                  // a state and its object, from when it was told until when
//   kept.sightings();              // a state of an object, from when it was told
//
// The newest 4000 of each are kept. They are what the console may read: a page is shown them only where its own session
// may read these relations.

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/time/latch.hpp"
#include "blackboard/time/task.hpp"

namespace pizarra::console {

struct KeptChange {
  Fact fact;
  Time until{};
};

class KeptChanges {
 public:
  static constexpr std::size_t most = 4000;

  struct Kept {
    std::deque<KeptChange> servo;
    std::deque<KeptChange> sightings;
    bool servo_ended = true;
    // What stands of the servo; none: it has ended.
    void take_servo(const std::vector<Fact>& told);
    void take_sighting(const Fact& fact);
  };

  // `journal`: a file; empty: there is none.
  KeptChanges(Executor& executor, std::unique_ptr<Board> board, std::string journal);

  static Datum servo_pattern();
  static Datum sighting_pattern();
  Task<void> read();
  const std::deque<KeptChange>& servo() const { return kept_.servo; }
  const std::deque<KeptChange>& sightings() const { return kept_.sightings; }

 private:
  Task<void> follow_servo();
  Task<void> follow_sightings();
  Task<void> read_journal(std::string journal);

  Executor& executor_;
  std::unique_ptr<Board> board_;
  Kept kept_;
  Event read_;
  Job following_servo_;
  Job following_sightings_;
  Job reading_;
};

}  // namespace pizarra::console
