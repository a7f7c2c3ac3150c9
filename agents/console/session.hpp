#pragma once

// One page: its WebSocket and its own session with the board, under a name of its own. The page may do what that name
// may; the page's code decides nothing.
//
// The page says forms, one a message:
//   (follow N QUERY)            what holds of the query and every change, also of relations that are yet to come
//   (watch N "QUERY")           the same of what a person typed: refused where it cannot be read or is not known
//   (unwatch N)
//   (ask N QUERY)               what holds now, once; nothing where a relation is not known
//   (then N QUERY TIME-US)      what held of the query then, where the board keeps a journal
//   (picture N STREAM TIME-US)  what was seen then, where it is kept
//   (request N AGENT OPERATION) asks an agent, as any client does; `coordinator` is whoever plays that role
//   (goal N "TEXT")             accepted, and then how it ended: two answers, the
//                               second the state it ended in, or its refusal
//   (stop N "REASON")           a stop fact; needs nothing but the right to tell it; may come on a lane as well
//   (clear-stops N)             takes every stop back; who does so has an arm in hand
//   (ask-for N ROBOT), (ask-no-more N ROBOT)                     others are told: (commander-wanted ROBOT US)
//   (command N ROBOT), (take-over N ROBOT), (let-go N ROBOT)     the arm in one operator's hands: (commander ROBOT US)
//   (stamp N)                   the page has the stamp N (pulse.hpp)
//   (jog N ROBOT DIRECTION STAMP)                the arm moves until (release N); the answer says how it ended
//   (hold-on N STAMP)           the jog goes on; the page says it every 50 ms
//   (release N)                 the jog ends
//   (truth), (truth-no-more)    the simulated world's truth, of which no board is told (truth_feed.hpp); only to a page
//                               of the console's own machine
//   (activity), (activity-no-more)               what goes on on the board, once a second (instruments.hpp)
//   (work N)                    what went on so far (kept_changes.hpp)
//   (method N SECONDS)          what the components are and how they are connected, as seen for so long
//   (cells N)                   how the cells do that this board names
//   (look STREAM), (look-away STREAM)            images, on the lanes that it opens (page_images.hpp), of a stream
//                               whose fact it may read
//   (heard N)                   it has taken in N more messages of facts, changes and arms; what it has not is bounded
// and is told, as JSON (change_text.hpp): {"hello":...} (with the version of the page that is
// served, and what it may not do: page_rights.hpp), {"watch":N,...} (of the past with "past":TIME-US),
// {"reply":N,...}, {"arm":NAME,...}, {"truth":TEXT}, {"activity":{...}},
// {"work":"servo","changes":[...]} some at a time,
// {"pulse":STAMP,"deadline":MS,"rtt":MS}; a picture
// that was asked for as binary: a line `(picture N NUMBER CAPTURED-US WIDTH HEIGHT)`, and the JPEG behind it.
//
// Bounds: 64 watches, 16 requests in hand, those of the images. A page that does not take in what it is told, some
// 256 kB of it, has its watches wait: the board resynchronises them.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/console/page_images.hpp"
#include "agents/console/page_instruments.hpp"
#include "agents/console/page_voice.hpp"
#include "agents/console/picture_store.hpp"
#include "agents/console/pulse.hpp"
#include "agents/console/reach_outline.hpp"
#include "agents/runtime/service.hpp"
#include "blackboard/time/latch.hpp"
#include "drivers/arm/arm_model.hpp"
#include "lisp/forms/camera_pose.hpp"

namespace pizarra::console {

// What is known of the cell from its file: nothing of it is on the board.
struct CellView {
  std::string name;
  std::map<std::string, arm::ArmModel> arms;         // by their agents' names
  std::optional<forms::CameraPose> camera;           // in the base frame
  bool head = false;                                 // a unit turns it from there, and tells by how much
  double cube_mm = 60;                               // the length of what is drawn as a cube
  std::map<std::string, ReachOutline> reaches = {};  // of these arms, at the height of a cube's middle
};

class Session {
 public:
  static constexpr std::size_t max_watches = 64;
  static constexpr std::size_t max_requests = 16;

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

