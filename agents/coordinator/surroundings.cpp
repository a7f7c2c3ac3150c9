#include "agents/coordinator/surroundings.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "agents/coordinator/telling.hpp"
#include "lisp/vision_reply.hpp"

namespace pizarra {

namespace {

constexpr Duration retry_pause = 200ms;
// A mark that moved less is not told anew.
constexpr double told_again_mm = 1;
// For how many looks an object must lie where it is to count as still.
constexpr std::uint64_t still_looks = 5;
// What is nearer to where a held object's mark stands goes with the arm.
constexpr double held_mm = 40;

double rounded(double mm) { return std::round(mm * 10) / 10; }

}  // namespace

Surroundings::Surroundings(AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
                           const Service& service, Story& story)
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
  const Datum model = list("camera-model"_sym, any, any, any, any, any, any);
  jobs_.push_back(executor.spawn(watch(model, &Surroundings::take_model)));
  jobs_.push_back(executor.spawn(watch(list("gripper"_sym, any), &Surroundings::take_gripper)));
  jobs_.push_back(executor.spawn(watch(list("faces"_sym, any, any), &Surroundings::take_faces)));
  const Datum pose = list("arm-pose"_sym, any, any, any, any, any, any);
  jobs_.push_back(executor.spawn(watch(pose, &Surroundings::take_pose)));
  jobs_.push_back(executor.spawn(watch(list("agent"_sym, any, any, any), &Surroundings::take_presence)));
  jobs_.push_back(executor.spawn(watch_vision()));
}

