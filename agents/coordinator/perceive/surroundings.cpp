#include "agents/coordinator/perceive/surroundings.hpp"

#include <cmath>

#include "agents/coordinator/retried_commit.hpp"
#include "agents/runtime/declared.hpp"
#include "lisp/forms/vision_reply.hpp"

namespace pizarra::coordinator {

namespace {

// For how many looks an object must lie where it is to count as still.
constexpr std::uint64_t still_looks = 5;
// From the picture to the reply at most so many frames pass: so many looks after the head has come to rest may be
// older.
constexpr int looks_on_their_way = 3;
// What is nearer to where a held object's mark stands goes with the arm.
constexpr double held_mm = 40;

}  // namespace

Surroundings::Surroundings(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
                           const runtime::Service& service, Story& story)
    : context_(context),
      options_(options),
      domain_(domain),
      service_(service),
      story_(story),
      grace_(static_cast<std::uint64_t>(options.grace_looks)),
      beliefs_(options.belief_looks),
      changed_(context.executor) {}

void Surroundings::start() {
  Executor& executor = context_.executor;
  const Datum any = "?"_sym;
  const Datum robot = Datum::symbol(options_.robot);
  const Datum eyes = Datum::symbol(options_.vision);
  const Datum model = list("camera-model"_sym, eyes, any, any, any, any, any, any);
  jobs_.push_back(executor.spawn(watch(model, &Surroundings::take_model)));
  if (options_.head) {
    jobs_.push_back(executor.spawn(watch(list("head"_sym, any, any, any), &Surroundings::take_head)));
  } else {
    head_ = HeadTurn();
  }
  jobs_.push_back(executor.spawn(watch(list("gripper"_sym, robot, any), &Surroundings::take_gripper)));
  jobs_.push_back(executor.spawn(watch(list("faces"_sym, eyes, any, any), &Surroundings::take_faces)));
  const Datum pose = list("arm-pose"_sym, robot, any, any, any, any, any, any);
  jobs_.push_back(executor.spawn(watch(pose, &Surroundings::take_pose)));
  jobs_.push_back(executor.spawn(watch(list("agent"_sym, any, any, any), &Surroundings::take_presence)));
  jobs_.push_back(executor.spawn(watch_vision()));
  jobs_.push_back(executor.spawn(keep_told(list("believed"_sym, any))));
  for (const forms::Predicate& predicate : domain_.domain().predicates) {
    std::vector<Datum> pattern{Datum::symbol(predicate.name)};
    pattern.resize(1 + predicate.arguments.size(), any);
    jobs_.push_back(executor.spawn(keep_told(Datum::list(std::move(pattern)))));
  }
}

// Relations are declared by the agents that tell them, so a watch may have to wait for its relation.
Task<void> Surroundings::watch(Datum pattern, Handler handler) {
  const Query query = query_from_datum(pattern).value();
  while (true) {
    Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(context_.board, query);
    while (watch) {
      const Result<Change> change = co_await (*watch)->next();
      if (!change) break;
      (this->*handler)(*change);
      changed_.wake_all();
    }
    co_await sleep(context_.executor, retry_pause);
  }
}

Task<void> Surroundings::watch_vision() {
  const Datum says = list("vision-says"_sym, Datum::symbol(options_.vision), "?frame"_sym, "?text"_sym);
  const Query query = query_from_datum(says).value();
  while (true) {
    Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(context_.board, query);
    while (watch) {
      const Result<Change> change = co_await (*watch)->next();
      if (!change) break;
      // What stands there already when the watch begins may be old.
      if (change->resynchronised || change->added.empty()) continue;
      const Datum newest = change->added.back().facts.front().datum;
      std::string text(newest[3].text());
      co_await take_look(newest[2].integer(), std::move(text));
    }
    co_await sleep(context_.executor, retry_pause);
  }
}

void Surroundings::take_model(const Change& change) {
  if (change.added.empty()) return;
  const Result<CameraModel> model = camera_model_from_fact(change.added.back().facts.front().datum);
  if (!model) return;
  model_ = *model;
  turn_view();
}

// What is seen while the head turns cannot be placed.
void Surroundings::take_head(const Change& change) {
  head_.reset();
  if (change.added.empty()) return;
  const Datum& head = change.added.back().facts.front().datum;
  if (!head[3].is_symbol("still")) return;
  head_ = HeadTurn{head[1].number(), head[2].number()};
  blurred_looks_ = looks_on_their_way;
  turn_view();
}

void Surroundings::turn_view() {
  if (model_ && head_) view_.emplace(options_.camera, *model_, *head_);
}

void Surroundings::take_gripper(const Change& change) {
  if (!change.added.empty()) opening_mm_ = change.added.back().facts.front().datum[2].number();
}

void Surroundings::take_faces(const Change& change) {
  if (change.added.empty()) return;
  if (!head_ || blurred_looks_ > 0) return;
  for (const Datum& face : change.added.back().facts.front().datum[3].items()) {
    // Told as the camera is turned, kept as it is mounted.
    if (face.size() == 2) sightings_.face(face[0].text(), face[1].number() - head_->pan_deg);
  }
}

void Surroundings::take_pose(const Change& change) {
  if (change.added.empty()) return;
  const Datum& pose = change.added.back().facts.front().datum;
  pose_mm_ = Eigen::Vector3d(pose[2].number(), pose[3].number(), pose[4].number());
  pose_look_ = looks();
}

void Surroundings::take_presence(const Change& change) {
  if (change.resynchronised) present_.clear();
  for (const Answer& answer : change.removed) present_.erase(std::string(answer.facts.front().datum[1].text()));
  for (const Answer& answer : change.added) present_.emplace(answer.facts.front().datum[1].text());
}

Task<void> Surroundings::take_look(std::int64_t frame, std::string text) {
  const Result<Datum> track = forms::interpret_vision_reply(text);
  if (!track || !track->is_form("track") || !view_ || !head_) co_return;
  if (blurred_looks_ > 0) {
    --blurred_looks_;
    co_return;
  }
  sightings_.look(frame, *track, *view_);
  compare_pose();
  excuse_hidden();
  const Result<Facts> perceived = perceive();
  Beliefs::Change change;
  if (perceived) change = beliefs_.perceive(*perceived);
  for (const Datum& fact : change.come) changed_in_.insert_or_assign(fact, frame);
  for (const Datum& fact : change.gone) changed_in_.insert_or_assign(fact, frame);
  if (service_.presence() != told_under_) {
    // A board that began anew knows nothing of what was told before.
    told_under_ = service_.presence();
    told_places_.clear();
    all_told_ = false;
  }
  Transaction places;
  tell_places(places);
  if (!places.steps.empty()) co_await commit(context_.board, context_.executor, std::move(places));
  if (!all_told_) change.come.assign(beliefs().begin(), beliefs().end());
  if (!perceived) co_await tell_failure(perceived.error());
  if (change.any()) {
    co_await tell_change(change);
    if (observer_) observer_(change);
  }
  changed_.wake_all();
}

std::int64_t Surroundings::changed_in(const Datum& belief) const {
  const auto it = changed_in_.find(belief);
  return it == changed_in_.end() ? 0 : it->second;
}

bool Surroundings::calm() const {
  const std::optional<Eigen::Vector3d> grip = grip_mm();
  for (const auto& [name, sighting] : sightings_.all()) {
    const bool with_the_arm = name == options_.gripper.mark || (grip && (sighting.place_mm - *grip).norm() < held_mm);
    if (with_the_arm || !sightings_.recent(name, still_looks)) continue;
    if (sightings_.still_looks(name) < still_looks) return false;
  }
  return true;
}

bool Surroundings::steady(const std::vector<std::string>& objects) const {
  if (!beliefs_.settled() || !calm()) return false;
  for (const std::string& name : objects) {
    if (!sightings_.recent(name, 2) || sightings_.still_looks(name) < still_looks) return false;
  }
  return true;
}

Task<bool> Surroundings::look_after(std::uint64_t look, Time deadline) {
  while (looks() <= look) {
    const bool woken = co_await changed_.wait(deadline);
    if (!woken) co_return looks() > look;
  }
  co_return true;
}

Task<bool> Surroundings::wait_present(std::string agent, Time deadline) {
  while (!present(agent)) {
    const bool woken = co_await changed_.wait(deadline);
    if (!woken) co_return present(agent);
  }
  co_return true;
}

Task<std::optional<Datum>> Surroundings::newest(Datum pattern) {
  const std::vector<Fact> facts = co_await facts_now(context_.board, context_.executor, std::move(pattern));
  if (facts.empty()) co_return std::nullopt;
  co_return facts.back().datum;
}

}  // namespace pizarra::coordinator
