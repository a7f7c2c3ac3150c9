#include "agents/coordinator/pursue/object_search.hpp"

#include "agents/coordinator/perceive/missing_objects.hpp"
#include "agents/coordinator/pursue/hold_up.hpp"
#include "lisp/forms/goal_formula.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration steady_patience = 8s;
// An object that does not come into sight is searched for after this time.
constexpr Duration unseen_patience = 1s;
constexpr Duration put_down_patience = 60s;
// How many things are set aside in search of one, and how long each time one looks what was behind.
constexpr std::size_t most_set_aside = 6;
constexpr int most_set_aside_of_goal = 20;  // tries: what is found may be hidden again, and again
constexpr int most_swept_of_goal = 14;      // all that are within reach, and one again
constexpr int tries_to_set_aside = 3;       // of a cube that stays where it is
constexpr double moved_cubes = 0.2;         // a try that failed moved it so far: it may be graspable there
constexpr int tries_to_sweep = 2;           // the thing that ended a sweep early has moved
constexpr Duration look_behind = 1500ms;

}  // namespace

bool ends_search(const Failure& failure) {
  return failure.symbol == "interrupted" || failure.symbol == "camera-doubtful" || is_hold_up(failure);
}

void ObjectSearch::begin() {
  set_aside_ = 0;
  swept_ = 0;
  hid_.clear();
}

Task<Result<void>> ObjectSearch::look_for(Goal goal) {
  const Result<void> there = co_await look_for_named(goal);
  const bool of_all = forms::quantified_over(goal.facts, domain_.perception().sees()) == forms::Quantified::all;
  if (!there || !of_all) co_return there;
  co_return co_await look_for_others(goal);
}

// Each object is found, whatever was seen of it lately, and all that are missing are named.
Task<Result<void>> ObjectSearch::look_for_named(Goal goal) {
  head_.begin();
  std::vector<std::string> missing;
  SetAside set_aside;
  for (const std::string& name : domain_.objects_in(goal.facts)) {
    const Result<void> there = co_await look_once_for(goal.number, name, set_aside);
    const bool unseen = !there && there.error().symbol == "missing-object";
    if (!there && !unseen) co_return there;
    if (unseen) missing.push_back(name);
  }
  // The search for another object may have shown it.
  const Sightings& sightings = surroundings_.scene().sightings();
  std::erase_if(missing, [&](const std::string& name) { return sightings.remembered(name, options_.grace_looks); });
  if (missing.empty()) co_return Result<void>();
  Failure why = missing_objects(missing);
  why.sentence += head_.in_vain();
  co_return fail(why);
}

std::vector<std::string> ObjectSearch::others_unseen() const {
  const Sightings& sightings = surroundings_.scene().sightings();
  std::vector<std::string> names;
  for (const auto& [name, sighting] : sightings.all()) {
    const bool here = sightings.remembered(name, options_.grace_looks);
    if (!here && eyes_.knows(name) && !away_.contains(name)) names.push_back(name);
  }
  return names;
}

Task<Result<void>> ObjectSearch::look_for_others(Goal goal) {
  if (forms::quantified_over(goal.facts, domain_.perception().sees()) == forms::Quantified::none) {
    co_return Result<void>();
  }
  if (goal.number != away_for_) away_.clear();
  away_for_ = goal.number;
  const Sightings& sightings = surroundings_.scene().sightings();
  std::erase_if(away_, [&](const std::string& name) { return sightings.remembered(name, options_.grace_looks); });
  SetAside set_aside;
  for (const std::string& name : others_unseen()) {
    const Result<void> there = co_await look_once_for(goal.number, name, set_aside);
    if (there) continue;
    if (there.error().symbol != "missing-object") co_return there;
    away_.insert(name);
    const std::string sentence = name + " is not seen and counts as away: the goal is about what is there";
    const Datum subject = Datum::symbol(name);
    co_await story_.tell("missing", sentence, subject);
  }
  co_return Result<void>();
}

bool ObjectSearch::arm_stands_low() const {
  const std::optional<Eigen::Vector3d> grip = surroundings_.scene().grip_mm();
  return grip && grip->z() < options_.travel_height_mm - 10;
}

