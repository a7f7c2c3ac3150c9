#include "agents/vision/database/object_change.hpp"

#include "agents/vision/objects/sample_facts.hpp"

namespace pizarra::vision {
namespace {

// The learned object a change is about.
Result<const LearnedObject*> known(const LearnedObjects& objects, const std::string& name) {
  const LearnedObject* object = objects.find(name);
  if (object == nullptr) return fail("not-learned", "nothing is learned under this name", to_datum(name));
  return object;
}

void tell_sample(Transaction& transaction, const std::string& name, const LearnedSample& sample) {
  for (Datum& fact : facts_of_sample(name, sample)) transaction.tell(std::move(fact));
}

void retract_samples(Transaction& transaction, const std::string& name, std::optional<int> number = {}) {
  for (Datum& pattern : patterns_of(name, number)) transaction.retract(std::move(pattern));
}

struct AsFacts {
  const LearnedObjects& objects;

  Result<Transaction> operator()(const KeepSample& keep) const {
    const Result<LearnedObjects::Slot> slot = objects.slot_for(keep.name);
    if (!slot) return fail(slot);
    LearnedSample sample = keep.sample;
    sample.number = slot->number;
    Transaction out;
    tell_sample(out, slot->name, sample);
    return out;
  }
  Result<Transaction> operator()(const WithdrawSample& withdraw) const {
    const Result<const LearnedObject*> object = known(objects, withdraw.name);
    if (!object) return fail(object);
    Transaction out;
    retract_samples(out, (*object)->name, withdraw.number);
    return out;
  }
  Result<Transaction> operator()(const ForgetObject& forget) const {
    const Result<const LearnedObject*> object = known(objects, forget.name);
    if (!object) return fail(object);
    Transaction out;
    retract_samples(out, (*object)->name);
    return out;
  }
  Result<Transaction> operator()(const RenameObject& rename) const {
    const Result<const LearnedObject*> object = known(objects, rename.name);
    if (!object) return fail(object);
    const LearnedObject* other = objects.find(rename.new_name);
    if (other != nullptr && other != *object) return name_taken(rename.new_name);
    Transaction out;
    retract_samples(out, (*object)->name);
    for (const LearnedSample& sample : (*object)->samples) tell_sample(out, rename.new_name, sample);
    return out;
  }
};

}  // namespace

std::unexpected<Failure> name_taken(const std::string& name) {
  return fail("name-taken", "another object is learned under this name", to_datum(name));
}

Result<Transaction> facts_of(const ObjectChange& change, const LearnedObjects& objects) {
  return std::visit(AsFacts{objects}, change);
}

std::vector<Datum> facts_of(const LearnedObjects& objects) {
  std::vector<Datum> out;
  for (const LearnedObject& object : objects.all()) {
    for (const LearnedSample& sample : object.samples) {
      for (Datum& fact : facts_of_sample(object.name, sample)) out.push_back(std::move(fact));
    }
  }
  return out;
}

std::vector<Datum> patterns_of(const std::string& name, std::optional<int> number) {
  std::vector<Datum> out;
  for (const SampleRelation& relation : sample_relations) {
    std::vector<Datum> items(relation.arguments + 1, "?"_sym);
    items[0] = Datum::symbol(relation.name);
    items[1] = to_datum(name);
    if (number) items[2] = to_datum(*number);
    out.push_back(Datum::list(std::move(items)));
  }
  return out;
}

}  // namespace pizarra::vision
