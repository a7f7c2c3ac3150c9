#include "programs/story/stage_watch.hpp"

#include <fmt/format.h>

#include "agents/coordinator/pursue/staged_goal.hpp"
#include "agents/runtime/follow.hpp"
#include "lisp/writer.hpp"

namespace pizarra::story {

namespace {

using Stages = std::vector<std::vector<Datum>>;

std::string words_of(const std::vector<Datum>& stage) {
  std::string words;
  for (const Datum& form : stage) words += (words.empty() ? "" : " ") + write(form);
  return words;
}

std::string number_of(const Stages& stages, std::size_t stage) {
  return fmt::format("stage {} of {}", stage + 1, stages.size());
}

}  // namespace

std::string words_of_the_end(const std::vector<Datum>& goal) {
  const Stages stages = coordinator::staged_goal_of(goal).stages;
  if (stages.empty()) return {};
  const std::string words = words_of(stages.back());
  return stages.size() == 1 ? words : number_of(stages, stages.size() - 1) + ": " + words;
}

void StageWatch::begin(std::int64_t goal, const std::vector<Datum>& forms) {
  job_ = Job();
  stages_ = coordinator::staged_goal_of(forms).stages;
  shown_.assign(stages_.empty() ? 0 : stages_.size() - 1, std::nullopt);
  if (shown_.empty()) return;
  const Datum later = list("goal-state"_sym, goal, "running"_sym, list("stage"_sym, "?"_sym));
  job_ = context_.executor.spawn(
      runtime::follow(context_, later, [this](Change change) { return take(std::move(change)); }));
}

// (goal-state N running (stage K)): the stage before K holds; stages are counted from 1. It is told again once an
// object that stage K waited for shows, when the stage before need not hold any more.
Task<void> StageWatch::take(Change change) {
  for (const Answer& answer : change.added) {
    const Datum number = answer.facts.front().datum[3][1];
    const bool follows_one = number.is_integer() && number.integer() > 1;
    if (!follows_one) continue;
    const auto stage = static_cast<std::size_t>(number.integer() - 2);
    const bool is_news = stage < shown_.size() && !shown_[stage];
    if (is_news) co_await judge(stage);
  }
}

Task<void> StageWatch::judge(std::size_t stage) {
  const Result<bool> shows = co_await witness_.shows(stages_[stage]);
  const bool shown = shows && *shows;
  shown_[stage] = shown;
  const std::string why = shows ? "" : "; " + describe(shows.error());
  const std::string verdict = shown ? "the world shows " : "the world does not show ";
  narrator_.say(context_.executor.now(), "judge",
                verdict + number_of(stages_, stage) + ": " + words_of(stages_[stage]) + why);
}

std::vector<std::string> StageWatch::unmet(std::string_view outcome) const {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const std::string which = fmt::format("{}, {},", number_of(stages_, i), words_of(stages_[i]));
    const bool unsaid = !shown_[i] && outcome == "reached";
    const bool untrue = shown_[i] && !*shown_[i];
    if (unsaid) sentences.push_back("the cell never said that " + which + " holds");
    if (untrue) sentences.push_back("the cell said that " + which + " holds, and in the world it did not");
  }
  return sentences;
}

}  // namespace pizarra::story
