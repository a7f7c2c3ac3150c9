#include "drivers/simulation/hand_request.hpp"

#include <cmath>
#include <fmt/format.h>

namespace pizarra::simulation {

namespace {

constexpr double furthest_mm = 2000;
constexpr double least_speed_mm_s = 1;
constexpr double longest_hold_s = 60;
constexpr double longest_carry_s = 600;

// The numbers from `first` on, all of them lengths that fit a cell.
Result<std::vector<double>> lengths(const Datum& request, std::size_t first, std::size_t count) {
  if (request.size() != first + count) return bad_request(request);
  std::vector<double> out;
  for (std::size_t i = first; i < request.size(); ++i) {
    if (!request[i].is_number() || std::abs(request[i].number()) > furthest_mm) return bad_request(request);
    out.push_back(request[i].number());
  }
  return out;
}

Result<void> add_cube(Cell& cell, const Datum& request) {
  const Result<std::vector<double>> to = lengths(request, 4, 2);
  if (!to) return fail(to);
  const std::optional<FaceMark> mark = face_mark_from_name(word(request, 3));
  if (!mark) return fail("bad-request", "that is no mark of this world, neither a shape nor a tag", request[3]);
  if (cell.hand().busy()) return fail("busy", "the hand is doing something else");
  const Result<DynamicId> cube = cell.prepare(word(request, 2), *mark);
  if (!cube) return fail(cube);
  return cell.hand().add(*cube, (*to)[0], (*to)[1]);
}

bool is_within(const Datum& request, std::size_t index, double low, double high) {
  return request[index].is_number() && request[index].number() >= low && request[index].number() <= high;
}

}  // namespace

std::unexpected<Failure> bad_request(const Datum& request) {
  return fail("bad-request", "the world does not know this request", request);
}

std::string_view word(const Datum& request, std::size_t index) {
  const bool there = index < request.size() && (request[index].is_symbol() || request[index].is_string());
  return there ? request[index].text() : std::string_view();
}

Result<void> begin_hand(Cell& cell, const Datum& request) {
  const std::string_view what = word(request, 1);
  if (what == "add") return add_cube(cell, request);
  const Result<DynamicId> cube = cell.find(word(request, 2));
  if (!cube) return fail(cube);
  if (!cell.physics().present(*cube)) {
    return fail("unknown-object", fmt::format("{} is not in the cell any more", word(request, 2)), request[2]);
  }
  Hand& hand = cell.hand();
  if (what == "push" || what == "place") {
    const Result<std::vector<double>> to = lengths(request, 3, 2);
    if (!to) return fail(to);
    return what == "push" ? hand.push(*cube, (*to)[0], (*to)[1]) : hand.place(*cube, (*to)[0], (*to)[1]);
  }
  if (what == "slide") {
    const Result<std::vector<double>> way = lengths(request, 3, 3);
    if (!way) return fail(way);
    if ((*way)[2] < least_speed_mm_s) return bad_request(request);
    return hand.slide(*cube, (*way)[0], (*way)[1], (*way)[2]);
  }
  if (what == "hold") {
    const Result<std::vector<double>> how = lengths(request, 3, 4);
    if (!how) return fail(how);
    const double seconds = (*how)[3];
    if (seconds <= 0 || seconds > longest_hold_s) return bad_request(request);
    return hand.hold(*cube, {(*how)[0], (*how)[1], (*how)[2]}, seconds);
  }
  if (what == "stack" && request.size() == 4) {
    const Result<DynamicId> on = cell.find(word(request, 3));
    if (!on) return fail(on);
    if (!cell.physics().present(*on)) return fail("unknown-object", "that cube is gone", request[3]);
    return hand.stack(*cube, *on);
  }
  if (what == "turn") {
    const bool sound = request.size() == 4 && is_within(request, 3, -180, 180);
    if (!sound) return bad_request(request);
    return hand.turn(*cube, request[3].number());
  }
  if (request.size() != 3) return bad_request(request);
  if (what == "steal") return hand.steal(*cube);
  if (what == "remove") return hand.remove(*cube);
  if (what == "knock") return hand.knock(*cube);
  return bad_request(request);
}

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
