#include "tests/bench/planner/blocks_greedy.hpp"

#include <map>
#include <set>

namespace pizarra::bench {

namespace {

class Table {
 public:
  explicit Table(const planner::PlanningTask& task) {
    for (const planner::PlanningObject& object : task.objects) blocks_.push_back(object.name);
    for (const Datum& fact : task.initials) {
      if (fact.is_form("on")) under_[fact[1]] = fact[2];
    }
    for (const Datum& goal : task.goals) {
      if (!goal.is_form("on")) continue;
      wanted_under_[goal[1]] = goal[2];
      wanted_on_.insert(goal[2]);
    }
  }

  std::size_t run() {
    std::size_t actions = 0;
    while (build_one() || clear_one()) actions += 2;
    return actions;
  }

 private:
  // Whether nothing of the pile up to the block has to move.
  bool in_place(const Datum& block) const {
    const auto under = under_.find(block);
    const auto wanted = wanted_under_.find(block);
    if (wanted == wanted_under_.end()) {
      return under == under_.end() || (!wanted_on_.contains(under->second) && in_place(under->second));
    }
    return under != under_.end() && under->second == wanted->second && in_place(wanted->second);
  }

  std::set<Datum> covered() const {
    std::set<Datum> covered;
    for (const auto& [block, under] : under_) covered.insert(under);
    return covered;
  }

  bool build_one() {
    const std::set<Datum> covered = this->covered();
    for (const auto& [block, under] : wanted_under_) {
      if (in_place(block) || covered.contains(block) || covered.contains(under) || !in_place(under)) continue;
      under_[block] = under;
      return true;
    }
    return false;
  }

  bool clear_one() {
    const std::set<Datum> covered = this->covered();
    for (const Datum& block : blocks_) {
      if (in_place(block) || covered.contains(block) || !under_.contains(block)) continue;
      under_.erase(block);
      return true;
    }
    return false;
  }

  std::vector<Datum> blocks_;
  std::map<Datum, Datum> under_, wanted_under_;
  std::set<Datum> wanted_on_;
};

}  // namespace

std::size_t blocks_greedy_actions(const planner::PlanningTask& task) { return Table(task).run(); }

}  // namespace pizarra::bench
