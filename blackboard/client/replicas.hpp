#pragma once

// The relations that a client of a board holds itself, and answers questions about without asking the server.
//
// A question is answered from here when it is about one relation that is held whole, and when everything that this
// client was told is done has come here too: so it reads its own writes. The server says with every reply which
// revision it is at, and whether all changes up to there went to this client before the reply (wire.hpp); what is said
// in order arrives in order.
//
//   Replicas replicas(board);
//   Replica& replica = replicas.add(relation);
//   std::optional<Result<Answers>> held = replicas.ask(query);

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "blackboard/client/remote_changes.hpp"
#include "blackboard/store/fact_table.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::client {

class Replica;

class Replicas {
 public:
  Replicas(RemoteBoard& board, Executor& executor);
  ~Replicas();

  Replica* find(const std::string& relation) const;
  Replica& add(const Relation& relation);
  void remove(const std::string& relation);
  bool empty() const { return replicas_.empty(); }

  // Nothing where the server must be asked.
  std::optional<Result<Answers>> ask(const Query& query) const;
  // The server answered when it was at `revision`. `sent`: all changes up to there came here before the answer.
  void answered_at(Revision revision, bool sent);
  // It answered, and did not say at which revision.
  void answered() { unsure_ = true; }
  // The revisions that were known of the server are void.
  void begin_again();

 private:
  friend class Replica;
  const Replica* concerned(const Query& query) const;

  RemoteBoard& board_;
  Executor& executor_;
  store::Tables tables_;
  std::map<std::string, std::unique_ptr<Replica>, std::less<>> replicas_;
  Revision done_ = 0;       // all that this client was told is done was done by then
  Revision caught_up_ = 0;  // all changes up to here have come
  bool unsure_ = false;
};

// One relation.
class Replica : public RemoteChanges {
 public:
  Replica(Replicas& replicas, const Relation& relation);

  void end(Failure failure) override;
  bool whole() const { return whole_; }
  Revision revision() const { return revision_; }
  // Once it was whole, or never will be.
  Event& known() { return known_; }
  const std::optional<Failure>& ended() const { return ended_; }

 private:
  void come(std::uint64_t sequence, Delta delta) override;
  bool has_room() const override { return true; }
  bool has_ended() const override { return ended_.has_value(); }
  void begun_again() override { whole_ = false; }
  Result<void> take_in(Delta delta);

  Replicas& replicas_;
  const Relation relation_;
  bool whole_ = false;
  Revision revision_ = 0;
  std::optional<Failure> ended_;
  Event known_;
};

}  // namespace pizarra::client