// Where it does not show by itself, what may hide it is set aside, one thing after another.
Task<Result<void>> ObjectSearch::look_once_for(std::int64_t goal, std::string object, SetAside& set_aside) {
  Time deadline = context_.executor.now() + options_.missing_patience;
  bool out_of_the_way = false;
  set_aside.next_object();
  bool looked_behind = false;
  Time doubtful = context_.executor.now() + options_.missing_patience / 2;
  std::uint64_t looked_from = surroundings_.looks();
  while (true) {
    if (interruption_.raised()) co_return interruption_.failure();
    const Result<bool> found = co_await eyes_.find(object);
    if (!found) co_return fail(found);
    if (surroundings_.scene().sightings().remembered(object, options_.grace_looks)) co_return Result<void>();
    // Eyes that restarted find it, and may not track it any more.
    Result<void> tracking;
    if (*found) tracking = co_await eyes_.track();
    if (!tracking) co_return tracking;
    // The arm itself may hide it, if it stands low before it.
    if (!*found && arm_stands_low() && !out_of_the_way) {
      const Result<void> raised = co_await runner_.raise();
      if (!raised && ends_search(raised.error())) co_return raised;
      // One that ended early is tried again while there is time.
      out_of_the_way = raised.has_value();
    }
    // Looks that show what hides it say more than time that passes.
    const bool looked_enough = surroundings_.looks() - looked_from >= options_.belief_looks;
    const bool is_hidden = !*found && looked_enough && seems_hidden(object, set_aside);
    if (is_hidden || context_.executor.now() > doubtful) {
      const Result<bool> cleared = co_await look_elsewhere(goal, object, set_aside);
      if (!cleared) co_return fail(cleared);
      looked_from = surroundings_.looks();
      doubtful = context_.executor.now() + look_behind;
      const bool goes_on = *cleared || !looked_behind;
      if (goes_on) deadline = context_.executor.now() + options_.missing_patience;
      looked_behind = true;
    }
    // Found in one image alone, it has no place, and that is as good as not seen. While the eyes or the board were away
    // nobody looked, so that the time alone is no proof.
    if (context_.executor.now() > deadline) {
      const Failure why = missing_objects({object});
      co_return fail(why);
    }
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return looked;
  }
}

Task<Result<bool>> ObjectSearch::look_elsewhere(std::int64_t goal, std::string object, SetAside& set_aside) {
  if (!set_aside.head_looked) {
    set_aside.head_looked = true;
    const Result<bool> shown = co_await head_.look_for(object);
    if (!shown) co_return shown;
    if (*shown) co_return true;
  }
  const Result<bool> cleared = co_await clear_view(goal, std::move(object), set_aside);
  co_return cleared;
}

Task<Result<bool>> ObjectSearch::clear_view_of(std::int64_t goal, std::string missing, std::string but) {
  SetAside set_aside;
  set_aside.done.insert(std::move(but));
  co_return co_await clear_view(goal, std::move(missing), set_aside);
}

std::optional<std::string> ObjectSearch::stands_before(const std::string& missing, const SetAside& set_aside) const {
  if (set_aside.done.size() >= most_set_aside || set_aside_ >= most_set_aside_of_goal) return std::nullopt;
  std::set<std::string> done_now = set_aside.done;
  for (const std::string& name : set_aside.moved_before) done_now.erase(name);
  return surroundings_.scene().stands_before(missing, done_now);
}

bool ObjectSearch::seems_hidden(const std::string& object, const SetAside& set_aside) const {
  return surroundings_.scene().calm() && !arm_stands_low() && stands_before(object, set_aside);
}

std::optional<std::string> ObjectSearch::to_set_aside(std::int64_t goal, const std::string& missing,
                                                      const SetAside& set_aside) const {
  if (set_aside.done.size() >= most_set_aside || set_aside_ >= most_set_aside_of_goal) return std::nullopt;
  // A plan was made when all of the goal's objects had been found.
  const bool was_here = plan_.was_made_for(goal);
  const Scene& scene = surroundings_.scene();
  std::optional<std::string> before = stands_before(missing, set_aside);
  if (!before) before = scene.may_hide(missing, set_aside.done, was_here);
  return before == missing ? std::nullopt : before;
}

Task<Result<void>> ObjectSearch::set_aside_before(std::string before, std::string missing, SetAside& set_aside) {
  ++set_aside_;
  const std::optional<std::string> under = surroundings_.scene().under(before);
  Result<void> done = co_await rescues_.set_aside(before);
  const bool hides_again = done && !hid_.emplace(missing, before).second;
  const bool under_too = hides_again && under && *under != missing;
  if (under_too) done = co_await rescues_.set_aside(*under);
  const bool in_vain = !done && fails_for_good(before, set_aside);
  if (done) set_aside.try_failed_again();
  if (done || in_vain) set_aside.done.insert(before);
  if (done || in_vain) set_aside.moved_before.erase(before);
  co_return done;
}

bool ObjectSearch::fails_for_good(const std::string& before, SetAside& set_aside) const {
  const Scene& scene = surroundings_.scene();
  const Sighting* seen = scene.sightings().find(before);
  if (!seen) return true;
  const Eigen::Vector3d lies_mm = scene.centre_mm(before, *seen);
  Failed& failed = set_aside.failed.try_emplace(before, Failed{lies_mm}).first->second;
  const bool was_moved = (lies_mm - failed.at_mm).norm() > moved_cubes * domain_.cube_mm();
  if (was_moved) failed = {lies_mm};
  return ++failed.times == tries_to_set_aside;
}

