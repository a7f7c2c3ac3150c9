#include "agents/coordinator/perceive/eyes.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/forms/vision_reply.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration reply_timeout = 10s;
constexpr Duration look_patience = 2s;
constexpr Duration busy_pause = 300ms;
constexpr Duration tracking_shows = 500ms;
// Eyes that restart while they are asked forget what they had been asked before.
constexpr int tries_to_track = 3;

}  // namespace

Task<Result<Datum>> Eyes::ask(Datum operation) {
  const Time deadline = context_.executor.now() + options_.absence_patience;
  while (true) {
    const bool here = co_await roles_.wait_for("eyes", deadline);
    if (!here) {
      co_return fail("absent", "the vision agent stays away", Datum::symbol(roles_.holder("eyes").server));
    }
    const Result<Datum> reply = co_await caller_.call(roles_.player("eyes"), operation, reply_timeout);
    if (reply) co_return reply;
    const std::string& why = reply.error().symbol;
    const bool again = why == "busy" || why == "timeout" || why == "replaced";
    if (!again || context_.executor.now() > deadline) co_return reply;
    co_await sleep(context_.executor, busy_pause);
  }
}

Task<Result<Datum>> Eyes::answer_to(Datum operation) {
  const Result<Datum> reply = co_await ask(std::move(operation));
  if (!reply) co_return reply;
  if (reply->size() < 1) co_return fail("bad-reply", "vision answered without a text", *reply);
  co_return forms::interpret_vision_reply((*reply)[0].text());
}

Task<Result<std::vector<std::string>>> Eyes::objects() {
  const Datum operation = list("get-objects"_sym);
  const Result<Datum> known = co_await answer_to(operation);
  if (!known) co_return fail(known);
  std::vector<std::string> names;
  for (const Datum& name : known->items().subspan(1)) {
    if (name.text() != options_.gripper.mark) names.emplace_back(name.text());
  }
  known_ = names;
  co_return names;
}

bool Eyes::knows(const std::string& name) const { return known_ && std::ranges::find(*known_, name) != known_->end(); }

Task<Result<bool>> Eyes::find(std::string name) {
  const Datum operation = list("find"_sym, name);
  const Result<Datum> found = co_await answer_to(operation);
  if (!found) co_return fail(found);
  co_return found->size() > 2 && (*found)[2].is_symbol("ok");
}

Task<Result<void>> Eyes::track() {
  std::uint64_t last = surroundings_.looks();
  for (int i = 0; i < tries_to_track; ++i) {
    const Time soon = context_.executor.now() + tracking_shows;
    const bool looking = co_await surroundings_.look_after(last, soon);
    if (looking && tracks_all()) break;
    const Result<void> tracking = co_await begin_tracking();
    if (!tracking) co_return tracking;
    // The next look may be under way already.
    last = surroundings_.looks() + 1;
  }
  co_return Result<void>();
}

bool Eyes::tracks_all() const {
  const std::set<std::string>& tracked = surroundings_.tracked();
  const auto is_tracked = [&](const std::string& name) { return tracked.contains(name); };
  return known_ && is_tracked(options_.gripper.mark) && std::ranges::all_of(*known_, is_tracked);
}

Task<Result<void>> Eyes::take_over(std::string before) {
  // Before the first goal nothing is tracked.
  if (!known_) co_return Result<void>();
  const std::vector<std::string> wanted = *known_;
  const Result<std::vector<std::string>> theirs = co_await objects();
  if (!theirs) co_return fail(theirs);
  const bool lacks = std::ranges::any_of(
      wanted, [&](const std::string& name) { return std::ranges::find(*theirs, name) == theirs->end(); });
  if (lacks) {
    const Datum same = list("learn-from"_sym, Datum::symbol(before));
    const Result<Datum> learned = co_await ask(same);
    if (!learned) co_return fail(learned);
  }
  known_ = wanted;
  const Result<void> tracking = co_await begin_tracking();
  co_return tracking;
}

Task<Result<void>> Eyes::begin_tracking() {
  const Datum connect = list("connect"_sym);
  const Result<Datum> connected = co_await ask(connect);
  if (!connected) co_return fail(connected);
  if (!known_) {
    const Result<std::vector<std::string>> asked = co_await objects();
    if (!asked) co_return fail(asked);
  }
  std::vector<std::string> names = *known_;
  names.insert(names.begin(), options_.gripper.mark);
  for (const std::string& name : names) {
    const Datum operation = list("track"_sym, name);
    const Result<Datum> tracked = co_await ask(operation);
    if (!tracked) co_return fail(tracked);
  }
  co_return Result<void>();
}

Task<Result<void>> Eyes::await_look(Wait wait) {
  const Time deadline = context_.executor.now() + options_.absence_patience;
  const std::uint64_t before = surroundings_.looks();
  while (true) {
    const Time soon = context_.executor.now() + look_patience;
    const bool looked = co_await (surroundings_.*wait)(before, soon);
    if (looked) co_return Result<void>();
    if (context_.executor.now() > deadline) {
      const Failure why = nothing_shown();
      co_return fail(why);
    }
    const Result<void> again = co_await look_again();
    if (!again) co_return again;
  }
}

// While nobody knows how the head stands, no object can be placed, however well the eyes work.
Failure Eyes::nothing_shown() const {
  const bool head_known = surroundings_.scene().head().has_value();
  if (head_known) return {"absent", "vision shows nothing any more", Datum::symbol(roles_.holder("eyes").server), {}};
  return {"absent", "nobody knows where the head looks any more", Datum::symbol(roles_.holder("head").server), {}};
}

Task<Result<void>> Eyes::look_again() {
  if (!surroundings_.scene().head()) {
    const Datum head = Datum::symbol(roles_.holder("head").server);
    co_await story_.tell("agent", "nobody knows where the head looks: waiting until it stands", head);
    co_return Result<void>();
  }
  const std::string eyes = roles_.holder("eyes").server;
  const std::string sentence = fmt::format("no looks come from {}: asking it to track again", eyes);
  const Datum subject = Datum::symbol(eyes);
  co_await story_.tell("agent", sentence, subject);
  co_return co_await track();
}

}  // namespace pizarra::coordinator
