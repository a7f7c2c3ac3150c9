#include "agents/vision/agent/known_objects.hpp"

#include <fmt/format.h>
#include <ranges>

#include "agents/vision/objects/look_alike.hpp"

namespace pizarra::vision {

KnownObjects::KnownObjects(runtime::AgentContext& context, std::string directory, ModeHolders& holders,
                           ClientPresence& presence, FactTeller& facts, RenameHandler on_renamed)
    : context_(context),
      holders_(holders),
      presence_(presence),
      facts_(facts),
      on_renamed_(std::move(on_renamed)),
      memory_(context, std::move(directory)) {}

Failure KnownObjects::not_known(const std::string& name) const {
  const Failure* trouble = memory_.trouble_with(name);
  if (trouble == nullptr) return {"not-learned", "nothing is learned under this name", to_datum(name), {}};
  if (trouble->symbol == "full") {
    return {"full",
            fmt::format("it is kept, but {} objects are known already: forget another, and this one is known",
                        most_objects),
            to_datum(name),
            {}};
  }
  return {
      "damaged",
      fmt::format("the object learned under this name is damaged, {}: {}", trouble->subject.text(), trouble->sentence),
      to_datum(name),
      {}};
}

Result<void> KnownObjects::check_untracked(const std::string& client, const std::string& name) const {
  const std::string holder = holders_.other_tracker(client, name);
  if (holder.empty()) return {};
  return fail("busy", fmt::format("{} tracks it: nobody else can change it meanwhile", holder), Datum::symbol(holder));
}

Task<Result<void>> KnownObjects::check_judged(std::string client, std::string name) {
  const std::vector<std::string> judges = to_accept_.other_judges(client, name, context_.executor.now());
  for (const std::string& judge : judges) {
    const Result<bool> present = co_await presence_.is_present(judge);
    if (!present.value_or(true)) continue;
    co_return fail("busy",
                   fmt::format("{} has learned a sample of it, and is still to accept or to reject that", judge),
                   Datum::symbol(judge));
  }
  co_return {};
}

Task<Result<void>> KnownObjects::check_unheld(std::string client, std::string name) {
  const Result<void> untracked = check_untracked(client, name);
  if (!untracked) co_return untracked;
  const Result<void> judged = co_await check_judged(std::move(client), std::move(name));
  co_return judged;
}

// In no database all ids are 0, and the newest is the agent's own.
std::optional<int> KnownObjects::number_of(const std::string& name, std::int64_t id) const {
  const LearnedObject* object = objects().find(name);
  if (object == nullptr) return std::nullopt;
  for (const LearnedSample& sample : object->samples | std::views::reverse) {
    if (sample.id == id) return sample.number;
  }
  return std::nullopt;
}

Task<Result<std::int64_t>> KnownObjects::change(ObjectChange change) {
  const SampleNames before = names_of_samples();
  const RenameObject* const renaming = std::get_if<RenameObject>(&change);
  Renames own;
  if (renaming != nullptr) own.emplace(renaming->name, renaming->new_name);
  const Result<std::int64_t> changed = co_await memory_.change(std::move(change));
  if (!changed) co_return changed;
  Renames renames = renamed_since(before);
  renames.merge(own);
  co_await follow_renames(std::move(renames));
  co_return changed;
}

Task<Result<void>> KnownObjects::keep(std::string client, std::string name, LearnedSample sample) {
  ObjectChange keep = KeepSample{name, std::move(sample)};
  const Result<std::int64_t> kept = co_await change(std::move(keep));
  if (!kept) co_return fail(kept);
  const std::optional<int> number = number_of(name, *kept);
  if (!number) co_return {};
  to_accept_.add({client, name, *number, *kept, context_.executor.now() + SamplesToAccept::lease});
  co_await tell();
  co_return {};
}

Task<Result<SampleToAccept>> KnownObjects::judged_by(std::string client, std::string name) {
  co_await follow_memory();
  const SampleToAccept* sample = to_accept_.find(client, name);
  if (sample != nullptr && sample->client == client) co_return *sample;
  const Result<void> judged = co_await check_judged(client, name);
  if (!judged) co_return fail(judged);
  sample = to_accept_.find(client, name);
  if (sample != nullptr) co_return *sample;
  co_return fail("nothing-to-accept", "no sample of this name was learned last, or it has been judged already",
                 to_datum(name));
}

Task<Result<Datum>> KnownObjects::accept(std::string client, std::string name) {
  const Result<SampleToAccept> sample = co_await judged_by(client, name);
  if (!sample) co_return fail(sample);
  to_accept_.remove(*sample);
  co_await tell();
  co_return Datum();
}

Task<Result<Datum>> KnownObjects::reject(std::string client, std::string name) {
  const Result<SampleToAccept> sample = co_await judged_by(client, name);
  if (!sample) co_return fail(sample);
  const Result<void> untracked = check_untracked(client, name);
  if (!untracked) co_return fail(untracked);
  ObjectChange withdraw = WithdrawSample{sample->name, sample->number, sample->id};
  const Result<std::int64_t> done = co_await change(std::move(withdraw));
  if (!done) co_return fail(done);
  co_return Datum();
}

Task<Result<Datum>> KnownObjects::forget(std::string client, std::string name) {
  const Result<void> unheld = co_await check_unheld(client, name);
  if (!unheld) co_return fail(unheld);
  ObjectChange forget = ForgetObject{name};
  const Result<std::int64_t> done = co_await change(std::move(forget));
  if (!done) co_return fail(done);
  co_return Datum();
}

Task<Result<Datum>> KnownObjects::rename(std::string client, std::string name, std::string new_name) {
  const Result<void> unheld = co_await check_unheld(client, name);
  if (!unheld) co_return fail(unheld);
  const LearnedObject* object = objects().find(name);
  if (object != nullptr) name = object->name;
  ObjectChange rename = RenameObject{name, new_name};
  const Result<std::int64_t> done = co_await change(std::move(rename));
  if (!done) co_return fail(done);
  co_return Datum();
}

Task<Result<Datum>> KnownObjects::limit(std::string client, std::string name,
                                        std::function<void(SearchLimit&)> change) {
  co_await follow_memory();
  const LearnedObject* object = objects().find(name);
  if (object == nullptr) co_return fail(not_known(name));
  const Result<void> untracked = check_untracked(client, object->name);
  if (!untracked) co_return fail(untracked);
  SearchLimit limit = limits_.of(object->name);
  change(limit);
  limits_.set(object->name, limit);
  co_await tell();
  co_return Datum();
}

Task<Result<void>> KnownObjects::know(TaggedObject object) {
  if (objects().find(object.name) != nullptr) co_return {};
  Result<LearnedSample> sample = learn_print(object, objects());
  if (!sample) co_return fail(sample);
  ObjectChange keep = KeepSample{object.name, std::move(*sample)};
  const Result<std::int64_t> kept = co_await change(std::move(keep));
  if (!kept) co_return fail(kept);
  co_return {};
}

Task<Result<Datum>> KnownObjects::learn_from(std::string other) {
  co_await follow_memory();
  const Result<LearnedObjects> theirs = co_await memory_.known_to(other);
  if (!theirs) co_return fail(theirs);
  std::vector<Datum> learned;
  for (const LearnedObject& object : theirs->all()) {
    if (objects().find(object.name) != nullptr) continue;
    for (const LearnedSample& sample : object.samples) {
      ObjectChange keep = KeepSample{object.name, sample};
      const Result<std::int64_t> kept = co_await change(std::move(keep));
      if (!kept) co_return fail(kept);
    }
    learned.push_back(Datum::string(object.name));
  }
  co_await tell();
  co_return Datum::list(std::move(learned));
}

Task<void> KnownObjects::follow_memory() {
  const SampleNames before = names_of_samples();
  const Result<bool> changed = co_await memory_.recall_changed();
  const bool anew = changed && *changed;
  if (!anew) co_return;
  Renames renames = renamed_since(before);
  co_await follow_renames(std::move(renames));
}

KnownObjects::SampleNames KnownObjects::names_of_samples() const {
  SampleNames out;
  for (const LearnedObject& object : objects().all()) {
    for (const LearnedSample& sample : object.samples) {
      if (sample.id != 0) out.emplace(sample.id, object.name);
    }
  }
  return out;
}

Renames KnownObjects::renamed_since(const SampleNames& before) const {
  Renames out;
  for (const auto& [id, name] : names_of_samples()) {
    const auto was = before.find(id);
    if (was != before.end() && was->second != name) out.emplace(was->second, name);
  }
  return out;
}

Task<void> KnownObjects::follow_renames(Renames renames) {
  on_renamed_(renames);
  holders_.rename(renames);
  to_accept_.follow(renames, objects());
  limits_.follow(renames, objects());
  co_await facts_.follow_found(std::move(renames), objects());
  co_await tell();
}

Task<void> KnownObjects::tell() {
  std::vector<Datum> known = look_alikes(objects());
  for (Datum& fact : to_accept_.facts()) known.push_back(std::move(fact));
  for (Datum& fact : limits_.facts()) known.push_back(std::move(fact));
  for (const auto& [object, why] : memory_.troubles()) {
    known.push_back(list("objects-damaged"_sym, why.subject, Datum::symbol(why.symbol), why.sentence));
  }
  co_await facts_.tell(std::move(known));
}

}  // namespace pizarra::vision
