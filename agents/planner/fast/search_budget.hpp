#pragma once

// How far the searches of one call may go together: states looked at, memory, and the caller's patience.
//
//   SearchBudget spent(budget, cancelled);
//   spent.count();
//   if (const auto stopped = spent.stopped()) return *stopped;

#include <algorithm>
#include <optional>

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

enum class SearchEnd : std::uint8_t { found, exhausted, spent, cancelled };

class SearchBudget {
 public:
  SearchBudget(const Budget& budget, const std::function<bool()>& cancelled) : budget_(budget), cancelled_(cancelled) {}

  void count(std::size_t nodes = 1) { nodes_ += nodes; }
  std::size_t nodes() const { return nodes_; }
  std::size_t bytes() const { return budget_.bytes; }
  std::size_t nodes_left() const { return budget_.nodes - std::min(nodes_, budget_.nodes); }
  const std::function<bool()>& cancelled() const { return cancelled_; }
  std::optional<SearchEnd> stopped() const {
    if (cancelled_()) return SearchEnd::cancelled;
    if (nodes_ > budget_.nodes) return SearchEnd::spent;
    return std::nullopt;
  }

 private:
  const Budget& budget_;
  const std::function<bool()>& cancelled_;
  std::size_t nodes_ = 0;
};

}  // namespace pizarra::planner
