#pragma once

// A cell without physics for the coordinator's tests: a robot that is where it is told to be, eyes that project
// exactly; they answer through facts as the real agents do. The planner is the real one. The test is the hand.
//
//   FakeCell cell("blocks.scm", {{"circle", {450, -100, 30}}, {"square", {450, 0, 30}}});
//   cell.start_coordinator();
//   cell.request("coordinator", "(goal (on circle square))");
//   EXPECT_TRUE(cell.run_until("(goal-state 1 reached ?)", 60s));

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>

#include "agents/coordinator/geometry/camera_view.hpp"
#include "agents/coordinator/plan/task_domain.hpp"
#include "agents/coordinator/pursue/coordinator_agent.hpp"
#include "agents/runtime/service.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/latch.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "tests/blackboard/troubled_disk.hpp"

namespace pizarra::coordinator {

class FakeCell {
 public:
  using Cubes = std::map<std::string, Eigen::Vector3d>;  // centres, mm

  FakeCell(const std::string& domain_file, Cubes cubes);
  ~FakeCell();

  // Agents may be stopped, as if killed, and started again.
  void start_coordinator();
  void start_robot();
  void start_vision();
  void start_planner();
  void stop_coordinator();
  void stop_robot();
  void stop_vision();
  void stop_planner();
  // The board was killed and has come back with what its journal kept.
  void restart_board();
  // Somebody else's doing: tells a fact, retracts what fits.
  void tell(std::string_view fact);
  void forget(std::string_view pattern);

  // The reply's form: (ok ...) or (fail ...).
  Datum request(const std::string& agent, std::string_view operation);
  // Runs until the query has an answer; false after `patience`.
  bool run_until(std::string_view query, Duration patience);
  Time now() { return executor_.now(); }
  void run_for(Duration duration) { executor_.run_for(duration); }
  std::vector<Datum> facts(std::string_view pattern);
  // The held cube falls to the table or on another cube, and the fingers close behind it.
  void slip(double closes_to_mm = 0);
  // How often a fact that fits has been told, from the journal.
  int times_told(std::string_view pattern) const;

  Cubes cubes;                                               // where they are now; the test may move them
  std::map<std::string, double> faces_deg;                   // of those that are turned, to the right of the camera
  std::set<std::string> hidden;                              // from the eyes
  std::function<bool()> mark_hidden = [] { return false; };  // the end effector's, as a cube before it does
  std::string eyes_restart_at;  // the eyes forget what they track when they are first asked to track this one
  // Whether something stands before a cube.
  std::function<bool(const std::string& name)> covered = [](const std::string&) { return false; };
  bool tells_capture = true;               // the eyes, when their frames were captured
  Duration look_late{};                    // how long the next look is on its way to the board
  bool tells_pose = true;                  // the robot, as a fact
  Duration word_late{};                    // how long after a motion it says that it has ended, and where it is
  Eigen::Vector3d pose_error_mm{0, 0, 0};  // of the arm's own word for where it is
  forms::CameraPose camera;                // where it stands; the test may knock against it
  forms::BelievedCamera believed;          // where the coordinator takes it to be, as it starts
  double travel_mm = 300;                  // the height at which the coordinator travels, as it starts
  Eigen::Vector3d grip{370, 0, 410};       // the grip centre
  double opening_mm = 100;
  std::string held;                    // between the fingers
  double lowest_mm = 0;                // what is in the way stops the arm on its way further down,
  double jam_mm = 0;                   // and the fingers there at this opening; everywhere, where nothing is in the way
  double nearest_mm = 0;               // nearer to its foot the arm comes neither up nor inwards
  std::optional<double> stuck_mm;      // what the gripper's sensor says, however far the fingers are open
  std::string refusal;                 // the symbol with which the robot refuses to move, such as halted
  std::optional<Datum> refused_about;  // what that failure is about, in place of the operation
  int motions = 0;
  Duration motion_takes = 300ms;         // a motion that is stopped meanwhile moves nothing
  std::optional<Datum> also_stopped_by;  // a person's stop fact, together with the coordinator's own stop
  Disk disk = Disk::sound;               // of the board's journal, for what the coordinator tells

 private:
  struct Agents;
  friend struct Agents;

  bool shows(const std::string& name) const;
  Task<void> look();
  Eigen::Vector3d mark_of(const std::string& cube) const;
  Task<Result<Datum>> handle_robot(Datum operation);
  Task<Result<Datum>> handle_vision(Datum operation);
  void move_to(const Eigen::Vector3d& place);
  void push_along_y(const Eigen::Vector3d& place);
  Task<void> tell_arm(Datum state);
  Task<void> tell_pose();
  Eigen::Vector3d gripper_mark() const;
  double close_gripper(double wanted_mm);
  void let_go();
  void turn_tool(double deg);

  VirtualExecutor executor_;
  memory::MemoryBoard board_{executor_};
  std::vector<std::string> journal_;
  TaskDomain domain_;
  std::set<std::string> tracked_;
  WaitList stopped_{executor_};
  Datum stopped_by_;
  std::int64_t frame_ = 0;
  double yaw_deg_ = 0;
  int requests_ = 0;
  std::unique_ptr<Board> person_;
  std::unique_ptr<Agents> agents_;
};

}  // namespace pizarra::coordinator
