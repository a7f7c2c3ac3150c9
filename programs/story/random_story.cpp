#include "programs/story/random_story.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace pizarra::story {

namespace {

// The row is cut into equal shares, one for each cube, or as many as have room. A pile stands in the middle of one, a
// little off.
constexpr double off_x_mm = 25;
constexpr double off_y_mm = 6;
constexpr double off_yaw_deg = 10;
constexpr double highest_pile_mm = 300;  // over which the arm travels
constexpr double latest_disturbance_s = 20;
constexpr double within_s = 400;
constexpr double agent_away_s = 3;

using Piles = std::vector<std::vector<std::string>>;  // each from the bottom up

template <class T>
void shuffle(std::vector<T>& items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
}

struct Room {
  std::size_t most = 0;  // piles
  std::size_t high = 0;  // cubes in one
};

// For a cube that finds its pile as high as it may be: a new one, or the lowest.
std::size_t another_pile(const Piles& piles, const Room& room) {
  if (piles.size() < room.most) return piles.size();
  const auto lowest = std::ranges::min_element(piles, {}, &Piles::value_type::size);
  return static_cast<std::size_t>(lowest - piles.begin());
}

Piles random_piles(std::vector<std::string> names, const Room& room, Random& random) {
  shuffle(names, random);
  Piles piles;
  for (const std::string& name : names) {
    std::size_t pile = random.below(std::min(piles.size() + 1, room.most));
    if (pile < piles.size() && piles[pile].size() >= room.high) pile = another_pile(piles, room);
    if (pile == piles.size()) piles.emplace_back();
    piles[pile].push_back(name);
  }
  return piles;
}

double row_mm(const forms::CellDescription& cell) { return cell.row.y_high_mm - cell.row.y_low_mm; }

std::size_t shares(const forms::CellDescription& cell) {
  return std::min(cell.cubes.size(), static_cast<std::size_t>(row_mm(cell) / cell.openings.wide_mm));
}

// Where not every cube has a share, one is left free, so that cubes can be put down.
std::size_t most_piles(const forms::CellDescription& cell) {
  return shares(cell) < cell.cubes.size() ? shares(cell) - 1 : shares(cell);
}

// At least as many as it takes for all cubes to stand in the piles that there may be.
std::size_t most_in_a_pile(const forms::CellDescription& cell) {
  const std::size_t needed = (cell.cubes.size() + most_piles(cell) - 1) / most_piles(cell);
  return std::max(needed, static_cast<std::size_t>(highest_pile_mm / cell.cube_mm));
}

std::vector<forms::CubePlacement> place_piles(const Piles& piles, const forms::CellDescription& cell, Random& random) {
  std::vector<double> middles_mm;
  const double share_mm = row_mm(cell) / static_cast<double>(shares(cell));
  for (std::size_t i = 0; i < shares(cell); ++i) {
    middles_mm.push_back(cell.row.y_low_mm + (static_cast<double>(i) + 0.5) * share_mm);
  }
  shuffle(middles_mm, random);
  std::vector<forms::CubePlacement> out;
  for (std::size_t i = 0; i < piles.size(); ++i) {
    const double x_mm = cell.row.x_mm + random.uniform(-off_x_mm, off_x_mm);
    const double y_mm = middles_mm[i] + random.uniform(-off_y_mm, off_y_mm);
    std::string below;
    for (const std::string& name : piles[i]) {
      forms::CubePlacement cube = *std::ranges::find(cell.cubes, name, &forms::CubePlacement::name);
      cube.x_mm = x_mm;
      cube.y_mm = y_mm;
      cube.yaw_deg = random.uniform(-off_yaw_deg, off_yaw_deg);
      cube.on = below;
      below = name;
      out.push_back(std::move(cube));
    }
  }
  return out;
}

Datum on(const std::string& upper, const std::string& lower) {
  return list("on"_sym, Datum::symbol(upper), Datum::symbol(lower));
}

// Whether a pile has this cube right above the other.
bool stands_on(const Piles& piles, std::string_view upper, std::string_view lower) {
  return std::ranges::any_of(piles, [&](const std::vector<std::string>& pile) {
    const auto below = std::ranges::find(pile, lower);
    return below != pile.end() && below + 1 != pile.end() && *(below + 1) == upper;
  });
}

// A goal made of an arrangement of all cubes: which stands on which, and at times which stand on the table. It differs
// from the start, so that there is something to do.
std::vector<Datum> random_goal(const std::vector<std::string>& names, const Room& room, const Piles& start,
                               Random& random) {
  std::vector<Datum> goal;
  bool differs = false;
  while (!differs) {
    goal.clear();
    for (const auto& pile : random_piles(names, room, random)) {
      for (std::size_t i = 1; i < pile.size(); ++i) {
        goal.push_back(on(pile[i], pile[i - 1]));
        differs = differs || !stands_on(start, pile[i], pile[i - 1]);
      }
      if (random.below(4) == 0) goal.push_back(list("on-table"_sym, Datum::symbol(pile.front())));
    }
  }
  return goal;
}

Datum hand(std::string_view operation, const std::string& name, std::vector<Datum> more) {
  std::vector<Datum> items{"hand"_sym, Datum::symbol(operation), Datum::symbol(name)};
  items.insert(items.end(), more.begin(), more.end());
  return Datum::list(std::move(items));
}

Datum whole_mm(double value) { return Datum::integer(static_cast<std::int64_t>(value)); }

std::vector<Datum> random_disturbance(std::vector<std::string> names, const forms::CubeRow& row, Random& random) {
  shuffle(names, random);
  const std::string& target = names[0];
  switch (random.below(8)) {
    case 0:
      return {hand("push", target, {whole_mm(random.uniform(-20, 20)), whole_mm(random.uniform(-60, 60))})};
    case 1:
      return {hand("place", target,
                   {whole_mm(row.x_mm + random.uniform(-off_x_mm, off_x_mm)),
                    whole_mm(random.uniform(row.y_low_mm, row.y_high_mm))})};
    case 2:
      return {hand("stack", target, {Datum::symbol(names[1])})};
    case 3:
      return {hand("steal", target, {})};
    case 4:
      return {hand("remove", target, {})};
    case 5:
      return {hand("knock", target, {})};
    default:
      break;
  }
  const std::vector<Datum> agents{"robot"_sym, "vision"_sym, "planner"_sym, "coordinator"_sym};
  const Datum& agent = agents[random.below(agents.size())];
  return {list("kill"_sym, agent), list("wait"_sym, agent_away_s), list("restart"_sym, agent)};
}

}  // namespace

