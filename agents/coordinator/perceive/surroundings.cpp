#include "agents/coordinator/perceive/surroundings.hpp"

#include <fmt/format.h>

#include "agents/runtime/follow.hpp"

namespace pizarra::coordinator {

namespace {

// A look that came longer ago is not taken for one that is to come: the eyes may have fallen silent.
constexpr Duration new_look = 200ms;

// Of the objects of a look, each told as ("NAME" STATE ...).
std::set<std::string> names_in(const Datum& objects) {
  std::set<std::string> names;
  for (const Datum& object : objects.items()) {
    if (object.size() > 0) names.emplace(object[0].text());
  }
  return names;
}

// When the eyes captured the frame, where they say so.
std::optional<Time> captured_in(const Datum& objects) {
  for (const Datum& object : objects.items()) {
    for (const Datum& part : object.items()) {
      const bool says = part.is_form("captured") && part.size() == 2 && part[1].is_integer();
      if (says) return Time(Duration(part[1].integer()));
    }
  }
  return std::nullopt;
}

}  // namespace

Surroundings::Surroundings(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
                           const runtime::Service& service, Story& story)
    : context_(context),
      domain_(domain),
      story_(story),
      scene_(options, domain),
      devices_(context, options, scene_),
      beliefs_(options.belief_looks),
      belief_teller_(context, options, domain, service, beliefs_),
      camera_pose_news_(context, options.camera.pose, story),
      looked_(context.executor) {}

Task<void> Surroundings::resume() {
  const std::optional<CameraMeasured> measured = co_await camera_pose_news_.told_before();
  if (measured) scene_.take_camera_pose(*measured);
}

void Surroundings::start() {
  devices_.start();
  belief_teller_.start();
}

void Surroundings::follow_eyes(const std::string& agent) {
  eyes_ = Job();
  capture_clock_ = CaptureClock();
  devices_.follow_camera(agent);
  const Datum looks = list("look"_sym, Datum::symbol(agent), "?"_sym, "?"_sym, "?"_sym);
  const auto handler = [this](Change change) { return take_look(std::move(change)); };
  eyes_ = context_.executor.spawn(runtime::follow(context_, looks, handler));
}

Task<void> Surroundings::take_look(Change change) {
  // A fact that stands already when the watch begins may be old.
  if (change.resynchronised || change.added.empty() || !scene_.places_next_look()) co_return;
  const Fact look = change.added.back().facts.front();
  const std::int64_t frame = look.datum[2].integer();
  tracked_ = names_in(look.datum[4]);
  const std::optional<Time> captured = captured_in(look.datum[4]);
  came_at_ = context_.executor.now();
  captured_.reset();
  if (captured) captured_ = capture_clock_.on_board(*captured, look.when);
  const std::vector<Datum> believed(beliefs().begin(), beliefs().end());
  const Result<forms::PerceivedLook> perceived =
      forms::perceive_look(domain_.perception(), look.datum[3].text(), look.datum[4], scene_.situation(), believed);
  if (!perceived) {
    co_await tell_failure(perceived.error());
    co_return;
  }
  const CameraWatch::News news = scene_.take_look(frame, *perceived, captured_at_rest());
  Beliefs::Change changed;
  // Without a place nothing is believed of what is seen.
  const bool placed = !scene_.camera().unknown();
  if (placed && perceived->facts) {
    Facts facts;
    for (const Datum& fact : *perceived->facts) {
      if (domain_.domain().find_predicate(fact.head())) facts.insert(fact);
    }
    changed = beliefs_.perceive(facts, {frame, look.id});
  }
  // Waiters act on the look before the board has what follows from it.
  looked_.wake_all();
  if (placed) co_await belief_teller_.tell(scene_.sightings(), std::move(changed), look.id);
  if (!perceived->facts) co_await tell_failure(perceived->facts.error());
  co_await camera_pose_news_.tell(scene_.camera(), news);
}

// Every look may fail in the same way; it is told once.
Task<void> Surroundings::tell_failure(Failure why) {
  if (told_failure_ == why.sentence) co_return;
  told_failure_ = why.sentence;
  const std::string sentence = fmt::format("the look cannot be understood, what was believed stays: {}", why.sentence);
  const Datum detail = failure_to_datum(why);
  co_await story_.tell("agent", sentence, detail);
}

Task<bool> Surroundings::look_after(std::uint64_t look, Time deadline) {
  while (looks() <= look) {
    const bool woken = co_await looked_.wait(deadline);
    if (!woken) co_return looks() > look;
  }
  co_return true;
}

bool Surroundings::captured_at_rest() const {
  const std::optional<Time>& rests_since = devices_.rests_since();
  return captured_ && rests_since && *captured_ > *rests_since;
}

bool Surroundings::shows_rest() const { return captured_at_rest() && context_.executor.now() - came_at_ < new_look; }

Task<bool> Surroundings::look_at_rest_after(std::uint64_t look, Time deadline) {
  const bool looked = co_await look_after(look, deadline);
  if (!looked) co_return false;
  const bool shows_rest = captured_at_rest();
  if (shows_rest) co_return true;
  co_return co_await second_look_after(look, deadline);
}

}  // namespace pizarra::coordinator
