#pragma once

// The watches of one client: what was sent of each and acknowledged, and what waits until there is room for it.
//
//   ServedWatches watches;
//   watches.add(number, asked, kept, std::move(queue));      // made with watches.backlog()
//   watches.send(socket, peer, examined);                    // what waits, as far as its connection takes it
//   watches.acknowledge(number, sequence);
//   watches.begin_again();                                   // on a new connection
//
// A watch has `most_under_way` changes under way at most. One whose change could not be sent is resynchronised.

#include <map>
#include <memory>
#include <string>

#include "blackboard/watch/watch_queue.hpp"
#include "blackboard/wire/frame_socket.hpp"
#include "blackboard/wire/wire.hpp"

namespace pizarra::server {

class ServedWatches {
 public:
  static constexpr std::size_t most = 256;
  static constexpr std::size_t most_under_way = 16;  // changes of a watch

  // The query of this number; null where no such watch stands.
  const Datum* asked(wire::WatchId number) const;
  std::size_t size() const { return watches_.size(); }
  // `kept` by the client, which is told the ids of what goes.
  void add(wire::WatchId number, Datum asked, bool kept, std::unique_ptr<watch::WatchQueue> queue);
  void end(wire::WatchId number) { watches_.erase(number); }
  // Of a watch that stands; whether it was not acknowledged before. Failure bad-frame: that was never sent.
  Result<bool> acknowledge(wire::WatchId number, std::uint64_t sequence);
  // Whether facts of the relation are in its answers.
  bool is_about(wire::WatchId number, std::string_view relation) const;
  // Its queues share it.
  const std::shared_ptr<watch::Backlog>& backlog() const { return backlog_; }
  // Whether anything waits.
  bool are_behind() const;

  // Looks for what holds until `examined` is limits::examined_a_turn, or an index is to be awaited (indexing.hpp), and
  // answers whether there is more to be looked for.
  bool send(wire::FrameSocket& socket, const std::string& peer, std::size_t& examined);
  // The client was heard from: answers whether its connection took no more before.
  bool unblock() { return std::exchange(blocked_, false); }
  // The changes under way may be lost.
  void begin_again();

 private:
  struct Served {
    Datum asked;
    bool kept;
    std::unique_ptr<watch::WatchQueue> queue;
    std::uint64_t sent = 0;
    std::uint64_t acknowledged = 0;
  };
  bool send(wire::FrameSocket& socket, const std::string& peer, wire::WatchId number, Served& watch,
            std::size_t& examined);

  std::shared_ptr<watch::Backlog> backlog_ = std::make_shared<watch::Backlog>();
  std::map<wire::WatchId, Served> watches_;
  bool blocked_ = false;
};

}  // namespace pizarra::server
