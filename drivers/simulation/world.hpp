#pragma once

// The simulated cell: table, cubes, arm, gripper, cameras and a person's hand, reached by requests alone.
//
// It steps lazily: every request first advances the physics (fixed 240 Hz) to the executor's time, so a world that
// nobody asks costs nothing. Each frame is taken a whole number of steps after the one before. The same seed
// and the same requests at the same times give the same answers, byte for byte.
//
//   VirtualExecutor executor;
//   World world(executor, config);                // config passed check()
//   LocalLink link(world);
//   SimulatedArm arm(link);                       // ArmDriver
//   SimulatedCamera eyes(executor, link);         // StereoCamera
//
// These are the requests and the values that they answer. Lengths are mm, angles degrees.
//
// The arm:
//
//   (arm identify) -> ("type")        (arm take-control)     (arm release-control)
//   (arm move SPEED (J1 ... JN) ...)  (arm stop)
//   (arm gripper MM)                  (arm read) -> ((J1 ... JN) MOVING STOPPED OPENING GRIPPER-MOVING AT)
// AT: when it was so, in microseconds of the world's clock. Devices of other programs may leave it out.
//
// A second arm, where there is one, answers the same to (second-arm ...). It stands aside, at a table without cubes.
//
// The cameras; a bump is for stories, and no driver asks for one:
//
//   (camera open) -> (WIDTH HEIGHT FOCAL CX CY BASE-LINE), and (... K1 K2 P1 P2 K3) of lenses that bend the images
//   (camera next AFTER grey|colour) -> (NUMBER MICROSECONDS), left and right image; waits for the frame
//   (camera bump DX DY DZ DPAN DTILT DROLL)    somebody knocks against it
//
// The pan-tilt unit under them; a nudge is for stories too:
//
//   (head send "bytes")               to the unit, as over its line
//   (head hear) -> ("bytes")          what it says next, waiting 50 ms at most; empty where it says nothing
//   (head power on|off)               its power switch
//   (head nudge DPAN DTILT)           somebody turns it by hand so far, which its motors do not count
//
// The hand; each answers when the hand is done (0.5 to 4 s), and fails `busy` meanwhile. It moves a cube over the
// table:
//
//   (hand push NAME DX DY)            slides it over the table in 0.5 s
//   (hand slide NAME DX DY SPEED)     the same at SPEED mm/s from beginning to end
//
// It lifts a cube, and puts it down or keeps it:
//
//   (hand place NAME X Y)             puts it down there, straight
//   (hand stack NAME ON)              puts it on another cube
//   (hand turn NAME DEG)              turns it where it is, anticlockwise from above, 180 either way
//   (hand hold NAME X Y Z S)          holds it there, in the way, for S seconds, 60 at most, and puts it back
//
// It takes cubes, brings them, and strikes them:
//
//   (hand steal NAME)                 pulls it away towards the camera, out of the gripper too
//   (hand remove NAME)                lifts it out of the scene
//   (hand add NAME "mark" X Y)        puts down a new cube, or one that is gone (its mark stays)
//   (hand knock NAME)                 strikes it from the side, at its height
//
// Clumsy fingers, for stories and benches; each answers at once:
//
//   (fingers slip)                    what they hold slips out now; fails `not-held` where they hold nothing
//   (fingers slips CHANCE DRAWS S)    slips at random, from the next grasp on
//   (fingers misplace PART)           what is put down lies off by up to PART of the cube's edge, uniformly
//
// With `slips` a carry has DRAWS draws. Each slips with this chance, at a uniform instant of the S seconds after the
// grasp.
//
// Truth is for the judge, the hand, the scripted person and pages of the console alone. Pixels are those of
// straightened images:
//
//   (scene) -> ((table X-LOW X-HIGH Y-LOW Y-HIGH) (camera X Y Z PAN TILT ROLL) (cube NAME "mark") ...)
//   (truth) -> ((cube NAME X Y Z YAW TILT STATE VISIBLE) ... (thing NAME X Y Z YAW TILT STATE) ...
//               (facts (on A B) (on-table A) (clear A) (holding A) (arm-empty)))
//   (where-seen NAME) -> (X Y)        left image pixel of its mark's centre; `not-seen` when over half is hidden
//
// STATE is table, (on B), held, carried (by the hand), loose or gone. VISIBLE is the part of its mark, 0..1, that both
// cameras see. `where-seen` also takes the name end-effector.
//
// Names are symbols or strings and compared without case. Failures: unknown-object, busy, not-in-control, joint-limit,
// not-finite, bad-request, not-seen.

#include "blackboard/time/executor.hpp"
#include "drivers/simulation/link.hpp"
#include "drivers/simulation/world_config.hpp"

namespace pizarra::simulation {

class World {
 public:
  World(Executor& executor, const WorldConfig& config);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  // Any number of calls may run at once; they end before the world does.
  Task<Result<Message>> handle(Datum request);

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace pizarra::simulation
