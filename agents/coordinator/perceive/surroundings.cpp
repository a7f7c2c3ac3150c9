#include "agents/coordinator/perceive/surroundings.hpp"

#include <fmt/format.h>

#include "agents/runtime/follow.hpp"

namespace pizarra::coordinator {

namespace {

// (RELATION FIRST ? ...), of as many arguments.
Datum pattern_of(Datum relation, Datum first, std::size_t arguments) {
  std::vector<Datum> items(arguments + 1, "?"_sym);
  items[0] = std::move(relation);
  items[1] = std::move(first);
  return Datum::list(std::move(items));
}

// Of the objects of a look, each told as (NAME STATE ...).
std::set<std::string> names_in(const Datum& objects) {
  std::set<std::string> names;
  for (const Datum& object : objects.items()) names.emplace(object.head());
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
      options_(options),
      domain_(domain),
      story_(story),
      scene_(options, domain),
      beliefs_(options.belief_looks),
      belief_teller_(context, options, domain, service, beliefs_),
      camera_pose_news_(context, options.camera.pose, story),
      looked_(context.executor) {}

Job Surroundings::followed(Datum pattern, Take take) {
  const auto handler = [this, take](Change change) { return (this->*take)(std::move(change)); };
  return context_.executor.spawn(runtime::follow(context_, std::move(pattern), handler));
}

Task<void> Surroundings::resume() {
  const std::optional<forms::CameraPose> measured = co_await camera_pose_news_.told_before();
  if (measured) scene_.take_camera_pose(*measured);
}

void Surroundings::start() {
  if (options_.head) head_ = followed(pattern_of("head"_sym, "?"_sym, 3), &Surroundings::take_head);
  belief_teller_.start();
}

// Other eyes may have another camera.
void Surroundings::follow_eyes(const std::string& agent) {
  const Datum eyes = Datum::symbol(agent);
  eyes_.clear();
  scene_.forget_camera();
  capture_clock_ = CaptureClock();
  eyes_.push_back(followed(pattern_of("camera-model"_sym, eyes, 7), &Surroundings::take_model));
  eyes_.push_back(followed(pattern_of("look"_sym, eyes, 4), &Surroundings::take_look));
}

void Surroundings::follow_robot(const std::string& agent) {
  const Datum robot = Datum::symbol(agent);
  robot_.clear();
  robot_.push_back(followed(pattern_of("gripper"_sym, robot, 2), &Surroundings::take_gripper));
  robot_.push_back(followed(pattern_of("arm-pose"_sym, robot, 7), &Surroundings::take_pose));
  robot_.push_back(followed(pattern_of("arm-foot"_sym, robot, 3), &Surroundings::take_foot));
  robot_.push_back(followed(pattern_of("arm"_sym, robot, 3), &Surroundings::take_arm));
}

Task<void> Surroundings::take_model(Change change) {
  if (change.added.empty()) co_return;
  const Result<CameraModel> model = camera_model_from_fact(change.added.back().facts.front().datum);
  if (model) scene_.take_camera(*model);
}

Task<void> Surroundings::take_head(Change change) {
  std::optional<HeadTurn> turn;
  if (!change.added.empty()) {
    const Datum& head = change.added.back().facts.front().datum;
    if (head[3].is_symbol("still")) turn = HeadTurn{head[1].number(), head[2].number()};
  }
  scene_.take_head(turn);
  co_return;
}

Task<void> Surroundings::take_gripper(Change change) {
  if (!change.added.empty()) scene_.take_opening(change.added.back().facts.front().datum[2].number());
  co_return;
}

Task<void> Surroundings::take_pose(Change change) {
  if (change.added.empty()) co_return;
  const Datum& pose = change.added.back().facts.front().datum;
  const Eigen::Vector3d at(pose[2].number(), pose[3].number(), pose[4].number());
  scene_.take_pose(tool_pose(at, pose[5].number(), pose[6].number(), pose[7].number()));
}

Task<void> Surroundings::take_foot(Change change) {
  if (change.added.empty()) co_return;
  const Datum& foot = change.added.back().facts.front().datum;
  scene_.take_foot({foot[2].number(), foot[3].number(), 0});
}

Task<void> Surroundings::take_arm(Change change) {
  rests_since_.reset();
  bool moving = false;
  if (!change.added.empty()) {
    const Fact& arm = change.added.back().facts.front();
    moving = arm.datum[2].is_symbol("moving");
    if (!moving) rests_since_ = arm.when;
  }
  scene_.take_arm(moving);
  co_return;
}

Task<void> Surroundings::take_look(Change change) {
  // A fact that stands already when the watch begins may be old.
  if (change.resynchronised || change.added.empty() || !scene_.places_next_look()) co_return;
  const Fact look = change.added.back().facts.front();
  const std::int64_t frame = look.datum[2].integer();
  tracked_ = names_in(look.datum[4]);
  const std::optional<Time> captured = captured_in(look.datum[4]);
  captured_.reset();
  if (captured) captured_ = capture_clock_.on_board(*captured, look.when);
  const std::vector<Datum> believed(beliefs().begin(), beliefs().end());
  const Result<forms::PerceivedLook> perceived =
      forms::perceive_look(domain_.perception(), look.datum[3].text(), look.datum[4], scene_.situation(), believed);
  if (!perceived) {
    co_await tell_failure(perceived.error());
    co_return;
  }
  const CameraWatch::News news = scene_.take_look(frame, *perceived);
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

Task<bool> Surroundings::look_at_rest_after(std::uint64_t look, Time deadline) {
  const bool looked = co_await look_after(look, deadline);
  if (!looked) co_return false;
  const bool is_known = captured_ && rests_since_;
  if (is_known && *captured_ > *rests_since_) co_return true;
  co_return co_await second_look_after(look, deadline);
}

}  // namespace pizarra::coordinator
