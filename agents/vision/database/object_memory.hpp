#pragma once

// The objects that the vision agent knows. They are kept in its durable facts (sample_facts.hpp). Where a folder is
// given they are kept in an object database, and the facts are a copy of it for others to read.
//
//   ObjectMemory memory(context, "objects");            // or "": the board alone
//   Result<void> recalled = co_await memory.recall();
//   Result<std::int64_t> done = co_await memory.change(ForgetObject{"circle"});
//   const LearnedObject* circle = memory.objects().find("circle");
//
// A database that cannot be used, and damaged samples in it, are only troubles(). Sound samples are used. Where nothing
// can be read, the facts on the board are.

#include "agents/runtime/agent.hpp"
#include "agents/vision/database/object_database.hpp"

namespace pizarra::vision {

class ObjectMemory {
 public:
  // `directory`: of the database, made where there is none; empty: no database.
  ObjectMemory(runtime::AgentContext& context, std::string directory);

  // The object stays in its place, what is in it is replaced by whatever changes it.
  const LearnedObjects& objects() const { return objects_; }
  // What is damaged, and where: the subject is a file's name.
  const std::vector<MemoryTrouble>& troubles() const { return troubles_; }

  // Reads everything anew. Failures: the board's.
  Task<Result<void>> recall();
  // The same where another agent has changed the database, a bitmap is another file than was read, or what kept the
  // database from being read is gone; whether it was read. While another agent is writing, nothing is
  // new: that is not waited for.
  Task<Result<bool>> recall_changed();
  // Failures: full, not-learned, name-taken, those of the database and of the board.
  // The id of the sample that was kept; 0 where none was to be, or in no database.
  Task<Result<std::int64_t>> change(ObjectChange change);
  // The objects of other eyes, read from their facts on the board. Failures: the board's.
  Task<Result<LearnedObjects>> known_to(std::string agent);
  // The trouble that keeps a sample of that name from being used; null where there is none.
  const Failure* trouble_with(std::string_view object) const;

 private:
  Result<void> open();
  Result<KeptObjects> read();
  Result<std::int64_t> apply(const ObjectChange& change);
  // Takes up the objects read, or, where that failed, the facts on the board.
  Task<Result<void>> take_up(Result<KeptObjects> kept);
  Task<Result<void>> recall_facts();
  struct Recalled {
    LearnedObjects objects;
    std::vector<MemoryTrouble> troubles;
  };
  // All facts of all samples.
  Task<Result<std::vector<Fact>>> sample_facts(std::string agent);
  Task<Result<Recalled>> read_facts(std::string agent);
  Task<Result<void>> tell_objects();

  runtime::AgentContext& context_;
  std::string directory_;
  std::optional<ObjectDatabase> database_;
  bool was_open_ = false;
  std::int64_t version_ = 0;  // of the database as it was read last
  LearnedObjects objects_;
  std::vector<MemoryTrouble> troubles_;
};

}  // namespace pizarra::vision
