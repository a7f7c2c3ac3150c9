#include "agents/vision/database/object_memory.hpp"

#include <algorithm>

#include "agents/vision/database/told_by.hpp"
#include "agents/vision/objects/sample_facts.hpp"

namespace pizarra::vision {
namespace {

// How often, and after which pauses, a database that another agent is writing is tried.
constexpr int tries = 20;
constexpr Duration busy_pause = 50ms;

bool is_busy(const Failure& failure) { return failure.symbol == "busy"; }

Transaction all_told_by(std::string_view agent, Transaction transaction) {
  for (Transaction::Step& step : transaction.steps) {
    if (auto* tell = std::get_if<Transaction::Tell>(&step)) tell->fact = told_by(agent, tell->fact);
    if (auto* retract = std::get_if<Transaction::Retract>(&step)) retract->pattern = told_by(agent, retract->pattern);
  }
  return transaction;
}

// Of the same sample as this fact.
Result<LearnedSample> sample_of(const Fact& learned, const std::vector<Fact>& facts) {
  std::vector<Datum> of_sample;
  for (const Fact& fact : facts) {
    const bool is_same = fact.datum[2] == learned.datum[2] && fact.datum[3] == learned.datum[3];
    if (is_same) of_sample.push_back(as_said(fact.datum));
  }
  return sample_from_facts(of_sample);
}

}  // namespace

ObjectMemory::ObjectMemory(runtime::AgentContext& context, std::string directory)
    : context_(context), directory_(std::move(directory)) {}

Result<void> ObjectMemory::open() {
  if (database_ && database_->in_place()) return {};
  database_.reset();
  Result<ObjectDatabase> opened = was_open_ ? ObjectDatabase::open_again(directory_) : ObjectDatabase::open(directory_);
  if (!opened) return fail(opened);
  database_.emplace(std::move(*opened));
  was_open_ = true;
  return {};
}

Result<KeptObjects> ObjectMemory::read() {
  const Result<void> opened = open();
  if (!opened) return fail(opened);
  const Result<std::int64_t> version = database_->version();
  if (!version) return fail(version);
  Result<KeptObjects> kept = database_->read();
  if (kept) version_ = *version;
  return kept;
}

Result<std::int64_t> ObjectMemory::apply(const ObjectChange& change) {
  const Result<void> opened = open();
  if (!opened) return fail(opened);
  return database_->apply(change);
}

Task<Result<void>> ObjectMemory::recall() {
  if (directory_.empty()) co_return co_await recall_facts();
  Result<KeptObjects> kept = read();
  for (int n = 1; n < tries; ++n) {
    if (kept || !is_busy(kept.error())) break;
    co_await sleep(context_.executor, busy_pause);
    kept = read();
  }
  const Result<void> recalled = co_await take_up(std::move(kept));
  co_return recalled;
}

Task<Result<void>> ObjectMemory::take_up(Result<KeptObjects> kept) {
  if (kept) {
    objects_ = std::move(kept->objects);
    troubles_ = std::move(kept->damaged);
    const Result<void> told = co_await tell_objects();
    co_return told;
  }
  Failure why = kept.error();
  why.subject = to_datum("objects.sqlite");
  // Whatever is wrong with the file, it is looked at anew the next time.
  database_.reset();
  const Result<void> recalled = co_await recall_facts();
  troubles_.push_back({std::string(), std::move(why)});
  co_return recalled;
}

Task<Result<bool>> ObjectMemory::recall_changed() {
  if (directory_.empty()) co_return false;
  const bool in_place = database_ && database_->in_place();
  const Result<std::int64_t> version = in_place ? database_->version() : Result<std::int64_t>(version_ - 1);
  if (version && *version == version_ && database_->bitmaps_in_place()) co_return false;
  Result<KeptObjects> kept = read();
  // Whatever another agent is writing has not happened yet.
  if (!kept && is_busy(kept.error())) co_return false;
  const Result<void> recalled = co_await take_up(std::move(kept));
  if (!recalled) co_return fail(recalled);
  co_return true;
}

Task<Result<std::int64_t>> ObjectMemory::change(ObjectChange change) {
  if (!directory_.empty()) {
    Result<std::int64_t> applied = apply(change);
    for (int n = 1; n < tries; ++n) {
      if (applied || !is_busy(applied.error())) break;
      co_await sleep(context_.executor, busy_pause);
      applied = apply(change);
    }
    if (!applied) co_return applied;
    const Result<void> recalled = co_await recall();
    if (!recalled) co_return fail(recalled);
    co_return applied;
  }
  Result<Transaction> facts = facts_of(change, objects_);
  if (!facts) co_return fail(facts);
  Transaction ours = all_told_by(context_.name, std::move(*facts));
  const Result<Revision> told = if_it_stands(co_await context_.board.transact(std::move(ours)));
  if (!told) co_return fail(told);
  const Result<void> recalled = co_await recall_facts();
  if (!recalled) co_return fail(recalled);
  co_return std::int64_t{0};
}

const Failure* ObjectMemory::trouble_with(std::string_view object) const {
  const auto found =
      std::ranges::find_if(troubles_, [&](const MemoryTrouble& trouble) { return same_name(trouble.object, object); });
  return found == troubles_.end() ? nullptr : &found->why;
}

// Takes up the facts that an earlier life of the agent left on the board.
Task<Result<void>> ObjectMemory::recall_facts() {
  Result<Recalled> recalled = co_await read_facts(context_.name);
  if (!recalled) co_return fail(recalled);
  objects_ = std::move(recalled->objects);
  troubles_ = std::move(recalled->troubles);
  co_return Result<void>();
}

Task<Result<LearnedObjects>> ObjectMemory::known_to(std::string agent) {
  Result<Recalled> recalled = co_await read_facts(std::move(agent));
  if (!recalled) co_return fail(recalled);
  co_return std::move(recalled->objects);
}

Task<Result<std::vector<Fact>>> ObjectMemory::sample_facts(std::string agent) {
  std::vector<Fact> out;
  for (const SampleRelation& relation : sample_relations) {
    const Datum pattern = any_told_by(agent, Datum::symbol(relation.name), relation.arguments);
    Result<std::vector<Fact>> facts = co_await context_.board.facts(pattern);
    if (!facts) co_return fail(facts);
    std::ranges::move(*facts, std::back_inserter(out));
  }
  co_return out;
}

Task<Result<ObjectMemory::Recalled>> ObjectMemory::read_facts(std::string agent) {
  const Result<std::vector<Fact>> facts = co_await sample_facts(std::move(agent));
  if (!facts) co_return fail(facts);
  Recalled recalled;
  for (const Fact& fact : *facts) {
    if (!fact.datum.is_form(sample_relations[0].name)) continue;
    Result<LearnedSample> sample = sample_of(fact, *facts);
    const Result<LearnedObjects::Slot> slot = recalled.objects.slot_for(fact.datum[2].text());
    if (sample && slot) {
      recalled.objects.add(slot->name, std::move(*sample));
    } else {
      Failure why = sample ? slot.error() : sample.error();
      why.subject = fact.datum[2];
      recalled.troubles.push_back({std::string(fact.datum[2].text()), std::move(why)});
    }
  }
  co_return recalled;
}

// The facts become what the database says.
Task<Result<void>> ObjectMemory::tell_objects() {
  std::vector<Datum> wanted = facts_of(objects_);
  for (Datum& fact : wanted) fact = told_by(context_.name, fact);
  const Result<std::vector<Fact>> standing = co_await sample_facts(context_.name);
  if (!standing) co_return fail(standing);
  Transaction transaction;
  for (const Fact& fact : *standing) {
    if (std::ranges::find(wanted, fact.datum) == wanted.end()) transaction.retract(fact.datum);
  }
  for (const Datum& fact : wanted) transaction.tell(fact);
  const Result<Revision> told = if_it_stands(co_await context_.board.transact(std::move(transaction)));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

}  // namespace pizarra::vision
