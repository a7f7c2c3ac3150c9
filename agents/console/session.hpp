#pragma once

// One page: its WebSocket and its own session with the board, under a name of its own. The page may do what that name
// may; the page's code decides nothing.
//
// The page says forms, one a message. It asks what holds, held or was seen:
//
//   (follow N QUERY)            what holds of the query and every change, also of relations that are yet to come
//   (watch N "QUERY")           the same of what a person typed: refused where it cannot be read or is not known
//   (unwatch N)
//
//   (ask N QUERY)               what holds now, once; nothing where a relation is not known
//   (then N QUERY TIME-US)      what held of the query then, where the board keeps a journal
//   (picture N STREAM TIME-US)  what was seen then, where it is kept
//
// It asks for deeds:
//
//   (request N AGENT OPERATION) asks an agent, as any client does; `coordinator` is whoever plays that role
//   (goal N "TEXT")             accepted, and then how it ended: two answers, the
//                               second the state it ended in, or its refusal
//   (stop N "REASON")           a stop fact; needs nothing but the right to tell it; may come on a lane as well
//   (clear-stops N)             takes every stop back; who does so has an arm in hand
//
// It has an arm in hand, and jogs it:
//
//   (ask-for N ROBOT), (ask-no-more N ROBOT)                     others are told: (commander-wanted ROBOT US)
//   (command N ROBOT), (take-over N ROBOT), (let-go N ROBOT)     the arm in one operator's hands: (commander ROBOT US)
//   (stamp N)                   the page has the stamp N (pulse.hpp)
//   (jog N ROBOT DIRECTION STAMP)                the arm moves until (release N); the answer says how it ended
//   (hold-on N STAMP)           the jog goes on; the page says it every 50 ms
//   (release N)                 the jog ends
//
// It asks for more to be told:
//
//   (truth), (truth-no-more)    the simulated world's truth, of which no board is told (truth_feed.hpp); only to a page
//                               of the console's own machine
//   (activity), (activity-no-more)               what goes on on the board, once a second (instruments.hpp)
//   (work N)                    what went on so far (kept_changes.hpp)
//   (method N SECONDS)          what the components are and how they are connected, as seen for so long
//   (cells N)                   how the cells do that this board names
//   (look STREAM), (look-away STREAM)            images, on the lanes that it opens (page_images.hpp), of a stream
//                               whose fact it may read
//   (heard N)                   it has taken in N more messages of facts, changes and arms; what it has not is bounded
//
// It is told, as JSON (change_text.hpp): {"hello":...} (with the version of the page that is
// served, and what it may not do: page_rights.hpp), {"watch":N,...} (of the past with "past":TIME-US),
// {"reply":N,...}, {"arm":NAME,...}, {"truth":TEXT}, {"activity":{...}},
// {"work":"servo","changes":[...]} some at a time,
// {"pulse":STAMP,"deadline":MS,"rtt":MS}; a picture
// that was asked for as binary: a line `(picture N NUMBER CAPTURED-US WIDTH HEIGHT)`, and the JPEG behind it.
//
// Bounds: PageQuestions::max_watches, NumberedRequests::most in hand, those of the images. The watches of a page wait
// where it does not take in what it is told, PageVoice::max_unheard_bytes of it: the board resynchronises them.

#include <functional>
#include <memory>
#include <string>

#include "agents/console/cell_view.hpp"
#include "agents/console/image_feed.hpp"
#include "agents/console/instruments.hpp"
#include "agents/console/kept_changes.hpp"
#include "agents/console/page_board.hpp"
#include "agents/console/page_voice.hpp"
#include "agents/console/picture_store.hpp"
#include "agents/console/truth_feed.hpp"

namespace pizarra::console {

class Session {
 public:
  struct Setup {
    Executor& executor;
    ImageFeeds& images;
    const CellView& cell;
    int number;        // of the page; its lanes are opened by it
    std::string name;  // on the board
    std::unique_ptr<Board> board;
    Time until;                   // the page is let go then
    std::function<void()> ended;  // it has left the board; this may be destroyed
    const PictureStore* pictures = nullptr;
    TruthFeed* truth = nullptr;
    KeptChanges* kept = nullptr;
    const Instruments* instruments = nullptr;
    std::string key = {};                    // whose the page is; empty: the console's own
    std::string page_version = {};           // of the page's files that are served
    Instruments::Connect connect = nullptr;  // others on the board with this page's rights
  };

  Session(Setup setup, web::UpgradedSocket socket);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  // One more connection of the page, for its images, while it takes one.
  bool takes_lane() const;
  void add_lane(web::UpgradedSocket socket);
  // As if the page had gone.
  void leave();
  // It is told why, and has gone a second later at most.
  void dismiss(std::string_view why);

 private:
  struct Verb;
  struct Parts;

  void hear(std::string_view message);
  bool hear_on_lane(const Datum& form);
  Task<void> open();
  Task<void> run_out();
  Task<void> close_board();

  Setup setup_;
  PageBoard board_;
  PageVoice voice_;
  std::unique_ptr<Parts> parts_;       // none: the page has left
  Executor::TimerId going_timer_ = 0;  // of a page that was dismissed
  Job opening_;
  Job running_out_;
  Job closing_;
};

}  // namespace pizarra::console
