#include "agents/coordinator/pursue/why_not.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/coordinator/perceive/missing_objects.hpp"
#include "agents/coordinator/pursue/staged_goal.hpp"
#include "lisp/writer.hpp"

namespace pizarra::coordinator {

namespace {

std::string listed(const std::vector<Datum>& forms, std::string_view between) {
  std::string text;
  for (const Datum& form : forms) text += (text.empty() ? "" : std::string(between)) + write(form);
  return text;
}

bool is_about(const Datum& fact, const Datum& literal) {
  const Datum& wanted = literal.is_form("not") ? literal[1] : literal;
  const auto arguments = wanted.items().subspan(1);
  return std::ranges::any_of(fact.items().subspan(1), [&](const Datum& object) {
    return std::ranges::find(arguments, object) != arguments.end();
  });
}

bool names_one_twice(const Datum& literal) {
  const Datum& fact = literal.is_form("not") ? literal[1] : literal;
  const std::set<Datum> names(fact.items().begin() + 1, fact.items().end());
  return names.size() + 1 < fact.size();
}

// The literals that do not hold of the way with the fewest such, of those that the plan leads to. Without a plan nobody
// knows which ways can be had: of several as near, one without facts about twice the same object, as (on a a).
std::optional<std::vector<Datum>> nearest_of(const std::vector<forms::GoalLiterals>& ways, const Facts& from,
                                             const std::optional<Facts>& end) {
  std::optional<std::vector<Datum>> nearest;
  std::pair<std::size_t, std::ptrdiff_t> fewest;
  for (const forms::GoalLiterals& way : ways) {
    const auto holds_then = [&](const Datum& literal) { return forms::literal_holds(literal, *end); };
    if (end && !std::ranges::all_of(way, holds_then)) continue;
    std::vector<Datum> lacking;
    for (const Datum& literal : way) {
      if (!forms::literal_holds(literal, from)) lacking.push_back(literal);
    }
    const std::pair distance(lacking.size(), std::ranges::count_if(lacking, names_one_twice));
    if (nearest && distance >= fewest) continue;
    nearest = std::move(lacking);
    fewest = distance;
  }
  // The end may lack what the domain says always holds.
  if (!nearest && end) return nearest_of(ways, from, std::nullopt);
  return nearest;
}

}  // namespace

Task<Result<std::vector<std::string>>> WhyNot::tell(std::vector<Datum> goal) {
  const Result<void> looked = co_await look();
  if (!looked) co_return fail(looked);
  const std::vector<std::vector<Datum>> stages = staged_goal_of(goal).stages;
  Outset outset{surroundings_.beliefs(), Outset::Kind::seen};
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const std::string which = title(i, stages.size(), outset);
    const std::vector<Datum> lost = forms::unmet_parts(stages[i], outset.facts, planning_.objects());
    if (lost.empty()) {
      sentences.push_back(which + listed(stages[i], " and ") + (stages[i].size() > 1 ? " hold" : " holds"));
      continue;
    }
    const Way way = co_await way_to(stages[i], outset.facts);
    for (const Datum& part : lost) sentences.push_back(which + unmet(part, outset, way));
    sentences.push_back(which + way.sentence);
    outset.kind = way.end ? Outset::Kind::after_plan : Outset::Kind::seen_without_plan;
    outset.facts = way.end ? *way.end : surroundings_.beliefs();
  }
  co_return sentences;
}

std::string WhyNot::title(std::size_t stage, std::size_t stages, const Outset& outset) {
  if (stages == 1) return {};
  std::string title = fmt::format("stage {}", stage + 1);
  if (outset.kind == Outset::Kind::after_plan) title += fmt::format(", after stage {}", stage);
  if (outset.kind == Outset::Kind::seen_without_plan) title += ", from what is seen now";
  return title + ": ";
}

// Before the first goal nothing is tracked, and what is seen anew is believed after a few looks.
Task<Result<void>> WhyNot::look() {
  const Result<void> tracking = co_await eyes_.track();
  if (!tracking) co_return tracking;
  for (int i = 0; i <= options_.belief_looks; ++i) {
    const Result<void> looked = co_await eyes_.fresh_look();
    if (!looked) co_return looked;
  }
  co_return Result<void>();
}

// Of a part that can be had in several ways the nearest.
std::string WhyNot::unmet(const Datum& part, const Outset& outset, const Way& way) const {
  std::string sentence = write(part) + " does not hold";
  const Result<std::vector<forms::GoalLiterals>> ways = forms::goal_alternatives({part}, planning_.objects());
  if (!ways) return sentence + ": " + ways.error().sentence;
  const std::optional<std::vector<Datum>> nearest = nearest_of(*ways, outset.facts, way.end);
  if (!nearest) return sentence + ", and cannot with the objects that are seen";
  const bool is_itself = nearest->size() == 1 && nearest->front() == part;
  if (!is_itself) sentence += ": the nearest way to it lacks " + listed(*nearest, " and ");
  std::vector<Datum> instead;
  for (const Datum& fact : outset.facts) {
    if (std::ranges::any_of(*nearest, [&](const Datum& literal) { return is_about(fact, literal); }))
      instead.push_back(fact);
  }
  if (instead.empty()) return sentence;
  const bool is_seen = outset.kind != Outset::Kind::after_plan;
  return sentence + fmt::format("; what {}: {}", is_seen ? "is seen" : "holds then", listed(instead, " "));
}

Task<WhyNot::Way> WhyNot::way_to(std::vector<Datum> stage, Facts from) {
  std::vector<std::string> missing = domain_.objects_in(stage);
  std::erase_if(missing, [&](const std::string& name) {
    return surroundings_.scene().sightings().remembered(name, options_.grace_looks);
  });
  Way way;
  if (!missing.empty()) {
    way.sentence = missing_objects(missing).sentence;
    co_return way;
  }
  const Result<std::vector<Datum>> plan = co_await planning_.try_plan(std::move(stage), from);
  if (!plan) {
    way.sentence = describe(plan.error());
    co_return way;
  }
  way.sentence = "a plan leads there: " + listed(*plan, " ");
  way.end = end_of(*plan, std::move(from));
  co_return way;
}

// None where the plan has an operation that the domain does not know.
std::optional<Facts> WhyNot::end_of(const std::vector<Datum>& plan, Facts from) const {
  for (const Datum& operation : plan) {
    const Result<GroundOperation> ground = domain_.ground(operation);
    if (!ground) return std::nullopt;
    for (const Datum& fact : ground->deletes) from.erase(fact);
    from.insert(ground->adds.begin(), ground->adds.end());
  }
  return from;
}

}  // namespace pizarra::coordinator
