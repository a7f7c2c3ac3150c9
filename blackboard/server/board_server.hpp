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
// session are remembered (answered.hpp), and with a journal those about durable facts also in its next life, where the
// session goes on when its client greets. A client has 4 MB under way, half of which is for replies alone. Changes that
// a slow client has not read wait in its watches' queues (served_watches.hpp), in 4 MB that these share; a watch whose
// change has no room there is resynchronised.

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "blackboard/journal/past.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/server/costly_turns.hpp"
#include "blackboard/server/durability.hpp"
#include "blackboard/server/key_folder.hpp"
#include "blackboard/server/refusals.hpp"
#include "blackboard/server/sessions.hpp"
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
  std::vector<journal::RememberedReply> remembered = {};
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
  void ask_for_keys();
  Result<void> listen(const std::vector<std::string>& addresses, bool insecure);
  void restore(const std::vector<journal::RememberedReply>& remembered);
  void receive(const std::string& peer, std::optional<std::string_view> frame);
  void hear(const std::string& peer, const Datum& message);
  void refuse(const std::string& peer, const Failure& failure);
  void refuse_unreadable(const std::string& peer, std::string_view frame, const Failure& failure);
  void refuse_request(const Session& session, wire::RequestId number, const Failure& failure);
  void refuse_undone(Session& session, wire::RequestId number, const Datum& body, const Failure& failure);
  std::string who_is(const std::string& peer) const;
  void greet(const std::string& peer, const Datum& hello);
  Result<void> check_hello(const std::string& peer, const std::string& teller, const wire::PublicKey* key) const;
  void end_session(wire::SessionId id);
  void end_sessions_of_changed_keys();
  void handle(wire::SessionId id, Session& session, const Datum& message);
  bool must_wait(const Session& session, const Datum& message) const;
  void postpone(wire::SessionId id, Session& session, const Datum& message);
  void hear(wire::SessionId id, Session& session, const Postponed::Message& waiting);
  bool is_to_be_done(wire::SessionId id, Session& session, const Datum& message);
  bool was_answered(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body);
  void serve(wire::SessionId id, Session& session, wire::RequestId number, const Postponed::Message& waiting);
  std::optional<Result<Datum>> perform_in_turn(wire::SessionId id, Session& session, const Postponed::Message& waiting);
  void wait_for_turn(wire::SessionId id, const Session& session);
  Result<Datum> perform(wire::SessionId id, Session& session, const Datum& body, std::size_t& examined);
  void ask_past(wire::SessionId id, const Session& session, wire::RequestId number, const Datum& body);
  Result<Datum> watch(wire::SessionId id, Session& session, const Datum& body, std::size_t& examined);
  void note_journey(const Datum& body, Time sent);
  bool answer(wire::SessionId id, Session& session, wire::RequestId number, const Postponed::Message& waiting);
  std::string recall_in_doubt(const std::string& sender_key, const Datum& request, Duration age);
  void owe(const std::string& peer, const std::string& reply);
  void deliver();
  std::string with_progress(const Session& session, std::string reply) const;
  void send(const std::string& peer, const Datum& message);
  void schedule_flush(wire::SessionId id);
  void flush_all();
  void flush(wire::SessionId id);
  bool send_changes(wire::SessionId id, Session& session);
  void schedule_look();
  void look_on();
  bool awaits_index(const Session& session) const;
  void make_on();
  void go_on(wire::SessionId id);
  void forget_the_gone();

  Executor& executor_;
  memory::MemoryBoard& board_;
  const Duration session_length_;
  std::vector<std::string> addresses_;
  std::optional<KeyFolder> keys_;
  CostlyTurns turns_;
  Refusals refusals_;
  Sessions sessions_;
  const wire::SessionId life_;  // another one in every life of the server
  Durability durability_;
  PermittedBoard permitted_;
  std::optional<journal::Past> past_;
  std::set<std::pair<wire::SessionId, wire::RequestId>> past_asked_;
  std::set<wire::SessionId> to_flush_;
  std::size_t examined_ = 0;      // since others were served
  std::size_t for_requests_ = 0;  // facts looked at, in all
  std::size_t before_frame_ = 0;  // of these, before the frame that is being heard
  bool leaving_ = false;
  bool receiving_ = false;  // what is to be flushed is, when this is done
  // Replies to transactions of the frame that is being received: they go together, after what these changed.
  std::string owed_;
  std::string owed_to_;
  int owed_replies_ = 0;
  Executor::TimerId flush_timer_ = 0;
  Executor::TimerId look_timer_ = 0;
  Executor::TimerId sweep_timer_ = 0;
  std::unique_ptr<wire::FrameSocket> socket_;
  memory::MemoryBoard::Hearing hearing_;
};

}  // namespace pizarra::server
