#pragma once

// What the vision agent knows of objects, and where that is kept: in its durable facts `learned`, `learned-template`
// and `learned-focal` alone, or, where a folder is given, in an object database, of which the facts are then the
// picture that others read.
//
//   ObjectMemory memory(context, "objects");            // or "": the board alone
//   Result<void> recalled = co_await memory.recall();
//   Result<std::int64_t> done = co_await memory.change(ForgetObject{"circle"});
//   const LearnedObject* circle = memory.objects().find("circle");
//
// A database that cannot be used, or samples of it that are damaged, are troubles() and nothing worse: what is sound is
// used, and where nothing can be read, what the board remembers is.

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
  // What other eyes know, by what stands on the board of it. Failures: the board's.
  Task<Result<LearnedObjects>> known_to(std::string agent);
  // What keeps a sample of that name from being used; null: nothing does.
  const Failure* trouble_with(std::string_view object) const;

 private:
  Result<void> open();
  Result<KeptObjects> read();
  Result<std::int64_t> apply(const ObjectChange& change);
  // What was read, or, where that failed, what the board remembers.
  Task<Result<void>> take_up(Result<KeptObjects> kept);
  Task<Result<void>> recall_facts();
  struct Recalled {
    LearnedObjects objects;
    std::vector<MemoryTrouble> troubles;
  };
  Task<Result<Recalled>> read_facts(std::string agent);
  Task<Result<void>> tell_objects();

  runtime::AgentContext& context_;
  std::string directory_;
  const Datum samples_;    // the pattern of the agent's facts `learned`
  const Datum templates_;  // and `learned-template`
  const Datum focals_;     // and `learned-focal`
  std::optional<ObjectDatabase> database_;
  bool was_open_ = false;
  std::int64_t version_ = 0;  // of the database as it was read last
  LearnedObjects objects_;
  std::vector<MemoryTrouble> troubles_;
};

}  // namespace pizarra::vision
