#pragma once

// A board alone, with its journal in a file, and its clients over links that are cut or say nothing.

#include <optional>

#include "tests/bench/crash/ordeal.hpp"

namespace pizarra::bench {

class LoneOrdeal : public Ordeal {
 public:
  LoneOrdeal(std::string folder, std::uint64_t seed, std::function<bool()> is_stopped);
  void round() override;

 private:
  static Child start_links(const std::string& folder);
  std::string come_to_the_board(int client) override;
  Result<void> read_the_end(store::Store& store) override;
  void start_board();
  void harm(std::uint64_t kind);

  const std::string folder_;
  Child links_;
  std::optional<Child> board_;
  Clock::time_point absent_until_{};  // one client, longer than its session lasts
};

}  // namespace pizarra::bench