Result<void> check_random_cell(const forms::CellDescription& cell, const forms::Domain& domain) {
  if (cell.cubes.size() < 2 || shares(cell) < 2) {
    return fail(
        "bad-cell",
        fmt::format("random stories are about 2 cubes or more in 2 piles or more with {} mm of the row each, and "
                    "this cell has {} and a row of {} mm",
                    cell.openings.wide_mm, cell.cubes.size(), row_mm(cell)));
  }
  for (const auto& [name, arguments] : {std::pair("on", 2U), std::pair("on-table", 1U)}) {
    const auto found = std::ranges::find(domain.predicates, name, &forms::Predicate::name);
    if (found != domain.predicates.end() && found->arguments.size() == arguments) continue;
    return fail("bad-cell",
                fmt::format("random goals are about on and on-table, and the domain {} has no {}", domain.name, name));
  }
  return {};
}

RandomStory random_story(forms::CellDescription cell, Random random) {
  std::vector<std::string> names;
  for (const forms::CubePlacement& cube : cell.cubes) names.push_back(cube.name);
  Random start = random.split("start");
  Random wish = random.split("goal");
  Random trouble = random.split("disturbance");

  RandomStory story;
  story.cell = std::move(cell);
  const Room room{.most = most_piles(story.cell), .high = most_in_a_pile(story.cell)};
  const Piles piles = random_piles(names, room, start);
  story.cell.cubes = place_piles(piles, story.cell, start);
  story.scenario.name = "random";
  story.scenario.goal = random_goal(names, room, piles, wish);
  story.scenario.within_s = within_s;
  const double at_s = trouble.uniform(0, latest_disturbance_s);
  std::vector<Datum> actions{list("wait"_sym, at_s)};
  const std::vector<Datum> disturbance = random_disturbance(names, story.cell.row, trouble);
  actions.insert(actions.end(), disturbance.begin(), disturbance.end());
  story.scenario.events.push_back({list("goal-state"_sym, "?"_sym, "running"_sym, "?"_sym), std::move(actions)});
  return story;
}

}  // namespace pizarra::story
