#pragma once

// How soon the arm is commanded otherwise once a frame shows its target elsewhere. The board and each agent are
// processes of their own, in real time; the world is in this one, which sees each frame, shove and command.
//
//   ReactionCell cell(60, 7);
//   const std::vector<double> reactions_s = cell.measure(100, 60s, [](std::size_t answered) { ... });
//
// The arm goes for a cube again and again, and at any instant of an approach a hand shoves it aside. A changed command
// stops the motion, rises, or ends nearer to where the cube is than to where it was.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <vector>
#include <zmq.hpp>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/time/real_executor.hpp"
#include "drivers/simulation/link_server.hpp"
#include "tests/bench/blackboard/board_process.hpp"

namespace pizarra::bench {

class ReactionCell {
 public:
  // Throws std::runtime_error where the cell does not come to life.
  ReactionCell(int frames_per_s, std::uint64_t seed);
  // From the frame that shows a shove to the first changed command, in seconds, of so many shoves; of fewer where they
  // do not come within `longest`. `tell` hears every ten seconds how many have been answered.
  std::vector<double> measure(int shoves, Duration longest, const std::function<void(std::size_t)>& tell);

 private:
  struct Shove {
    double from_mm;  // the cube's y
    double to_mm;
    Time begins;  // the first frame that shows it move
    Time shown;   // the first one that shows it astray
  };

  void await_learned();
  Task<void> follow(std::string pattern, std::function<void(const Datum&)> take);
  void take_servo(const Datum& servo);
  Task<void> want(std::string goal);
  Task<void> shove();
  Task<void> shove_now();
  Task<Result<simulation::Message>> hear(Datum request);
  bool is_changed(const Datum& command, const Shove& shove) const;
  Eigen::Vector3d end_of(const Datum& move) const;
  Time frame_after(Time time) const;

  const int frames_per_s_;
  Random random_;
  TemporaryFolder folder_;
  BoardProcess board_process_;
  std::vector<Child> agents_;
  RealExecutor executor_;
  zmq::context_t context_{1};
  simulation::WorldConfig config_;
  std::optional<simulation::World> world_;
  std::unique_ptr<simulation::LinkServer> server_;
  std::unique_ptr<client::RemoteBoard> board_;

  int goals_ = 0;
  std::int64_t state_ = 0;  // of the servo
  Eigen::Vector3d grip_mm_ = Eigen::Vector3d::Zero();
  bool is_shoving_ = false;
  std::optional<Shove> unanswered_;
  std::vector<double> reactions_s_;
  std::vector<Job> jobs_;
  Job shoving_;
  Job wanting_;
};

}  // namespace pizarra::bench
