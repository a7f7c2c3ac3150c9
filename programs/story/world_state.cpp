#include "programs/story/world_state.hpp"

#include "lisp/plain_text.hpp"

namespace pizarra::story {

namespace {

constexpr Duration link_timeout = 5s;

// (cube NAME X Y Z YAW TILT STATE VISIBLE)
WorldState::Cube cube_from_datum(const Datum& item) {
  const Datum& state = item[7];
  return {.x_mm = item[2].number(),
          .y_mm = item[3].number(),
          .z_mm = item[4].number(),
          .yaw_deg = item[5].number(),
          .gone = state.is_symbol("gone"),
          .held = state.is_symbol("held"),
          .on = state.is_form("on") ? lowered(state[1].text()) : "",
          .loose = state.is_symbol("loose") || state.is_symbol("carried"),
          .visible = item[8].number()};
}

}  // namespace

Datum in_small_letters(const Datum& fact) {
  if (fact.is_symbol() || fact.is_string()) return Datum::symbol(lowered(fact.text()));
  if (!fact.is_list()) return fact;
  std::vector<Datum> items;
  for (const Datum& item : fact.items()) items.push_back(in_small_letters(item));
  return Datum::list(std::move(items));
}

Result<WorldState> world_state_from_datum(const Datum& head) {
  WorldState truth;
  for (const Datum& item : head.items()) {
    if (item.is_form("cube") && item.size() == 9) {
      truth.cubes.emplace(lowered(item[1].text()), cube_from_datum(item));
    } else if (!item.is_form("thing") && !item.is_form("facts")) {
      return fail("malformed", "the world's truth has an unknown part", item);
    }
  }
  return truth;
}

Task<Result<WorldState>> read_world_state(simulation::Link& link) {
  Datum request = list("truth"_sym);
  const Result<simulation::Message> answer = co_await link.call(std::move(request), link_timeout);
  if (!answer) co_return fail(answer);
  co_return world_state_from_datum(answer->head);
}

}  // namespace pizarra::story
