#pragma once

// The learned objects, as clients change them: who may, which samples are still to be accepted, what follows where a
// name has changed, and what the board is told of them. Another agent may share the database, so what is known is read
// anew before it matters.
//
//   KnownObjects known(context, "objects", holders, presence, facts, on_renamed);
//   Result<void> recalled = co_await known.recall();
//   Result<void> kept = co_await known.keep("person", "circle", sample);
//   Result<Datum> answer = co_await known.accept("person", "circle");

#include "agents/vision/agent/client_presence.hpp"
#include "agents/vision/agent/object_teller.hpp"
#include "agents/vision/agent/printed_tag.hpp"
#include "agents/vision/agent/samples_to_accept.hpp"
#include "agents/vision/database/object_memory.hpp"
#include "agents/vision/sight/search_limits.hpp"

namespace pizarra::vision {

class KnownObjects {
 public:
  // Whatever else goes by the names of objects follows.
  using RenameHandler = std::function<void(const Renames&)>;

  // All outlive it.
  KnownObjects(runtime::AgentContext& context, std::string directory, ModeHolders& holders, ClientPresence& presence,
               FactTeller& facts, RenameHandler on_renamed);

  // It stays in its place.
  const LearnedObjects& objects() const { return memory_.objects(); }
  // Where and how often they are looked for; it stays in its place too.
  const SearchLimits& limits() const { return limits_; }
  // Reads everything anew. Failures: the board's.
  Task<Result<void>> recall() { return memory_.recall(); }
  // The same where another agent has changed it: renamed what is tracked or to be accepted, or forgotten it.
  Task<void> follow_memory();
  // What is worth knowing of them: damage, those that look alike, those to be accepted, and limits.
  Task<void> tell();
  // Why there is no object of this name: it was never learned, or is damaged.
  Failure not_known(const std::string& name) const;

  // The sample is to be accepted by this client. Failures: those of ObjectMemory::change().
  Task<Result<void>> keep(std::string client, std::string name, LearnedSample sample);
  // The operations of clients. Failures: `busy`, where another client tracks the object or has a sample of it to
  // accept; `nothing-to-accept`; and those of ObjectMemory.
  Task<Result<Datum>> accept(std::string client, std::string name);
  Task<Result<Datum>> reject(std::string client, std::string name);
  Task<Result<Datum>> forget(std::string client, std::string name);
  Task<Result<Datum>> rename(std::string client, std::string name, std::string new_name);
  // Changes where and how often it is looked for. Failures: those of not_known(), and `busy` where another client
  // tracks it.
  Task<Result<Datum>> limit(std::string client, std::string name, std::function<void(SearchLimit&)> change);
  // Nobody is to accept it; nothing is done where something is known under its name. Failures: those of learn_print()
  // and of ObjectMemory.
  Task<Result<void>> know(TaggedObject object);
  // Takes over the objects of other eyes under names that are unused here. Answers these names.
  Task<Result<Datum>> learn_from(std::string other);

 private:
  // By their ids, which they keep. Of samples that are in no database nobody else changes the names.
  using SampleNames = std::map<std::int64_t, std::string>;
  SampleNames names_of_samples() const;
  Renames renamed_since(const SampleNames& before) const;
  Task<void> follow_renames(Renames renames);
  // Changes what is known, and has everything that goes by it follow: the id of the sample that was kept, or 0.
  Task<Result<std::int64_t>> change(ObjectChange change);
  // The number of the sample of that id.
  std::optional<int> number_of(const std::string& name, std::int64_t id) const;
  // The sample of that name that the client may accept or reject.
  Task<Result<SampleToAccept>> judged_by(std::string client, std::string name);
  Result<void> check_untracked(const std::string& client, const std::string& name) const;
  Task<Result<void>> check_judged(std::string client, std::string name);
  Task<Result<void>> check_unheld(std::string client, std::string name);

  runtime::AgentContext& context_;
  ModeHolders& holders_;
  ClientPresence& presence_;
  ObjectTeller facts_;
  RenameHandler on_renamed_;
  ObjectMemory memory_;
  SamplesToAccept to_accept_;
  SearchLimits limits_;
};

}  // namespace pizarra::vision
