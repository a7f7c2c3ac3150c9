#include "agents/planner/guided/visit_order.hpp"

#include <algorithm>
#include <deque>

namespace pizarra::planner {

namespace {

constexpr std::size_t max_hitting_steps = 20'000;
constexpr std::size_t max_rounds = 100;

// Depth-first for a hitting set of at most `allowed` elements.
class HittingSearch {
 public:
  explicit HittingSearch(const std::vector<std::vector<std::size_t>>& sets) : sets_(sets) {
    std::size_t elements = 0;
    for (const std::vector<std::size_t>& set : sets) {
      for (const std::size_t element : set) elements = std::max(elements, element + 1);
    }
    marks_.resize(elements);
  }

  bool within(std::size_t allowed) {
    if (++steps_ > max_hitting_steps) return false;
    const std::vector<std::size_t>* open = nullptr;
    std::size_t apart = 0;  // open sets that share nothing: each needs an element of its own
    for (const std::vector<std::size_t>& set : sets_) {
      const auto is_chosen = [&](std::size_t element) { return marks_[element].chosen; };
      const auto is_seen = [&](std::size_t element) { return marks_[element].seen == steps_; };
      if (std::ranges::any_of(set, is_chosen)) continue;
      if (open == nullptr || set.size() < open->size()) open = &set;
      if (std::ranges::any_of(set, is_seen)) continue;
      for (const std::size_t element : set) marks_[element].seen = steps_;
      if (++apart > allowed) return false;
    }
    if (open == nullptr) return true;
    for (const std::size_t element : *open) {
      chosen_.push_back(element);
      marks_[element].chosen = true;
      if (within(allowed - 1)) return true;
      chosen_.pop_back();
      marks_[element].chosen = false;
    }
    return false;
  }

  bool exhausted() const { return steps_ > max_hitting_steps; }
  const std::vector<std::size_t>& chosen() const { return chosen_; }

 private:
  const std::vector<std::vector<std::size_t>>& sets_;
  struct Marks {
    bool chosen = false;
    std::size_t seen = 0;  // in this step
  };
  std::vector<Marks> marks_;  // of every element
  std::vector<std::size_t> chosen_;
  std::size_t steps_ = 0;
};

}  // namespace

Hitting fewest_hitting(const std::vector<std::vector<std::size_t>>& sets, std::size_t at_least) {
  HittingSearch search(sets);
  for (std::size_t allowed = at_least;; ++allowed) {
    if (search.within(allowed)) return {search.chosen(), true, allowed};
    if (search.exhausted()) return {{}, false, allowed};
  }
}

VisitOrder::VisitOrder(std::size_t visits) : count_(visits), after_(2 * visits, Bits(2 * visits)) {}

// The visits of which one must be repeated because of a circle from the first time of `visit` to its last: as few as
// possible. None: there is no such circle.
VisitOrder::Visits VisitOrder::cycle_through(std::size_t visit, const Bits& repeated) const {
  constexpr std::size_t unknown = SIZE_MAX;
  std::vector<std::size_t> from(2 * count_, unknown);
  Bits open(2 * count_);  // not reached yet
  for (std::size_t node = 0; node < 2 * count_; ++node) open.set(node);
  open.reset(visit);
  std::deque<std::size_t> queue{visit};
  while (!queue.empty() && open.test(count_ + visit)) {
    const std::size_t node = queue.front();
    queue.pop_front();
    const auto reach = [&](std::size_t next, bool free) {
      open.reset(next);
      from[next] = node;
      if (free) {
        queue.push_front(next);
      } else {
        queue.push_back(next);
      }
    };
    Bits next = after_[node];
    next &= open;
    next.for_each([&](std::size_t later) { reach(later, true); });
    const std::size_t twin = node < count_ ? node + count_ : node - count_;
    if (node == visit || !open.test(twin)) continue;
    if (node < count_) reach(twin, true);
    // Only a visit made once leads from its last time to its first.
    if (node >= count_ && !repeated.test(twin)) reach(twin, false);
  }
  if (open.test(count_ + visit)) return {};
  Visits circle{visit};
  for (std::size_t node = count_ + visit; node != visit; node = from[node]) {
    if (node < count_ && from[node] == node + count_) circle.push_back(node);
  }
  return circle;
}

std::size_t VisitOrder::fewest_repeats() const {
  std::vector<Visits> circles;
  Hitting hitting;
  for (std::size_t round = 0; round < max_rounds && hitting.complete; ++round) {
    Bits repeated(2 * count_);
    for (const std::size_t visit : hitting.elements) repeated.set(visit);
    const std::size_t known = circles.size();
    for (std::size_t visit = 0; visit < count_; ++visit) {
      if (repeated.test(visit)) continue;
      Visits circle = cycle_through(visit, repeated);
      if (circle.empty()) continue;
      std::ranges::sort(circle);
      if (std::ranges::find(circles, circle) == circles.end()) circles.push_back(std::move(circle));
    }
    if (circles.size() == known) break;
    hitting = fewest_hitting(circles, hitting.at_least);
  }
  return hitting.at_least;
}

}  // namespace pizarra::planner
