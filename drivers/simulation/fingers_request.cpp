#include "drivers/simulation/fingers_request.hpp"

#include "drivers/simulation/hand_request.hpp"

namespace pizarra::simulation {

namespace {

constexpr double longest_carry_s = 600;

bool is_within(const Datum& request, std::size_t index, double low, double high) {
  return request[index].is_number() && request[index].number() >= low && request[index].number() <= high;
}

}  // namespace

Result<void> make_clumsy(Cell& cell, const Datum& request) {
  const std::string_view what = word(request, 1);
  if (what == "slip" && request.size() == 2) {
    if (!cell.gripper().held()) return fail("not-held", "the fingers hold nothing that could slip", request);
    cell.gripper().slip();
    return {};
  }
  if (what == "slips" && request.size() == 5) {
    const bool sound = is_within(request, 2, 0, 1) && request[3].is_integer() &&
                       is_within(request, 3, 1, ClumsyFingers::most_draws) && is_within(request, 4, 0, longest_carry_s);
    if (!sound) return bad_request(request);
    cell.fingers().slips({request[2].number(), static_cast<int>(request[3].integer()), request[4].number()});
    return {};
  }
  if (what != "misplace" || request.size() != 3 || !is_within(request, 2, 0, 1)) return bad_request(request);
  cell.fingers().misplaces(request[2].number());
  return {};
}

}  // namespace pizarra::simulation
