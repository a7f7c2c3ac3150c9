#pragma once

// Two boards and three members of an etcd cluster on hosts of their own, and clients on each of them.

#include <array>
#include <string>
#include <vector>

#include "tests/bench/cluster/cluster_cell.hpp"
#include "tests/bench/crash/ordeal.hpp"

namespace pizarra::bench {

// A disk of so many bytes that one member has for itself, and that can be filled. The calling process mounts it where
// nobody else sees it, before it starts anything.
class SmallDisk {
 public:
  explicit SmallDisk(std::string folder);
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk();
  const std::string& folder() const { return folder_; }
  void fill() const;
  void empty() const;

 private:
  const std::string folder_;
};

class ClusterOrdeal : public Ordeal {
 public:
  ClusterOrdeal(const std::string& folder, std::uint64_t seed, std::function<bool()> is_stopped);
  void round() override;
  // How often each kind of fault came.
  std::string faults() const;

 private:
  enum class Fault : std::uint64_t {
    kill_leader,
    kill_board,
    kill_client,
    kill_member,
    cut_power,
    stop_leader,
    stop_member,
    stop_client,
    slow_member,
    isolate,
    deafen,
    silence,
    jump_clock,
    fill_disk,
    count
  };
  static constexpr auto kinds = static_cast<std::size_t>(Fault::count);

  std::string come_to_the_board(int client) override;
  void mend() override;
  Result<void> read_the_end(store::Store& store) override;
  void harm(Fault fault);
  void kill_board(std::size_t number);
  void kill_member(std::size_t number);
  void cut_power(std::size_t number);
  void link(std::size_t number, const std::string& conditions);
  void jump_clock(std::size_t number);
  void stutter(std::size_t member, int times);
  void start_who_ended();
  // Of the board that leads, of etcd's leader, or any: so that a leader comes to be among the few.
  std::size_t some_host();
  std::size_t some_board() { return below(ClusterCell::most_boards); }
  std::size_t some_member() { return below(ClusterCell::members); }

  SmallDisk disk_;
  ClusterCell cell_;
  std::vector<std::size_t> to_come_;  // each kind once before one comes again
  std::array<int, kinds> came_{};
};

}  // namespace pizarra::bench
