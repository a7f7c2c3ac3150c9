// What is learned: who changes it, and what follows where it has changed.

#include <fmt/format.h>
#include <ranges>

#include "agents/vision/agent/vision_state.hpp"

namespace pizarra::vision {

Failure VisionAgent::State::not_known(const std::string& name) const {
  const Failure* trouble = memory.trouble_with(name);
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

// In no database all ids are 0, and the newest is the agent's own.
std::optional<int> VisionAgent::State::number_of(const std::string& name, std::int64_t id) const {
  const LearnedObject* object = objects.find(name);
  if (object == nullptr) return std::nullopt;
  for (const LearnedSample& sample : object->samples | std::views::reverse) {
    if (sample.id == id) return sample.number;
  }
  return std::nullopt;
}

Task<Result<std::int64_t>> VisionAgent::State::change_objects(ObjectChange change) {
  const SampleNames before = names_of_samples();
  const RenameObject* const renaming = std::get_if<RenameObject>(&change);
  Renames own;
  if (renaming != nullptr) own.emplace(renaming->name, renaming->new_name);
  const Result<std::int64_t> changed = co_await memory.change(std::move(change));
  if (!changed) co_return changed;
  Renames renames = renamed_since(before);
  renames.merge(own);
  co_await follow_renames(std::move(renames));
  co_return changed;
}

Task<Result<SampleToAccept>> VisionAgent::State::judged_by(std::string client, std::string name) {
  co_await follow_memory();
  const SampleToAccept* sample = to_accept.find(client, name);
  if (sample != nullptr && sample->client == client) co_return *sample;
  const Result<void> judged = co_await check_judged(client, name);
  if (!judged) co_return fail(judged);
  sample = to_accept.find(client, name);
  if (sample != nullptr) co_return *sample;
  co_return fail("nothing-to-accept", "no sample of this name was learned last, or it has been judged already",
                 to_datum(name));
}

Task<Result<Datum>> VisionAgent::State::accept(Asked asked) {
  const Result<SampleToAccept> sample = co_await judged_by(asked.client, asked.name);
  if (!sample) co_return fail(sample);
  to_accept.remove(*sample);
  co_await tell_objects();
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::reject(Asked asked) {
  const Result<SampleToAccept> sample = co_await judged_by(asked.client, asked.name);
  if (!sample) co_return fail(sample);
  const Result<void> untracked = check_untracked(asked.client, asked.name);
  if (!untracked) co_return fail(untracked);
  ObjectChange withdraw = WithdrawSample{sample->name, sample->number, sample->id};
  const Result<std::int64_t> done = co_await change_objects(std::move(withdraw));
  if (!done) co_return fail(done);
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::forget(Asked asked) {
  const Result<void> unheld = co_await check_unheld(asked.client, asked.name);
  if (!unheld) co_return fail(unheld);
  ObjectChange forget = ForgetObject{asked.name};
  const Result<std::int64_t> done = co_await change_objects(std::move(forget));
  if (!done) co_return fail(done);
  co_return Datum();
}

Task<Result<Datum>> VisionAgent::State::rename(Asked asked) {
  const auto& [client, operation, new_name, came] = asked;
  std::string name(operation[1].text());
  const Result<void> unheld = co_await check_unheld(client, name);
  if (!unheld) co_return fail(unheld);
  const LearnedObject* object = objects.find(name);
  if (object != nullptr) name = object->name;
  ObjectChange rename = RenameObject{name, new_name};
  const Result<std::int64_t> done = co_await change_objects(std::move(rename));
  if (!done) co_return fail(done);
  co_return Datum();
}

// Takes over the objects of other eyes under names that are unused here. Answers these names.
Task<Result<Datum>> VisionAgent::State::learn_from(Asked asked) {
  co_await follow_memory();
  const Result<LearnedObjects> theirs = co_await memory.known_to(asked.name);
  if (!theirs) co_return fail(theirs);
  std::vector<Datum> learned;
  for (const LearnedObject& object : theirs->all()) {
    if (objects.find(object.name) != nullptr) continue;
    for (const LearnedSample& sample : object.samples) {
      ObjectChange keep = KeepSample{object.name, sample};
      const Result<std::int64_t> kept = co_await change_objects(std::move(keep));
      if (!kept) co_return fail(kept);
    }
    learned.push_back(Datum::string(object.name));
  }
  co_await tell_objects();
  co_return Datum::list(std::move(learned));
}

Task<void> VisionAgent::State::follow_memory() {
  const SampleNames before = names_of_samples();
  const Result<bool> changed = co_await memory.recall_changed();
  const bool anew = changed && *changed;
  if (!anew) co_return;
  Renames renames = renamed_since(before);
  co_await follow_renames(std::move(renames));
}

VisionAgent::State::SampleNames VisionAgent::State::names_of_samples() const {
  SampleNames out;
  for (const LearnedObject& object : objects.all()) {
    for (const LearnedSample& sample : object.samples) {
      if (sample.id != 0) out.emplace(sample.id, object.name);
    }
  }
  return out;
}

Renames VisionAgent::State::renamed_since(const SampleNames& before) const {
  Renames out;
  for (const auto& [id, name] : names_of_samples()) {
    const auto was = before.find(id);
    if (was != before.end() && was->second != name) out.emplace(was->second, name);
  }
  return out;
}

Task<void> VisionAgent::State::follow_renames(Renames renames) {
  finder.rename(renames);
  tracker.rename(renames);
  holders.rename(renames);
  to_accept.follow(renames, objects);
  co_await facts.follow_found(std::move(renames), objects);
  co_await tell_objects();
}

}  // namespace pizarra::vision