  Session(Setup setup, UpgradedSocket socket);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  // One more connection of the page, for its images, while it takes one.
  bool takes_lane() const { return !leaving_ && images_->takes_lane(); }
  void add_lane(UpgradedSocket socket);
  // As if the page had gone.
  void leave();
  // It is told why, and has gone a second later at most.
  void dismiss(std::string_view why);

 private:
  struct Verb;
  using Number = std::int64_t;
  // A jog that the page holds on to. The page's word counts while it is younger than the deadline.
  struct Jog {
    Number number;  // of the request
    Datum robot;
    Duration deadline;
    bool released = false;
  };

  void hear(std::string_view message);
  bool hear_on_lane(const Datum& form);
  // False where it is refused.
  bool begin_request(Number number, Task<void> task);

  void follow(const Datum& form);
  void watch(const Datum& form);
  void unwatch(const Datum& form);
  void ask(const Datum& form);
  void then(const Datum& form);
  void picture(const Datum& form);
  void request(const Datum& form);
  void goal(const Datum& form);
  void stop(const Datum& form);
  void clear_stops(const Datum& form);
  void command(const Datum& form);
  void take_over(const Datum& form);
  void let_go(const Datum& form);
  void ask_for(const Datum& form);
  void ask_no_more(const Datum& form);
  void stamp(const Datum& form);
  void jog(const Datum& form);
  void hold_on(const Datum& form);
  void release(const Datum& form);
  void look(const Datum& form);
  void look_away(const Datum& form);
  void heard(const Datum& form);

  Task<void> open();
  Task<void> run_out();
  Task<void> close_board();
  Task<void> say_goodbye();
  Task<void> start_watch(Number number, Query query, bool when_declared);
  Task<void> send_changes(Number number, std::unique_ptr<Watch> watch);
  Task<void> ask_now(Number number, Query query);
  Task<void> ask_then(Number number, Query query);
  Task<void> show_kept(Number number, std::string stream, Time moment);
  Task<void> look_if_readable(std::string stream);
  void say_arms(const std::vector<Answer>& answers, const std::string& past);
  Task<void> follow_arms();
  Task<void> ask_agent(Number number, std::string agent, Datum operation);
  Task<Result<Datum>> answer_of(std::string agent, Datum operation);
  Task<void> keep_beating();
  Task<void> follow_hands();
  Task<void> jog_while_held(Number number, Datum robot, Datum direction, Duration deadline);
  Task<Result<Revision>> tell_hold(Datum robot);
  Task<void> renew_hold(Datum robot);
  Task<void> take_hold_back(Datum robot);
  Task<void> pursue(Number number, std::string text);
  Task<void> say_end_of_goal(Number number, Datum goal, std::string text);
  Task<bool> being_taught();
  Task<void> declare_wishes();
  Task<void> tell_stop(Number number, std::string reason);
  Task<void> change_board(Number number, Transaction transaction, Failure otherwise);

  Setup setup_;
  runtime::AgentContext context_;
  runtime::Service service_;
  runtime::Caller caller_;
  bool leaving_ = false;
  Executor::TimerId going_timer_ = 0;  // of a page that was dismissed
  Pulse pulse_;
  bool in_hand_ = false;  // an arm is
  WaitList hands_changed_;
  std::optional<Jog> jog_;
  Number newest_jog_ = 0;
  Number newest_stop_ = 0;
  std::int64_t holds_told_ = 0;
  std::unique_ptr<PageImages> images_;
  PageVoice voice_;
  std::unique_ptr<PageInstruments> instruments_;
  Job opening_;
  Job running_out_;
  Job arms_;
  Job beating_;
  Job hands_;
  Job holding_;     // the newest hold on its way to the board
  Job letting_go_;  // its end
  Job closing_;
  std::map<std::string, Job> looks_;
  std::map<Number, Job> watches_;
  std::map<Number, Job> requests_;
  std::vector<Job> stopping_;
};

}  // namespace pizarra::console
