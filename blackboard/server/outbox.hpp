#pragma once

// What a served board sends to its clients: the changes of their watches, then the replies. The replies to several
// transactions of one frame go together, after what these changed.
//
//   Outbox outbox(executor, board, sessions, workload, socket);
//   outbox.schedule(id);                  // its watches have changes: soon, or before the next reply
//   outbox.begin_frame();
//   outbox.owe(session.peer, reply);      // goes with others
//   outbox.end_frame();
//
// A frame that a peer does not take is lost to it: its client asks for the replies again, and its watches keep their
// changes.

#include <set>
#include <string>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/server/sessions.hpp"
#include "blackboard/server/workload.hpp"
#include "blackboard/wire/frame_socket.hpp"

namespace pizarra::server {

class Outbox {
 public:
  // All of them outlive it.
  Outbox(Executor& executor, memory::MemoryBoard& board, Sessions& sessions, Workload& workload,
         wire::FrameSocket& socket)
      : executor_(executor), board_(board), sessions_(sessions), workload_(workload), socket_(socket) {}
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;
  ~Outbox();

  void send(const std::string& peer, const std::string& text) { socket_.send(peer, text); }
  void send(const std::string& peer, const Datum& message);
  // To a client that answers questions from what it watches, how far that is goes along.
  void reply(const Session& session, const std::string& text);

  void begin_frame() { receiving_ = true; }
  void end_frame();
  // Whether a frame is being heard.
  bool is_receiving() const { return receiving_; }
  // To a transaction of the frame that is being heard.
  void owe(const std::string& peer, const std::string& reply);
  // The replies that are owed.
  void deliver();

  void schedule(wire::SessionId id);
  void flush(wire::SessionId id);
  void flush_all();

 private:
  bool send_changes(wire::SessionId id, Session& session);
  bool awaits_index(const Session& session) const;
  std::string with_progress(const Session& session, std::string reply) const;

  Executor& executor_;
  memory::MemoryBoard& board_;
  Sessions& sessions_;
  Workload& workload_;
  wire::FrameSocket& socket_;
  bool receiving_ = false;  // what is to be flushed is, when this is done
  std::set<wire::SessionId> to_flush_;
  Executor::TimerId flush_timer_ = 0;
  std::string owed_;
  std::string owed_to_;
  int owed_replies_ = 0;
};

}  // namespace pizarra::server
