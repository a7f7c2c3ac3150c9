#include "agents/planner/task/rows.hpp"

namespace pizarra::planner {

Rows transposed(const Rows& rows, std::size_t size) {
  std::vector<std::vector<std::uint32_t>> lists(size);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const std::uint32_t item : rows[row]) lists[item].push_back(static_cast<std::uint32_t>(row));
  }
  Rows out;
  for (const std::vector<std::uint32_t>& list : lists) out.add(list);
  return out;
}

}  // namespace pizarra::planner
