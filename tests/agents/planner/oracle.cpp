#include <algorithm>
#include <cassert>
#include <map>
#include <set>

#include "lisp/pattern.hpp"
#include "tests/agents/planner/planning_domains.hpp"

namespace pizarra::planner {

namespace {

using State = std::uint64_t;  // a bit a fact

struct Move {
  State needs = 0;
  State absents = 0;
  State adds = 0;
  State deletes = 0;
};

class Oracle {
 public:
  explicit Oracle(const PlanningTask& task) : task_(task) {
    for (const PlanningOperator& op : task.operators) bind(op, 0, Bindings());
  }

  std::optional<std::size_t> fewest_steps() {
    const State goals = bits(task_.goals, Bindings());
    const State absent_goals = bits(task_.absent_goals, Bindings());
    const auto is_goal = [&](State state) { return (goals & ~state) == 0 && (absent_goals & state) == 0; };
    std::vector<State> reached{bits(task_.initials, Bindings())};
    seen_.insert(reached.front());
    for (std::size_t steps = 0; !reached.empty(); ++steps) {
      if (std::ranges::any_of(reached, is_goal)) return steps;
      next_.clear();
      for (const State state : reached) choose(state, 0, Move());
      reached = next_;
    }
    return std::nullopt;
  }

 private:
  State bits(const std::vector<Datum>& atoms, const Bindings& bindings) {
    State state = 0;
    for (const Datum& atom : atoms) {
      const std::size_t bit = numbers_.emplace(substitute(atom, bindings), numbers_.size()).first->second;
      assert(bit < 64);
      state |= State{1} << bit;
    }
    return state;
  }

  void bind(const PlanningOperator& op, std::size_t parameter, const Bindings& bindings) {
    if (parameter == op.parameters.size()) {
      for (const PlanningEquality& equality : op.equalities) {
        const bool equal = substitute(equality.left, bindings) == substitute(equality.right, bindings);
        if (equal != equality.equal) return;
      }
      Move move{bits(op.preconditions, bindings), bits(op.absents, bindings), bits(op.adds, bindings),
                bits(op.deletes, bindings)};
      move.deletes &= ~move.adds;
      moves_.push_back(move);
      return;
    }
    for (const PlanningObject& object : task_.objects) {
      if (!is_subtype(task_.types, object.type, op.parameters[parameter].type)) continue;
      Bindings more = bindings;
      more.bind(op.parameters[parameter].variable, object.name);
      bind(op, parameter + 1, more);
    }
  }

  // Every set of moves that can be made at once from the state, beginning with the move at `index`.
  void choose(State state, std::size_t index, const Move& together) {
    for (; index < moves_.size(); ++index) {
      const Move& move = moves_[index];
      if ((move.needs & ~state) != 0 || (move.absents & state) != 0) continue;
      if ((move.deletes & (together.needs | together.adds)) != 0) continue;
      if ((together.deletes & (move.needs | move.adds)) != 0) continue;
      if ((move.adds & together.absents) != 0 || (together.adds & move.absents) != 0) continue;
      const Move both{together.needs | move.needs, together.absents | move.absents, together.adds | move.adds,
                      together.deletes | move.deletes};
      const State after = (state & ~both.deletes) | both.adds;
      if (seen_.insert(after).second) next_.push_back(after);
      choose(state, index + 1, both);
    }
  }

  const PlanningTask& task_;
  std::map<Datum, std::size_t> numbers_;
  std::vector<Move> moves_;
  std::set<State> seen_;
  std::vector<State> next_;
};

}  // namespace

std::optional<std::size_t> fewest_steps(const PlanningTask& task) { return Oracle(task).fewest_steps(); }

}  // namespace pizarra::planner