// Relations are declared by the agents that tell them, so a watch may have to wait for its relation.
Task<void> Surroundings::watch(Datum pattern, Handler handler) {
  const Query query = query_from_datum(pattern).value();
  while (true) {
    Result<std::unique_ptr<Watch>> watch = co_await context_.board.watch(query);
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
  const Query query = query_from_datum(list("vision-says"_sym, "?frame"_sym, "?text"_sym)).value();
  while (true) {
    Result<std::unique_ptr<Watch>> watch = co_await context_.board.watch(query);
    while (watch) {
      const Result<Change> change = co_await (*watch)->next();
      if (!change) break;
      // What stands there already when the watch begins may be old.
      if (change->resynchronised || change->added.empty()) continue;
      const Datum says = change->added.back().facts.front().datum;
      std::string text(says[2].text());
      co_await take_look(says[1].integer(), std::move(text));
    }
    co_await sleep(context_.executor, retry_pause);
  }
}

void Surroundings::take_model(const Change& change) {
  if (change.added.empty()) return;
  const Result<CameraModel> model = camera_model_from_fact(change.added.back().facts.front().datum);
  if (model) view_.emplace(options_.camera, *model);
}

void Surroundings::take_gripper(const Change& change) {
  if (!change.added.empty()) opening_mm_ = change.added.back().facts.front().datum[1].number();
}

void Surroundings::take_faces(const Change& change) {
  if (change.added.empty()) return;
  for (const Datum& face : change.added.back().facts.front().datum[2].items()) {
    if (face.size() == 2) sightings_.face(face[0].text(), face[1].number());
  }
}

void Surroundings::take_pose(const Change& change) {
  if (change.added.empty()) return;
  const Datum& pose = change.added.back().facts.front().datum;
  pose_mm_ = Eigen::Vector3d(pose[1].number(), pose[2].number(), pose[3].number());
}

void Surroundings::take_presence(const Change& change) {
  if (change.resynchronised) present_.clear();
  for (const Answer& answer : change.removed) present_.erase(std::string(answer.facts.front().datum[1].text()));
  for (const Answer& answer : change.added) present_.emplace(answer.facts.front().datum[1].text());
}

Task<void> Surroundings::take_look(std::int64_t frame, std::string text) {
  const Result<Datum> track = interpret_vision_reply(text);
  if (!track || !track->is_form("track") || !view_) co_return;
  sightings_.look(frame, *track, *view_);
  excuse_hidden();
  const Result<Facts> perceived = perceive();
  Beliefs::Change change;
  if (perceived) change = beliefs_.perceive(*perceived);
  for (const Datum& fact : change.come) changed_in_.insert_or_assign(fact, frame);
  for (const Datum& fact : change.gone) changed_in_.insert_or_assign(fact, frame);
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

void Surroundings::excuse_hidden() {
  const std::optional<Eigen::Vector3d> grip = grip_mm();
  if (!grip) return;
  std::vector<std::string> hidden;
  for (const auto& [name, sighting] : sightings_.all()) {
    const bool unseen = name != options_.gripper.mark && !sightings_.recent(name, 1);
    if (unseen && hidden_by_gripper(*view_, options_.gripper.outline, *grip, sighting.place_mm)) hidden.push_back(name);
  }
  for (const std::string& name : hidden) sightings_.excuse(name);
}

std::optional<Eigen::Vector3d> Surroundings::grip_mm() const {
  if (sightings_.recent(options_.gripper.mark, 1)) {
    const Eigen::Vector3d& mark = sightings_.find(options_.gripper.mark)->place_mm;
    return Eigen::Vector3d(mark - options_.gripper.mark_above_grip_mm * Eigen::Vector3d::UnitZ());
  }
  if (!pose_mm_ || !view_) return std::nullopt;
  return Eigen::Vector3d(*pose_mm_ - options_.gripper.mark_before_grip_mm * view_->away());
}

// The mark stands before the middle in the direction in which its face looks.
Eigen::Vector3d Surroundings::centre_mm(const std::string& name, const Sighting& sighting) const {
  if (!view_) return sighting.place_mm;
  const double yaw = sightings_.yaw_deg(name) * std::numbers::pi / 180;
  const Eigen::Vector3d looks = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * -view_->away();
  return sighting.place_mm - domain_.cube_mm() / 2 * looks;
}

std::optional<std::string> Surroundings::foremost() const {
  if (!view_) return std::nullopt;
  const Eigen::Vector3d row(options_.table.x_mm, 0, 0);
  double nearest_mm = 0.7 * domain_.cube_mm();
  std::optional<std::string> foremost;
  for (const auto& [name, sighting] : sightings_.all()) {
    if (name == options_.gripper.mark || !sightings_.recent(name, 1)) continue;
    const double before_mm = -(centre_mm(name, sighting) - row).dot(view_->away());
    if (before_mm <= nearest_mm) continue;
    nearest_mm = before_mm;
    foremost = name;
  }
  return foremost;
}

std::vector<Datum> Surroundings::measure() const {
  std::vector<Datum> measured;
  if (opening_mm_) measured.push_back(list("gripper"_sym, *opening_mm_));
  const std::optional<Eigen::Vector3d> grip = grip_mm();
  if (grip) measured.push_back(list("grip"_sym, grip->x(), grip->y(), grip->z()));
  for (const auto& [name, sighting] : sightings_.all()) {
    if (name == options_.gripper.mark || !sightings_.recent(name, grace_)) continue;
    const Eigen::Vector3d& at = sighting.place_mm;
    measured.push_back(list("seen"_sym, Datum::symbol(name), at.x(), at.y(), at.z()));
    if (!sightings_.recent(name, 1)) measured.push_back(list("unseen"_sym, Datum::symbol(name)));
  }
  return measured;
}

Result<Facts> Surroundings::perceive() const {
  const std::vector<Datum> believed(beliefs().begin(), beliefs().end());
  const Result<std::vector<Datum>> found = domain_.perception().perceive(measure(), believed);
  if (!found) return fail(found);
  Facts facts;
  for (const Datum& fact : *found) {
    if (domain_.domain().find_predicate(fact.head())) facts.insert(fact);
  }
  return facts;
}

void Surroundings::tell_places(Transaction& transaction) {
  const Datum any = "?"_sym;
  for (const auto& [name, sighting] : sightings_.all()) {
    const auto told = told_places_.find(name);
    const bool recent = sightings_.recent(name, grace_);
    if (!recent) {
      if (told == told_places_.end()) continue;
      transaction.retract(list("place"_sym, Datum::symbol(name), any, any, any, any));
      told_places_.erase(told);
      continue;
    }
    const Eigen::Vector3d& at = sighting.place_mm;
    if (told != told_places_.end() && (told->second - at).norm() < told_again_mm) continue;
    transaction.tell(
        list("place"_sym, Datum::symbol(name), rounded(at.x()), rounded(at.y()), rounded(at.z()), sighting.frame), {},
        service_.presence());
    told_places_.insert_or_assign(name, at);
  }
}

// The places from which a belief was concluded.
Task<std::vector<FactId>> Surroundings::evidence(Datum belief) {
  std::vector<FactId> ids;
  for (const Datum& object : belief.items().subspan(1)) {
    const Datum any = "?"_sym;
    const Datum pattern = list("place"_sym, object, any, any, any, any);
    const std::vector<Fact> places = co_await facts_now(context_.board, context_.executor, pattern);
    for (const Fact& place : places) ids.push_back(place.id);
  }
  co_return ids;
}

// Every look may fail in the same way; it is told once.
Task<void> Surroundings::tell_failure(Failure why) {
  if (told_failure_ == why.sentence) co_return;
  told_failure_ = why.sentence;
  const std::string sentence = fmt::format("the look cannot be understood, what was believed stays: {}", why.sentence);
  const Datum detail = failure_to_datum(why);
  co_await story_.tell("agent", sentence, detail);
}

Task<void> Surroundings::tell_change(Beliefs::Change change) {
  Transaction transaction;
  for (const Datum& fact : change.gone) {
    transaction.retract(list("believed"_sym, fact));
    transaction.retract(fact);
  }
  for (const Datum& fact : change.come) {
    const std::vector<FactId> because = co_await evidence(fact);
    const Datum believed = list("believed"_sym, fact);
    transaction.tell(believed, because, service_.presence());
    transaction.tell(fact, because, service_.presence());
  }
  const Result<Revision> told = co_await commit(context_.board, context_.executor, std::move(transaction));
  // Where the presence lapsed meanwhile, all is told anew once it is back.
  all_told_ = told.has_value();
  if (!told) told_places_.clear();
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

}  // namespace pizarra
