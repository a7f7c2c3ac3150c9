#include "agents/planner/optimal/interchangeable.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace pizarra::planner {

namespace {

// A predicate or an operator, and its objects, as numbers.
using Words = std::vector<std::size_t>;

constexpr std::size_t max_facts_an_object = 64;

class Names {
 public:
  explicit Names(const Problem& problem) : problem_(problem) {
    for (std::size_t i = 0; i < problem.facts.size(); ++i) {
      facts_.push_back(numbered(problem.facts[i]));
      fact_index_.emplace(facts_.back(), i);
    }
    for (std::size_t i = 0; i < problem.actions.size(); ++i) {
      actions_.push_back(numbered(problem.actions[i].name));
      action_index_.emplace(actions_.back(), i);
    }
  }

  std::size_t object_count() const { return objects_.size(); }

  // The facts an object is part of.
  std::vector<std::size_t> facts_of(std::size_t object) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < facts_.size(); ++i) {
      if (std::find(facts_[i].begin() + 1, facts_[i].end(), object) != facts_[i].end()) found.push_back(i);
    }
    return found;
  }

  // Where every fact goes when the two objects change places; none: something would not be the same.
  std::optional<std::vector<std::size_t>> exchange(std::size_t a, std::size_t b) const {
    std::vector<std::size_t> moved(facts_.size());
    for (std::size_t i = 0; i < facts_.size(); ++i) {
      const auto found = fact_index_.find(exchanged(facts_[i], a, b));
      if (found == fact_index_.end()) return std::nullopt;
      moved[i] = found->second;
      const bool same = problem_.initials.test(i) == problem_.initials.test(moved[i]) &&
                        problem_.goals.test(i) == problem_.goals.test(moved[i]);
      if (!same) return std::nullopt;
    }
    for (std::size_t i = 0; i < actions_.size(); ++i) {
      const auto found = action_index_.find(exchanged(actions_[i], a, b));
      if (found == action_index_.end()) return std::nullopt;
      const GroundAction& from = problem_.actions[i];
      const GroundAction& to = problem_.actions[found->second];
      const bool same = moves_to(from.preconditions, to.preconditions, moved) && moves_to(from.adds, to.adds, moved) &&
                        moves_to(from.deletes, to.deletes, moved);
      if (!same) return std::nullopt;
    }
    return moved;
  }

 private:
  Words numbered(const Datum& name) {
    Words words{words_.emplace(name[0], words_.size()).first->second};
    // `(not (on a b))` is a predicate of its own over the same objects.
    for (const Datum& item : name.items().subspan(1)) {
      if (item.is_list()) {
        const Words inner = numbered(item);
        words[0] = words[0] * 1'000'000 + inner[0] + 1;
        words.insert(words.end(), inner.begin() + 1, inner.end());
      } else {
        words.push_back(objects_.emplace(item, objects_.size()).first->second);
      }
    }
    return words;
  }

  static Words exchanged(Words words, std::size_t a, std::size_t b) {
    for (auto word = words.begin() + 1; word != words.end(); ++word) *word = *word == a ? b : *word == b ? a : *word;
    return words;
  }

  static bool moves_to(const std::vector<std::size_t>& from, const std::vector<std::size_t>& to,
                       const std::vector<std::size_t>& moved) {
    return from.size() == to.size() &&
           std::ranges::all_of(from, [&](std::size_t fact) { return std::ranges::binary_search(to, moved[fact]); });
  }

  const Problem& problem_;
  std::map<Datum, std::size_t> words_, objects_;
  std::vector<Words> facts_, actions_;
  std::map<Words, std::size_t> fact_index_, action_index_;
};

}  // namespace

Interchangeable::Interchangeable(const Problem& problem) {
  const Names names(problem);
  std::vector<char> placed(names.object_count(), 0);
  for (std::size_t first = 0; first < names.object_count(); ++first) {
    if (placed[first] != 0) continue;
    Kind kind{names.facts_of(first)};
    if (kind[0].empty() || kind[0].size() > max_facts_an_object) continue;
    for (std::size_t other = first + 1; other < names.object_count(); ++other) {
      if (placed[other] != 0 || names.facts_of(other).size() != kind[0].size()) continue;
      const std::optional<std::vector<std::size_t>> moved = names.exchange(first, other);
      if (!moved) continue;
      std::vector<std::size_t> facts;
      for (const std::size_t fact : kind[0]) facts.push_back((*moved)[fact]);
      const auto shared = [&](std::size_t fact) { return std::ranges::find(kind[0], fact) != kind[0].end(); };
      if (std::ranges::any_of(facts, shared)) continue;
      placed[other] = 1;
      kind.push_back(std::move(facts));
    }
    if (kind.size() > 1) kinds_.push_back(std::move(kind));
  }
}

void Interchangeable::sort(Bits& state) const {
  for (const Kind& kind : kinds_) {
    std::vector<std::uint64_t> holding;
    for (const std::vector<std::size_t>& facts : kind) {
      std::uint64_t held = 0;
      for (std::size_t i = 0; i < facts.size(); ++i) held |= std::uint64_t{state.test(facts[i])} << i;
      holding.push_back(held);
    }
    if (std::ranges::is_sorted(holding)) continue;
    std::ranges::sort(holding);
    for (std::size_t object = 0; object < kind.size(); ++object) {
      for (std::size_t i = 0; i < kind[object].size(); ++i) {
        if ((holding[object] >> i & 1) != 0) {
          state.set(kind[object][i]);
        } else {
          state.reset(kind[object][i]);
        }
      }
    }
  }
}

}  // namespace pizarra::planner
