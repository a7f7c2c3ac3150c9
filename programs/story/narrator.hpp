#pragma once

// The narrator tells the story of a run on the terminal, from facts alone: what is seen, the plan, each operation and
// servo state, what differed, the new plan, the result. One line an event, with the cell's time.
//
//   Narrator narrator(stdout, Narrator::style_for(stdout, json));
//   Job told = executor.spawn(narrator.follow(*view, executor));
//   narrator.say(executor.now(), "hand", "pushes circle 40 mm to the right");

#include <cstdio>
#include <set>
#include <string>

#include "agents/launcher/camera_loss_news.hpp"
#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::story {

class Narrator {
 public:
  enum class Style { silent, plain, colour, json };
  // Colour on a terminal that has not said NO_COLOR.
  static Style style_for(std::FILE* out, bool json);

  Narrator(std::FILE* out, Style style) : out_(out), style_(style) {}

  // Time zero of the lines.
  void begin(Time start) { start_ = start; }
  void say(Time when, std::string_view kind, std::string_view sentence, const Datum& detail = {});
  // Tells every (event ...) fact, each state the servo enters, the coming and going of agents, why one has no images,
  // and when all is taught, until destroyed. Both outlive it. A board that dies and lives again tells nothing twice:
  // its agents have a while to be present again before they are said to be gone. One that does not answer yet is waited
  // for, and that is told.
  Task<void> follow(Board& board, Executor& executor);
  // The newest line without its colours, for the film's caption.
  const std::string& newest() const { return newest_; }

 private:
  Task<Result<std::unique_ptr<Watch>>> watch_when_there(Board& board, Executor& executor, Datum pattern);
  Task<void> follow_pattern(Board& board, Executor& executor, Datum pattern);
  void tell_change(const Change& change, Executor& executor);
  void tell_added(const Fact& fact);
  Task<void> tell_who_stays_away(Executor& executor);

  std::FILE* out_;
  Style style_;
  Time start_{};
  std::string newest_;
  std::int64_t last_event_ = 0;
  Datum last_servo_;
  Datum last_person_;
  launcher::CameraLossNews camera_news_;
  std::set<Datum> present_;  // agents that were told to be there
  std::set<Datum> missing_;  // those of them that a board which lives again has yet to hear of
  Job waiting_;
  std::string away_;  // why the board is waited for, as it was told
};

}  // namespace pizarra::story
