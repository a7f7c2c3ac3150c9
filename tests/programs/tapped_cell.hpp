#pragma once

// A cell like LocalCell's, in which a test hears everything: the journal, what each agent reads and tells, and what it
// asks of the world by the device link. Only the person is given the cell file's cubes, so the world may hold more than
// anybody was told of.
//
//   TappedCell cell(description, world_config(description, 7).value(), 7);
//   ASSERT_TRUE(cell.build({read("(on circle triangle)")}));
//   cell.journal(); cell.taps().at("vision").asked;

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "agents/launcher/agent_factory.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/simulation/world.hpp"
#include "tests/programs/board_tap.hpp"

namespace pizarra::programs {

// Hands on every call and keeps what was asked and answered.
class Tap : public simulation::Link {
 public:
  explicit Tap(simulation::Link& link) : link_(link) {}
  Task<Result<simulation::Message>> call(Datum request, Duration timeout) override;

  std::vector<Datum> asked;
  std::vector<Datum> answered;  // without the images

 private:
  simulation::Link& link_;
};

// Lets the board come to (person done ...), gives the goal as a visitor would, and runs until it is reached. Failures:
// timeout, and the coordinator's refusal.
Result<void> teach_and_build(VirtualExecutor& executor, memory::MemoryBoard& board, std::vector<Datum> goal);

class TappedCell {
 public:
  // The configuration passed check().
  TappedCell(const forms::CellDescription& description, const simulation::WorldConfig& config, std::uint64_t seed);
  ~TappedCell();

  // As teach_and_build().
  Result<void> build(std::vector<Datum> goal) { return teach_and_build(executor_, board_, std::move(goal)); }
  const std::string& journal() const { return journal_; }
  const std::map<std::string, std::unique_ptr<Tap>>& taps() const { return taps_; }
  const std::map<std::string, std::unique_ptr<BoardTap>>& boards() const { return boards_; }
  // As the agent tells it, or an empty list.
  Datum contract_of(const std::string& agent);
  // The world's answer to a question of the judge, or an empty list.
  Datum ask_world(Datum question);

 private:
  VirtualExecutor executor_;
  memory::MemoryBoard board_{executor_};
  LocalStreams streams_;
  simulation::World world_;
  simulation::LocalLink link_{world_};
  std::string journal_;
  std::map<std::string, std::unique_ptr<Tap>> taps_;
  std::map<std::string, std::unique_ptr<BoardTap>> boards_;
  std::vector<std::unique_ptr<launcher::BuiltAgent>> agents_;
  std::vector<Job> jobs_;
};

}  // namespace pizarra::programs
