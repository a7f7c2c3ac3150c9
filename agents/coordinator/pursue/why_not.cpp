#include "agents/coordinator/pursue/why_not.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "agents/coordinator/perceive/missing_objects.hpp"
#include "agents/coordinator/pursue/wish.hpp"
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

}  // namespace

Task<Result<std::vector<std::string>>> WhyNot::tell(std::vector<Datum> goal) {
  const Result<void> looked = co_await look();
  if (!looked) co_return fail(looked);
  const std::vector<std::vector<Datum>> stages = wish_of(goal).stages;
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const std::string which = stages.size() > 1 ? fmt::format("stage {}: ", i + 1) : std::string();
    const std::vector<Datum> lost = forms::unmet_parts(stages[i], surroundings_.beliefs(), planning_.objects());
    if (lost.empty()) {
      sentences.push_back(which + listed(stages[i], " and ") + (stages[i].size() > 1 ? " hold" : " holds"));
      continue;
    }
    for (const Datum& part : lost) sentences.push_back(which + unmet(part));
    const std::string way = co_await way_to(stages[i]);
    sentences.push_back(which + way);
  }
  co_return sentences;
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

// Of a part that can be had in several ways the nearest, of which the fewest facts are lacking.
std::string WhyNot::unmet(const Datum& part) const {
  const Facts& beliefs = surroundings_.beliefs();
  std::string sentence = write(part) + " does not hold";
  const Result<std::vector<forms::GoalLiterals>> ways = forms::goal_alternatives({part}, planning_.objects());
  if (!ways) return sentence + ": " + ways.error().sentence;
  std::optional<std::vector<Datum>> nearest;
  for (const forms::GoalLiterals& way : *ways) {
    std::vector<Datum> lacking;
    for (const Datum& literal : way) {
      if (!forms::literal_holds(literal, beliefs)) lacking.push_back(literal);
    }
    if (!nearest || lacking.size() < nearest->size()) nearest = std::move(lacking);
  }
  if (!nearest) return sentence + ", and cannot with the objects that are seen";
  const bool is_itself = nearest->size() == 1 && nearest->front() == part;
  if (!is_itself) sentence += ": the nearest way to it lacks " + listed(*nearest, " and ");
  std::vector<Datum> instead;
  for (const Datum& fact : beliefs) {
    if (std::ranges::any_of(*nearest, [&](const Datum& literal) { return is_about(fact, literal); }))
      instead.push_back(fact);
  }
  if (instead.empty()) return sentence;
  return sentence + fmt::format("; what is seen: {}", listed(instead, " "));
}

Task<std::string> WhyNot::way_to(std::vector<Datum> stage) {
  std::vector<std::string> missing = domain_.objects_in(stage);
  std::erase_if(missing, [&](const std::string& name) {
    return surroundings_.scene().sightings().remembered(name, options_.grace_looks);
  });
  if (!missing.empty()) co_return missing_objects(missing).sentence;
  const Result<std::vector<Datum>> plan = co_await planning_.try_plan(std::move(stage));
  if (!plan) co_return describe(plan.error());
  co_return "a plan leads there: " + listed(*plan, " ");
}

}  // namespace pizarra::coordinator
