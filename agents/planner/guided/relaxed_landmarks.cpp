#include "agents/planner/guided/relaxed_landmarks.hpp"

#include <algorithm>

namespace pizarra {

namespace {

constexpr std::uint32_t never = UINT32_MAX;

}  // namespace

RelaxedLandmarks::RelaxedLandmarks(const Problem& problem, const Bits& allowed, std::vector<std::uint32_t> kind_of,
                                   std::size_t kinds)
    : problem_(problem),
      kind_of_(std::move(kind_of)),
      kinds_(kinds),
      words_((kinds + 63) / 64),
      needed_by_(problem.facts.size()),
      need_count_(problem.actions.size(), never),
      labels_(problem.facts.size() * words_),
      scratch_(words_) {
  for (std::uint32_t i = 0; i < problem.actions.size(); ++i) {
    const GroundAction& action = problem.actions[i];
    for (const std::size_t fact : action.preconditions) needs_.push_back(static_cast<std::uint32_t>(fact));
    for (const std::size_t fact : action.adds) adds_.push_back(static_cast<std::uint32_t>(fact));
    need_ends_.push_back(static_cast<std::uint32_t>(needs_.size()));
    add_ends_.push_back(static_cast<std::uint32_t>(adds_.size()));
    if (!allowed.test(i)) continue;
    need_count_[i] = static_cast<std::uint32_t>(action.preconditions.size());
    for (const std::size_t fact : action.preconditions) needed_by_[fact].push_back(i);
    if (action.preconditions.empty()) needless_.push_back(i);
  }
}

// What the action needs; false where it cannot be taken.
bool RelaxedLandmarks::label(std::size_t action, Word* to) const {
  if (missing_[action] != 0) return false;
  std::fill_n(to, words_, 0);
  for (std::size_t i = action == 0 ? 0 : need_ends_[action - 1]; i < need_ends_[action]; ++i) {
    const Word* needed = labels_.data() + needs_[i] * words_;
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
    fewer = fewer || (known[word] & ~needed[word]) != 0;
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
    for (std::size_t j = action == 0 ? 0 : add_ends_[action - 1]; j < add_ends_[action]; ++j) {
      reach(adds_[j], scratch_.data());
    }
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

}  // namespace pizarra
