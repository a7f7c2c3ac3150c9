#pragma once

// A board between an agent and its session that brings a planted fault about (plants.hpp): what the agent tells is
// dropped or changed, and what it asks for is hidden or old.
//
//   PlantedBoard board(*session, process, "planner", "plan-not-kept");

#include <deque>
#include <memory>
#include <set>
#include <string>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::chaos {

class PlantedBoard : public Board {
 public:
  // Board and executor outlive it.
  PlantedBoard(Board& board, Executor& executor, std::string agent, std::string plant)
      : board_(board), executor_(executor), agent_(std::move(agent)), plant_(std::move(plant)) {}

  Task<Result<void>> declare(std::vector<Relation> relations) override;
  Task<Result<Revision>> transact(Transaction transaction) override;
  Task<Result<Answers>> ask(Query query) override;
  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override;
  Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) override;
  Task<Result<LeaseId>> lease(Duration length) override { return board_.lease(length); }
  Task<Result<void>> renew(LeaseId lease) override;
  Task<Result<void>> release(LeaseId lease) override { return board_.release(lease); }

 private:
  bool has(std::string_view agent, std::string_view plant) const { return agent_ == agent && plant_ == plant; }
  // What is told in place of a fact; nothing: it is not told.
  std::optional<Transaction::Tell> changed(Transaction::Tell tell);
  bool is_dropped(const Datum& fact);

  Board& board_;
  Executor& executor_;
  const std::string agent_;
  const std::string plant_;
  std::uint64_t counted_ = 0;
  Datum goal_state_;  // the newest that runs
  std::set<Datum> placed_;
  bool moves_ = false;  // by the robot agent's word
};

}  // namespace pizarra::chaos
