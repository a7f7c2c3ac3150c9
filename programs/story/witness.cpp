#include "programs/story/witness.hpp"

#include <algorithm>

namespace pizarra::story {

namespace {

constexpr Duration look_pause = 250ms;
constexpr Duration blind_after = 2s;
constexpr double visible_enough = 0.5;

void collect_symbols(const Datum& datum, std::vector<std::string>& out) {
  if (datum.is_symbol()) out.emplace_back(datum.text());
  for (const Datum& item : datum.items()) collect_symbols(item, out);
}

}  // namespace

void Witness::open_eyes() { eyes_ = cell_.executor().spawn(keep_eyes_open()); }

Task<void> Witness::keep_eyes_open() {
  while (true) {
    const Result<WorldState> truth = co_await read_world_state(cell_.link());
    const Time now = cell_.executor().now();
    if (truth) {
      for (const auto& [name, cube] : truth->cubes) {
        const auto [entry, first] = last_visible_.try_emplace(name, now);
        if (cube.visible >= visible_enough) entry->second = now;
      }
    }
    co_await sleep(cell_.executor(), look_pause);
  }
}

bool Witness::blind_to(const std::vector<Datum>& goal) const {
  std::vector<std::string> names;
  for (const Datum& fact : goal) {
    const Datum folded = in_small_letters(fact);
    for (const Datum& argument : folded.items().subspan(1)) collect_symbols(argument, names);
  }
  const Time now = cell_.executor().now();
  return std::ranges::any_of(names, [&](const std::string& name) {
    const auto seen = last_visible_.find(name);
    return seen != last_visible_.end() && now - seen->second >= blind_after;
  });
}

Task<Result<bool>> Witness::shows(std::vector<Datum> goal) const {
  const Result<WorldState> truth = co_await read_world_state(cell_.link());
  if (!truth) co_return fail(truth);
  co_return judge_.shows(goal, *truth);
}

Task<Result<Verdict>> Witness::judge(std::vector<Datum> goal) {
  co_await sleep(cell_.executor(), settling_time);
  const Result<WorldState> truth = co_await read_world_state(cell_.link());
  if (!truth) co_return fail(truth);
  const Result<bool> shows = judge_.shows(goal, *truth);
  if (!shows) co_return fail(shows);
  Verdict verdict;
  verdict.holds = *shows;
  if (verdict.holds) co_return verdict;
  const Result<bool> possible = judge_.plan_exists(goal, *truth);
  if (!possible) co_return fail(possible);
  verdict.possible = *possible;
  co_return verdict;
}

}  // namespace pizarra::story
