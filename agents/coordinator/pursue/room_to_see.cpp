#include "agents/coordinator/pursue/room_to_see.hpp"

#include <algorithm>

namespace pizarra::coordinator {

namespace {

// The names that the operation is about: the object to grasp first.
std::vector<std::string> operands(const GroundOperation& operation) {
  std::vector<std::string> names;
  for (const Datum& name : operation.name.items().subspan(1)) names.emplace_back(name.text());
  return names;
}

// While the fingers are empty, that includes the object to stack on: later they can set nothing aside.
std::vector<std::string> to_be_in_view(const NextOperation& next, bool holds) {
  std::vector<std::string> names = operands(next.rest.front());
  if (holds || names.empty()) return names;
  names.resize(1);
  const std::vector<std::string> then = next.rest.size() > 1 ? operands(next.rest[1]) : std::vector<std::string>();
  if (then.size() > 1 && then[0] == names[0]) names.push_back(then[1]);
  return names;
}

}  // namespace

Task<Result<bool>> RoomToSee::make(std::int64_t goal, NextOperation next) {
  const std::optional<std::string> cut_off = cut_off_below_carried(next.rest.front());
  // Every second time: in between, a cube that cannot be swept is tried as it lies.
  const bool is_in_turn = cut_off && ++carries_to_cut_off_[*cut_off] % 2 == 0;
  if (!is_in_turn) co_return co_await uncover(goal, std::move(next));
  co_await rescues_.bring_into_view(*cut_off);
  co_return true;
}

Task<void> RoomToSee::make_below_carried(GroundOperation operation) {
  const std::optional<std::string> cut_off = cut_off_below_carried(operation);
  if (cut_off) co_await rescues_.bring_into_view(*cut_off);
}

std::optional<std::string> RoomToSee::cut_off_below_carried(const GroundOperation& operation) const {
  const bool carries_to_another = operation.name.size() == 3 && rescues_.seems_to_hold();
  if (!carries_to_another) return std::nullopt;
  std::string target(operation.name[2].text());
  return rescues_.lay_cut_off(target) ? std::optional(std::move(target)) : std::nullopt;
}

Task<Result<bool>> RoomToSee::uncover(std::int64_t goal, NextOperation next) {
  const std::vector<std::string> names = to_be_in_view(next, rescues_.seems_to_hold());
  const Scene& scene = surroundings_.scene();
  const auto covered = std::ranges::find_if(names, [&](const std::string& name) {
    return scene.sightings().covered(name) && scene.stands_before(name, {names.front()});
  });
  if (covered == names.end()) co_return false;
  co_return co_await search_.clear_view_of(goal, *covered, names.front());
}

}  // namespace pizarra::coordinator
