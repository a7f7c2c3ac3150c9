#pragma once

// The measurements that a page shows, each taken only while the page looks at it: the simulated world's truth, the
// traffic of the board, the method of the running cell, the state of other cells. It also tells the page what happened
// before the page was opened.
//
//   PageInstruments instruments({executor, board, name, ...}, voice);
//   instruments.show_activity(true);                 // once a second, until that is false
//   instruments.look_at_method(7, 10);               // the answer to request 7, in ten seconds
//
// Destroying it ends all that is under way.

#include <memory>
#include <string>

#include "agents/console/instruments.hpp"
#include "agents/console/kept_changes.hpp"
#include "agents/console/page_voice.hpp"
#include "agents/console/truth_feed.hpp"

namespace pizarra::console {

class PageInstruments {
 public:
  using Request = std::int64_t;
  struct Setup {
    Executor& executor;
    Board& board;      // the page's own session with it
    std::string name;  // of that
    std::string key;   // whose the page is; empty: the console's own
    TruthFeed* truth;
    KeptChanges* kept;
    const Instruments* instruments;
    Instruments::Connect connect;
  };

  // The voice outlives it.
  PageInstruments(Setup setup, PageVoice& voice) : setup_(std::move(setup)), voice_(voice) {}

  bool may_see_truth() const;
  void show_truth(bool looks);
  void show_activity(bool looks);
  // Then answers that request.
  Task<void> tell_work(Request request);
  void look_at_method(Request request, std::int64_t seconds);
  void look_at_cells(Request request);

 private:
  Task<void> sample_activity();
  Task<void> say_kept(std::string kind, Datum pattern, const std::deque<KeptChange>& kept);
  Task<void> see_cells(Request request);
  Task<void> see_method(Request request, Duration length);

  const Setup setup_;
  PageVoice& voice_;
  std::unique_ptr<TruthFeed::Look> truth_;
  Job activity_;
  Job method_;
  Job cells_;
};

}  // namespace pizarra::console
