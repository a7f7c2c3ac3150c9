#pragma once

// Which points runs have come to, how often: what a swarm of faults is worth shows by what it exercised.
//
//   Coverage coverage;
//   coverage.hit("difference");
//   coverage.add(other);
//   for (const std::string& point : coverage.unreached()) ...       // of the named ones

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pizarra::chaos {

class Coverage {
 public:
  void hit(const std::string& point, std::uint64_t times = 1) { counts_[point] += times; }
  void add(const Coverage& other);
  const std::map<std::string, std::uint64_t>& counts() const { return counts_; }
  // Of all that are named, those that nobody came to.
  std::vector<std::string> unreached() const;

  // Points that the other came to at least five times, and this one never: what is exercised no more.
  std::vector<std::string> lost_since(const Coverage& reference) const;

  // "point count" lines, and back; lines that are none are left out.
  std::string text() const;
  static Coverage from_text(const std::string& text);

 private:
  std::map<std::string, std::uint64_t> counts_;
};

// Every point that a run may come to: differences, rescues, failures, and each class of faults in each state of the
// servo during each kind of operation.
const std::vector<std::string>& named_points();
std::string pair_point(const std::string& fault_class, const std::string& operation, int servo_state);

}  // namespace pizarra::chaos
