#pragma once

// The board for other processes: serves a MemoryBoard over a Transport, ZeroMQ as a rule (see wire.hpp for what is
// said).
//
//   Result<std::unique_ptr<BoardServer>> server = BoardServer::open(executor, board, {.addresses =
//   {"ipc:///tmp/cell"}});
//   (*server)->addresses();      // where it is reached, wildcard ports filled in
//
// The board outlives it.
// A client is a session: made by its hello, forgotten with its watches ten seconds after it was last heard from. Its
// number cannot be guessed and counts on the connection that said hello alone, until the same teller says hello with it
// on another. A connection has one session. With a folder of keys, every tcp address asks for one: a session is then
// its key's, its teller called by the key's name, and what it asks for held against the key's permissions; a key that
// changes or goes ends its sessions within session_length / 8. What is refused is told (refusals.hpp). A request that
// changes the board is done once however often it is sent, and a refused one stays refused: the last replies of a
// session are remembered (replies.hpp), and with a journal those about durable facts also in its next life, where the
// session goes on when its client greets. A client has 4 MB under way, half of which is for replies alone. Changes that
// a slow client has not read wait in its watches' queues (served_watches.hpp), in 4 MB that these share; a watch whose
// change has no room there is resynchronised.

#include <memory>
#include <string>
#include <vector>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/server/admission.hpp"
#include "blackboard/server/outbox.hpp"
#include "blackboard/server/refusals.hpp"
#include "blackboard/server/requests.hpp"
#include "blackboard/server/sessions.hpp"
#include "blackboard/server/workload.hpp"
#include "blackboard/wire/frame_socket.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::server {

struct BoardServerOptions {
  std::vector<std::string> addresses;
  // The folder of the keys that may come, the board's own among them (key_folder.hpp); empty: none are asked for.
  std::string keys = {};
  // Without keys, allows addresses that other machines reach.
  bool insecure = false;
  Duration session_length = 10s;
  memory::ClientRequests::Limit requests = {};  // of a client, while others ask
  // The board's: what concerns durable facts is answered when it is written there.
  journal::JournalWriter* journal = nullptr;
  // From where questions about the past are answered; null: from the journal.
  journal::JournalWriter* past = nullptr;
  std::vector<journal::RememberedReply> remembered = {};  // oldest first
  // Whether every answer waits until the journal has what came before it: where another board may take over that knows
  // of nothing else.
  bool answers_from_journal = false;
  // The transport of the frames, and the source of the sessions' numbers. Both outlive the server.
  wire::Transport* transport = &wire::zeromq();
  std::function<std::uint64_t()> random_number = Sessions::random_number;
};

class BoardServer {
 public:
  // Failures bad-address, not-loopback, address-in-use, and those of KeyFolder::open.
  static Result<std::unique_ptr<BoardServer>> open(Executor& executor, memory::MemoryBoard& board,
                                                   const BoardServerOptions& options);
  BoardServer(const BoardServer&) = delete;
  BoardServer& operator=(const BoardServer&) = delete;
  ~BoardServer();

  const std::vector<std::string>& addresses() const { return addresses_; }
  std::size_t sessions() const { return sessions_.size(); }
  // Tells every client that the server ends, and hears nobody any more. A connection that breaks takes along what its
  // client has not read, so that a server should live on for `goodbye_length`.
  void say_goodbye();
  static constexpr Duration goodbye_length = 50ms;
  // The answer to a frame of a board that last knew `age` ago that it leads; empty for clients that did not ask for it.
  std::string answer_in_doubt(const std::string& sender_key, std::string_view frame, Duration age);

 private:
  BoardServer(Executor& executor, memory::MemoryBoard& board, const BoardServerOptions& options,
              std::optional<KeyFolder> keys);
  Result<void> listen(const std::vector<std::string>& addresses, bool insecure);
  void receive(const std::string& peer, std::optional<std::string_view> frame);
  void refuse_unreadable(const std::string& peer, std::string_view frame, const Failure& failure);
  void hear(const std::string& peer, const Datum& message);
  void handle(wire::SessionId id, Session& session, const Datum& message);
  bool is_to_be_done(wire::SessionId id, Session& session, const Datum& request);
  bool must_wait(const Session& session, const Datum& message) const;
  void postpone(wire::SessionId id, Session& session, const Datum& message);
  void perform(wire::SessionId id, Session& session, const Postponed::Message& waiting);
  void attend_to_watch(wire::SessionId id, Session& session, const Datum& message);
  void serve_turn();
  void make_indexes();
  void go_on(wire::SessionId id);
  void sweep();

  Executor& executor_;
  memory::MemoryBoard& board_;
  const Duration session_length_;
  std::vector<std::string> addresses_;
  Refusals refusals_;
  Sessions sessions_;
  Workload workload_;
  std::unique_ptr<wire::FrameSocket> socket_;
  Outbox outbox_;
  Requests requests_;
  Admission admission_;
  bool leaving_ = false;
  Executor::TimerId sweep_timer_ = 0;
  memory::MemoryBoard::Hearing hearing_;
};

}  // namespace pizarra::server
