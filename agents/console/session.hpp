#pragma once

// One page: its WebSocket and its own session with the board, under a name of its own. What the page may do is what
// that name may; the page's code decides nothing.
//
// The page says forms, one a message:
//   (follow N QUERY)            what holds of the query and every change, also of relations that are yet to come
//   (watch N "QUERY")           the same of what a person typed: refused where it cannot be read or is not known
//   (unwatch N)
//   (request N AGENT OPERATION) asks an agent, as any client does
//   (goal N "TEXT")             accepted, and then how it ended: two answers, the
//                               second the state it ended in, or its refusal
//   (stop N "REASON")           a stop fact; needs nothing but the right to tell it
//   (clear-stops N)             takes every stop back; who does so has an arm in hand
//   (command N ROBOT), (take-over N ROBOT), (let-go N ROBOT)     the arm in one operator's hands: (commander ROBOT US)
//   (look STREAM), (look-away STREAM), (drawn STREAM)            images; each that was drawn makes room for the next
//   (heard N)                   it has taken in N more messages of facts, changes and arms; what it has not is bounded
// and is told, as JSON (change_text.hpp): {"hello":...}, {"watch":N,...}, {"reply":N,...}, {"arm":NAME,...}; images as
// binary: a line `(image STREAM NUMBER AGE-US WIDTH HEIGHT)`, and the JPEG behind it.
//
// What is bounded: 64 watches, 16 requests in hand, 4 streams with two images under way each. A page that does not take
// in what it is told, some 256 kB of it, has its watches wait: the board resynchronises them.

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/console/image_feed.hpp"
#include "agents/console/web_socket.hpp"
#include "agents/runtime/service.hpp"
#include "blackboard/time/latch.hpp"
#include "drivers/arm/arm_model.hpp"
#include "lisp/forms/camera_pose.hpp"

namespace pizarra::console {

// What is known of the cell from its file: nothing of it is on the board.
struct CellView {
  std::string name;
  std::map<std::string, arm::ArmModel> arms;  // by their agents' names
  std::optional<forms::CameraPose> camera;    // in the base frame
  double cube_mm = 60;                        // the length of what is drawn as a cube
};

class Session {
 public:
  static constexpr std::size_t max_watches = 64;
  static constexpr std::size_t max_requests = 16;
  static constexpr std::size_t max_looks = 4;
  static constexpr int max_images_under_way = 2;
  // What it is asked or shows at once comes behind this much at most, also of what the system holds for the page.
  static constexpr std::size_t max_unheard_bytes = 256 << 10;

  struct Setup {
    Executor& executor;
    ImageFeeds& images;
    const CellView& cell;
    std::string name;  // on the board
    std::unique_ptr<Board> board;
    Time until;                   // the page is let go then
    std::function<void()> ended;  // it has left the board; this may be destroyed
  };

  Session(Setup setup, UpgradedSocket socket);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  // As if the page had gone.
  void leave();

 private:
  struct Verb;
  // What is under way of one stream.
  struct Stream {
    std::shared_ptr<const ImageFeeds::Picture> newest;  // not sent yet
    int under_way = 0;
    std::unique_ptr<ImageFeeds::Look> look;
  };
  using Number = std::int64_t;

  void hear(std::string_view message);
  void say(std::string text);
  void refuse(Number number, std::string symbol, std::string sentence);
  void begin_request(Number number, Task<void> task);

  void follow(const Datum& form);
  void watch(const Datum& form);
  void unwatch(const Datum& form);
  void request(const Datum& form);
  void goal(const Datum& form);
  void stop(const Datum& form);
  void clear_stops(const Datum& form);
  void command(const Datum& form);
  void take_over(const Datum& form);
  void let_go(const Datum& form);
  void look(const Datum& form);
  void look_away(const Datum& form);
  void drawn(const Datum& form);
  void heard(const Datum& form);
  void say_fact(std::string text);
  void show_newest(const std::string& name, Stream& stream);

  Task<void> open();
  Task<void> run_out();
  Task<void> close_board();
  Task<void> say_goodbye();
  Task<void> start_watch(Number number, Query query, bool when_declared);
  Task<void> send_changes(Number number, std::unique_ptr<Watch> watch);
  Task<void> room();
  Task<void> follow_arms();
  Task<void> ask_agent(Number number, std::string agent, Datum operation);
  Task<void> pursue(Number number, std::string text);
  Task<void> say_end_of_goal(Number number, Datum goal, std::string text);
  Task<bool> being_taught();
  Task<void> tell_stop(Number number, std::string reason);
  Task<void> change_board(Number number, Transaction transaction, Failure otherwise);

  Setup setup_;
  runtime::AgentContext context_;
  runtime::Service service_;
  runtime::Caller caller_;
  Event room_;
  std::deque<std::size_t> unheard_;  // messages of facts, by their bytes
  std::size_t unheard_bytes_ = 0;
  bool leaving_ = false;
  std::map<std::string, std::unique_ptr<Stream>> streams_;
  std::unique_ptr<WebSocket> socket_;
  Job opening_;
  Job running_out_;
  Job arms_;
  Job closing_;
  std::map<Number, Job> watches_;
  std::map<Number, Job> requests_;
  std::vector<Job> stopping_;
};

}  // namespace pizarra::console
