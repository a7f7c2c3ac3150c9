#pragma once

// Rows of numbers, of different lengths, one after another in memory.
//
//   Rows needs;
//   needs.add(std::vector<std::size_t>{3, 5});
//   for (const std::uint32_t fact : needs[0]) ...

#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

namespace pizarra::planner {

class Rows {
 public:
  template <std::ranges::input_range Row>
  void add(const Row& row) {
    for (const auto item : row) items_.push_back(static_cast<std::uint32_t>(item));
    ends_.push_back(static_cast<std::uint32_t>(items_.size()));
  }
  std::span<const std::uint32_t> operator[](std::size_t row) const {
    return {items_.data() + ends_[row], ends_[row + 1] - ends_[row]};
  }
  std::size_t size() const { return ends_.size() - 1; }

 private:
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> ends_{0};  // of the row before
};

// The rows turned round: row i of the result lists, ascending, the rows that hold i.
Rows transposed(const Rows& rows, std::size_t size);

}  // namespace pizarra::planner
