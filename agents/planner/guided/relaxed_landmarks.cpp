#include "agents/planner/guided/relaxed_landmarks.hpp"

#include <algorithm>

namespace pizarra::planner {

namespace {

constexpr std::uint32_t never = UINT32_MAX;

}  // namespace

RelaxedLandmarks::RelaxedLandmarks(const Problem& problem, const Bits& allowed, std::vector<std::uint32_t> kind_of,
                                   std::size_t kinds)
    : problem_(problem),
      kind_of_(std::move(kind_of)),
      kinds_(kinds),
      words_((kinds + 63) / 64),
      need_count_(problem.actions.size(), never),
      labels_(problem.facts.size() * words_),
      scratch_(words_) {
  Rows allowed_needs;
  const std::vector<std::size_t> nothing;
  for (std::uint32_t i = 0; i < problem.actions.size(); ++i) {
    const GroundAction& action = problem.actions[i];
    needs_.add(action.preconditions);
    adds_.add(action.adds);
    allowed_needs.add(allowed.test(i) ? action.preconditions : nothing);
    if (!allowed.test(i)) continue;
    need_count_[i] = static_cast<std::uint32_t>(action.preconditions.size());
    if (action.preconditions.empty()) needless_.push_back(i);
  }
  needed_by_ = transposed(allowed_needs, problem.facts.size());
}

// What the action needs; false where it cannot be taken.
bool RelaxedLandmarks::label(std::size_t action, Word* to) const {
  if (missing_[action] != 0) return false;
  std::fill_n(to, words_, 0);
  for (const std::uint32_t fact : needs_[action]) {
    const Word* needed = labels_.data() + fact * words_;
    for (std::size_t word = 0; word < words_; ++word) to[word] |= needed[word];
  }
  const std::uint32_t kind = kind_of_[action];
  if (kind != no_kind) to[kind / 64] |= Word{1} << (kind % 64);
  return true;
}

// By a way that needs these kinds.
void RelaxedLandmarks::reach(std::size_t fact, const Word* needed) {
  Word* known = labels_.data() + fact * words_;
  const bool first = reached_[fact] == 0;
  bool fewer = first;
  reached_[fact] = 1;
  for (std::size_t word = 0; word < words_; ++word) {
    fewer |= (known[word] & ~needed[word]) != 0;
    known[word] &= needed[word];
  }
  if (!fewer) return;
  for (const std::uint32_t action : needed_by_[fact]) {
    if (first) --missing_[action];
    if (missing_[action] != 0 || waiting_[action] != 0) continue;
    waiting_[action] = 1;
    open_.push_back(action);
  }
}

void RelaxedLandmarks::from(const Bits& state) {
  missing_ = need_count_;
  std::ranges::fill(labels_, ~Word{0});
  reached_.assign(problem_.facts.size(), 0);
  waiting_.assign(problem_.actions.size(), 0);
  open_ = needless_;
  std::ranges::fill(scratch_, 0);
  state.for_each([&](std::size_t fact) { reach(fact, scratch_.data()); });
  for (std::size_t i = 0; i < open_.size(); ++i) {
    const std::uint32_t action = open_[i];
    waiting_[action] = 0;
    label(action, scratch_.data());
    for (const std::uint32_t fact : adds_[action]) reach(fact, scratch_.data());
  }
}

Bits RelaxedLandmarks::of_fact(std::size_t fact) const {
  Bits kinds(kinds_);
  for (std::size_t kind = 0; kind < kinds_; ++kind) {
    if ((labels_[fact * words_ + kind / 64] >> (kind % 64) & 1) != 0) kinds.set(kind);
  }
  return kinds;
}

Bits RelaxedLandmarks::of_all(const std::vector<std::uint32_t>& actions) const {
  std::vector<Word> common(words_, ~Word{0}), one(words_);
  for (const std::uint32_t action : actions) {
    if (!label(action, one.data())) continue;
    for (std::size_t word = 0; word < words_; ++word) common[word] &= one[word];
  }
  Bits kinds(kinds_);
  for (std::size_t kind = 0; kind < kinds_; ++kind) {
    if ((common[kind / 64] >> (kind % 64) & 1) != 0) kinds.set(kind);
  }
  return kinds;
}

}  // namespace pizarra::planner
