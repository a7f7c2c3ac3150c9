#include "agents/vision/agent/known_bodies.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/vision/database/told_by.hpp"

namespace pizarra::vision {

Task<Result<void>> KnownBodies::recall() {
  const Result<std::vector<Fact>> standing = co_await context_.board.facts(any_told_by(context_.name, "body"_sym, 2));
  if (!standing) co_return fail(standing);
  Transaction transaction;
  for (const Fact& fact : *standing) {
    // Anyone may have told such a fact.
    Result<Body> body = body_from(fact.datum[3], std::string(fact.datum[2].text()));
    const bool is_known = body && find(body->name) != nullptr;
    if (is_known) continue;
    const bool stays = body && fits(*body);
    if (stays) bodies_.push_back(std::move(*body));
    if (!stays) transaction.retract(fact.datum);
  }
  if (transaction.steps.empty()) co_return Result<void>();
  const Result<Revision> told = co_await context_.board.transact(std::move(transaction));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

Task<Result<void>> KnownBodies::learn_from(std::string other) {
  const Result<std::vector<Fact>> theirs = co_await context_.board.facts(any_told_by(other, "body"_sym, 2));
  if (!theirs) co_return fail(theirs);
  for (const Fact& fact : *theirs) {
    const std::string name(fact.datum[2].text());
    const Result<Body> body = body_from(fact.datum[3], name);
    const bool is_new = body && find(name) == nullptr && check(*body);
    if (!is_new) continue;
    const Result<Datum> defined = co_await define(fact.datum[3], name);
    if (!defined) co_return fail(defined);
  }
  co_return Result<void>();
}

const Body* KnownBodies::find(std::string_view name) const {
  const auto found = std::ranges::find_if(bodies_, [&](const Body& body) { return same_name(body.name, name); });
  return found == bodies_.end() ? nullptr : &*found;
}

const Body* KnownBodies::with_mark(std::string_view mark) const {
  const auto found = std::ranges::find_if(bodies_, [&](const Body& body) { return body.mark(mark) != nullptr; });
  return found == bodies_.end() ? nullptr : &*found;
}

std::vector<std::string> KnownBodies::names() const {
  std::vector<std::string> out;
  for (const LearnedObject& object : objects_.all()) {
    if (with_mark(object.name) == nullptr) out.push_back(object.name);
  }
  for (const Body& body : bodies_) out.push_back(body.name);
  return out;
}

std::set<std::string> KnownBodies::marks_of(const std::set<std::string>& asked) const {
  std::set<std::string> out;
  for (const std::string& name : asked) {
    const Body* body = find(name);
    if (body == nullptr) out.insert(name);
    if (body != nullptr) std::ranges::transform(body->marks, std::inserter(out, out.end()), &MarkOnBody::name);
  }
  return out;
}

Result<void> KnownBodies::check_name(const std::string& name) const {
  if (find(name) == nullptr) return {};
  return fail("name-taken", "a body has this name", to_datum(name));
}

Result<void> KnownBodies::check_no_mark(const std::string& object) const {
  const Body* body = with_mark(object);
  if (body == nullptr) return {};
  return fail("taken", fmt::format("it is a mark of {}", body->name), to_datum(object));
}

Result<void> KnownBodies::check_marks(const Body& body) const {
  for (const MarkOnBody& mark : body.marks) {
    const Body* other = with_mark(mark.name);
    const bool is_taken = other != nullptr && !same_name(other->name, body.name);
    if (is_taken) return fail("taken", fmt::format("{} has this mark", other->name), to_datum(mark.name));
  }
  return {};
}

bool KnownBodies::fits(const Body& body) const {
  return objects_.find(body.name) == nullptr && check_marks(body) && bodies_.size() < most_bodies;
}

Result<void> KnownBodies::check_untracked(const std::string& name) const {
  const std::string tracker = holders_.other_tracker("", name);
  if (tracker.empty()) return {};
  return fail("busy", fmt::format("{} tracks it", tracker), Datum::symbol(tracker));
}

Result<void> KnownBodies::check(const Body& body) const {
  if (objects_.find(body.name) != nullptr) return fail("name-taken", "an object has this name", to_datum(body.name));
  for (const MarkOnBody& mark : body.marks) {
    const LearnedObject* object = objects_.find(mark.name);
    const Datum subject = to_datum(mark.name);
    if (object == nullptr) return fail("not-learned", "nothing is learned under this name", subject);
    if (object->tag() == nullptr) {
      return fail("other-kind", "it is a shape: only a tag says how the body is turned", subject);
    }
  }
  const Result<void> free = check_marks(body);
  if (!free) return free;
  const Result<void> untracked = check_untracked(body.name);
  if (!untracked) return untracked;
  if (find(body.name) != nullptr || bodies_.size() < most_bodies) return {};
  return fail("full", fmt::format("no more than {} bodies are known", most_bodies), to_datum(body.name));
}

Task<Result<Datum>> KnownBodies::define(Datum marks, std::string name) {
  Result<Body> body = body_from(marks, name);
  if (!body) co_return fail(body);
  const Result<void> possible = check(*body);
  if (!possible) co_return fail(possible);
  const Body* before = find(name);
  if (before != nullptr) body->name = before->name;
  Transaction transaction;
  transaction.tell(told_by(context_.name, list("body"_sym, body->name, marks)));
  const Result<Revision> told = co_await context_.board.transact(std::move(transaction));
  if (!told) co_return fail(told);
  std::erase_if(bodies_, [&](const Body& each) { return each.name == body->name; });
  bodies_.push_back(std::move(*body));
  co_return Datum();
}

Task<Result<Datum>> KnownBodies::forget(std::string name) {
  const Body* body = find(name);
  if (body == nullptr) co_return fail("not-defined", "no body has this name", to_datum(name));
  name = body->name;
  const Result<void> untracked = check_untracked(name);
  if (!untracked) co_return fail(untracked);
  Transaction transaction;
  transaction.retract(told_by(context_.name, list("body"_sym, name, "?"_sym)));
  const Result<Revision> told = co_await context_.board.transact(std::move(transaction));
  if (!told) co_return fail(told);
  std::erase_if(bodies_, [&](const Body& each) { return each.name == name; });
  fronts_.erase(name);
  co_return Datum();
}

std::vector<TrackSighting> KnownBodies::told(std::vector<TrackSighting> marks) {
  if (bodies_.empty()) return marks;
  const std::set<std::string> asked = holders_.tracked();
  std::vector<TrackSighting> out;
  std::set<std::string> bodies_told;
  for (const TrackSighting& mark : marks) {
    if (asked.contains(mark.name)) out.push_back(mark);
    const Body* body = with_mark(mark.name);
    const bool is_next = body != nullptr && asked.contains(body->name) && bodies_told.insert(body->name).second;
    if (is_next) out.push_back(body_sighting(*body, marks, fronts_[body->name]));
  }
  return out;
}

std::map<std::string, cv::Rect> KnownBodies::areas_of_unseen(std::span<const TrackSighting> marks, Time captured,
                                                             double focal_px) const {
  std::map<std::string, cv::Rect> out;
  for (const Body& body : bodies_) out.merge(vision::areas_of_unseen(body, marks, captured, focal_px));
  return out;
}

}  // namespace pizarra::vision
