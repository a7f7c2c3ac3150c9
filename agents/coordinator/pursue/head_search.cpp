#include "agents/coordinator/pursue/head_search.hpp"

#include <fmt/format.h>

#include "agents/coordinator/pursue/hold_up.hpp"

namespace pizarra::coordinator {

namespace {

// From one view: the first look or the second finds and places the object if it is there.
constexpr int looks_of_a_view = 2;
// Around a mark that is to stay in view while the arm works there, in cubes.
constexpr double kept_around = 0.75;

// A failure of the head alone: the search goes on without it.
bool is_of_the_head(const Failure& why) {
  return why.symbol == "head-away" || why.symbol == "head-taken" || why.symbol == "out-of-range" ||
         why.symbol == "closed" || why.symbol == "disconnected" || why.symbol == "timeout" ||
         why.symbol == "replaced" || why.symbol == "refused" || why.symbol == "bad-pan-tilt-unit";
}

}  // namespace

std::optional<HeadCamera> HeadSearch::camera() const {
  const Scene& scene = surroundings_.scene();
  if (!scene.view() || scene.camera().unknown()) return std::nullopt;
  return HeadCamera{scene.camera().pose(), scene.view()->model()};
}

std::vector<Eigen::Vector3d> HeadSearch::marks_in_view() const {
  const Sightings& sightings = surroundings_.scene().sightings();
  std::vector<Eigen::Vector3d> marks;
  for (const auto& [name, sighting] : sightings.all()) {
    const bool here = name != options_.gripper.mark && sightings.remembered(name, options_.grace_looks);
    if (here) marks.push_back(sighting.place_mm);
  }
  return marks;
}

Task<Result<bool>> HeadSearch::look_for(std::string object) {
  if (!head_.is_there()) co_return false;
  const std::optional<HeadCamera> stands = camera();
  if (!stands) co_return false;
  const Result<HeadRange> range = co_await head_.free_range();
  if (!range) co_return co_await without_head(range.error());
  const std::optional<HeadTurn> before = surroundings_.scene().head();
  if (!before) co_return false;
  Search search{std::move(object), *stands, *range, *before, marks_in_view()};
  const Result<bool> shown = co_await look_around(std::move(search));
  const bool of_head = !shown && is_of_the_head(shown.error());
  if (of_head) co_return co_await without_head(shown.error());
  co_return shown;
}

Task<Result<bool>> HeadSearch::without_head(Failure why) {
  if (!is_of_the_head(why)) co_return fail(why);
  in_vain_ = fmt::format(", and the head did not look for it elsewhere: {}", why.sentence);
  const std::string sentence = fmt::format("the head cannot look around: {}", why.sentence);
  const Datum detail = failure_to_datum(why);
  co_await story_.tell("missing", sentence, detail);
  co_return false;
}

Task<Result<bool>> HeadSearch::look_around(Search search) {
  ElbowRoom room;
  room.cube_mm = domain_.cube_mm();
  const std::vector<Eigen::Vector3d> table = table_within(room, surroundings_.scene().foot_mm(), search.camera);
  const std::vector<HeadTurn> views = views_of(search.camera, search.range, search.before, table, room.cube_mm / 2);
  const std::string begins = fmt::format("{} is not in view: the head turns to look for it", search.object);
  const Datum subject = Datum::symbol(search.object);
  co_await story_.tell("missing", begins, subject);
  for (const HeadTurn& view : views) {
    if (interruption_.raised()) co_return interruption_.failure();
    const Result<bool> shown = co_await look_from(view, search.object);
    if (!shown) co_return shown;
    if (!*shown) continue;
    const std::string found = fmt::format("the head found {}, turned by {:.0f} and {:.0f} degrees", search.object,
                                          view.pan_deg, view.tilt_deg);
    co_await story_.tell("missing", found, subject);
    const Result<void> kept = co_await show_with_others(std::move(search));
    if (!kept) co_return fail(kept);
    co_return true;
  }
  const Result<bool> back = co_await look_from(search.before, search.object);
  in_vain_ = fmt::format(", and the head looked in {} other directions", views.size());
  co_return back;
}

Task<Result<bool>> HeadSearch::look_from(HeadTurn view, std::string object) {
  const Result<void> turned = co_await head_.turn(view);
  if (!turned) co_return fail(turned);
  for (int look = 0; look < looks_of_a_view; ++look) {
    const Result<bool> found = co_await eyes_.find(object);
    if (!found) co_return found;
    // Eyes that restarted find it, and may not track it any more.
    Result<void> tracking;
    if (*found) tracking = co_await eyes_.track();
    if (!tracking) co_return fail(tracking);
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return fail(looked);
    if (surroundings_.scene().sightings().recent(object, 1)) co_return true;
  }
  co_return false;
}

Task<Result<void>> HeadSearch::show_with_others(Search search) {
  const Sighting* found = surroundings_.scene().sightings().find(search.object);
  if (!found) co_return Result<void>();
  std::vector<Eigen::Vector3d> marks = search.seen_mm;
  marks.push_back(found->place_mm);
  const double around_mm = kept_around * domain_.cube_mm();
  const std::optional<HeadTurn> all = turn_that_shows(search.camera, search.range, marks, around_mm);
  if (!all) co_return Result<void>();
  const Result<bool> shown = co_await look_from(*all, search.object);
  if (!shown) co_return fail(shown);
  co_return Result<void>();
}

}  // namespace pizarra::coordinator