Task<Result<bool>> ObjectSearch::lay_down_held(std::string missing, SetAside& set_aside) {
  const Result<void> laid = co_await rescues_.lay_down(std::move(missing));
  if (!laid) co_return fail(laid);
  set_aside.laid_down = true;
  co_return true;
}

Task<Result<bool>> ObjectSearch::sweep_in(std::int64_t goal, std::string missing, SetAside& set_aside) {
  if (swept_ >= most_swept_of_goal) co_return false;
  // Of one that only an earlier life saw it is known that it was here.
  const std::optional<Push> next = rescues_.next_sweep(missing, plan_.was_made_for(goal), set_aside.swept);
  if (!next) co_return false;
  ++swept_;
  const Result<void> swept = co_await rescues_.sweep_in(std::move(missing), *next);
  const bool was_met = !swept && swept.error().symbol == "stopped";
  const bool again = was_met && ++set_aside.stops < tries_to_sweep;
  set_aside.has_swept = set_aside.has_swept || !again;
  if (!again) set_aside.swept.push_back(*next);
  if (!again) set_aside.stops = 0;
  if (!swept) co_return fail(swept);
  co_return true;
}

// One that lay where the images now cut it off, as after a knock against the camera, is likely to lie there still.
Task<Result<bool>> ObjectSearch::search_the_table(std::int64_t goal, std::string missing, SetAside& set_aside) {
  const bool sweeps_first = !set_aside.has_swept && rescues_.lay_cut_off(missing);
  Result<bool> swept = false;
  if (sweeps_first) swept = co_await sweep_in(goal, missing, set_aside);
  const bool is_swept = !swept || *swept;
  if (is_swept) co_return swept;
  const std::optional<std::string> before = to_set_aside(goal, missing, set_aside);
  if (!before) co_return co_await sweep_in(goal, missing, set_aside);
  const Result<void> done = co_await set_aside_before(*before, missing, set_aside);
  if (!done) co_return fail(done);
  co_return true;
}

// Where a thing is nowhere to be seen, the gripper may hold it, another may stand before it, or it lies beside the
// images. The object from the gripper is looked at before anything else is moved. The search goes on after a try that
// failed; one that somebody's stop prevented is made later.
Task<Result<bool>> ObjectSearch::clear_view(std::int64_t goal, std::string missing, SetAside& set_aside) {
  const bool lays_down = !set_aside.laid_down && rescues_.seems_to_hold();
  Result<bool> tried = false;
  if (lays_down) tried = co_await lay_down_held(missing, set_aside);
  if (!lays_down) tried = co_await search_the_table(goal, missing, set_aside);
  if (tried || ends_search(tried.error())) co_return tried;
  const std::string sentence = "the rescue failed: " + tried.error().sentence;
  const Datum why = failure_to_datum(tried.error());
  co_await story_.tell("servo", sentence, why);
  co_return !lays_down;
}

Task<void> ObjectSearch::await_steady(std::vector<std::string> objects) {
  const Time begun = context_.executor.now();
  const std::uint64_t first_look = surroundings_.looks();
  while (!surroundings_.steady(objects) && !interruption_.raised()) {
    const Duration waited = context_.executor.now() - begun;
    if (waited >= steady_patience) co_return;
    const std::uint64_t looks = surroundings_.looks() - first_look;
    drop_hidden(objects);
    const bool is_long = waited >= unseen_patience && looks >= options_.belief_looks;
    if (is_long) drop_unseen(objects, looks);
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return;
  }
}

void ObjectSearch::drop_hidden(std::vector<std::string>& objects) const {
  const Sightings& sightings = surroundings_.scene().sightings();
  std::erase_if(objects, [&](const std::string& name) {
    return sightings.covered(name) || !sightings.remembered(name, options_.grace_looks);
  });
}

void ObjectSearch::drop_unseen(std::vector<std::string>& objects, std::uint64_t looks) const {
  const Sightings& sightings = surroundings_.scene().sightings();
  std::erase_if(objects, [&](const std::string& name) { return !sightings.recent(name, looks); });
}

Task<void> ObjectSearch::await_put_down() {
  const Time deadline = context_.executor.now() + put_down_patience;
  std::optional<std::string> held = surroundings_.scene().held_by_somebody();
  if (!held) co_return;
  const std::string sentence = "somebody holds " + *held + ": waiting until it is put down";
  const Datum object = Datum::symbol(*held);
  co_await story_.tell("agent", sentence, object);
  while (held && context_.executor.now() < deadline && !interruption_.raised()) {
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return;
    held = surroundings_.scene().held_by_somebody();
  }
}

}  // namespace pizarra::coordinator
