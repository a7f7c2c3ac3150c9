#pragma once

// Cell files: what stands in a cell, and which agents run on which host.
//
//   (cell blocks
//     (world
//       (camera (at 1330 0 200) (pan 0) (tilt 0) (roll 0))     ; base-line centre mm, degrees; looks along -x
//                                                              ; with (lens -0.3 0.1) it distorts,
//                                                              ; with (size 640 480) its images are larger
//       (cube-size 60)                                         ; of every cube that does not say otherwise
//       (openings 76 84 96)                                    ; of the gripper: narrow, normal, wide
//       (row (x 450) (y -200 200))                             ; where cubes are put down
//       (cube circle (at 450 -150) (yaw 5))                    ; its mark is the shape of its name
//       (cube square (at 450 50) (size 40))                    ; smaller than the others
//       (cube lid (mark cross) (on square))                    ; a mark of its own; stacked on a cube named before
//       (cube box (mark apriltag-36h11 17) (at 450 150))       ; a tag in place of a shape
//       (brick wall (size 30 120 80) (at 300 100) (yaw 30))    ; plain, and so not known to the eyes
//       (cylinder can (size 50 70) (at 300 -100))              ; its diameter and its height
//       (lamp (at 900 -600 1200) (part 0.4))                   ; a second one, with hard shadows: part of the light
//       (background "wall.jpg") (table-picture "cloth.png") ; photographs behind the table and on it
//       (noise (sensor 3) (blur 0.7) (gradient 0.12)))         ; grey levels, px, part of the light
//     (arm crs-f3)                                             ; of arms/, or "my-arm.scm" beside the cell file;
//                                                              ; with (room (x 200 600) (z 20 700)) it stays in there
//                                                              ; with (rate 125) it tells its state so often a second
//                                                              ; with (driver hses "192.168.0.3") it is a real one;
//                                                              ; with (plugin "libmyarm.so") it has a driver of one's
//                                                              ; own (drivers/plugin/arm_plugin.hpp);
//                                                              ; with (gripper ...), gripper_setup.hpp, so is that
//     (slave crs-t265 (offset 0 0 50) (mirror))                ; a second arm, which the agent follower has follow it:
//                                                              ; mm in its own base frame, left for right; room,
//                                                              ; driver and gripper as above
//     (pan-tilt (tcp "192.168.0.2" 4000) (reversed pan))       ; or (serial "/dev/ttyUSB0" 9600); what counts leftwards
//     (objects "objects")                                      ; the folder where what the eyes learn is kept, beside
//                                                              ; the cell file; left out: on the board alone
//     (camera-pose (at 1350 0 190) (pan 2) (sure 20 2))        ; where the agents take the camera to be, and how sure
//                                                              ; that is, mm and degrees; left out: as in the world;
//                                                              ; (camera-pose unknown): nobody has measured it;
//                                                              ; (mark 30 0 -66) is the gripper's in the tool's frame;
//                                                              ; with (file "camera-pose.scm") that counts once it is
//                                                              ; there (`calibrate hand-eye` writes it)
//     (camera (pair (device 0) (device 2)) (calibration "pair.calibration"))   ; camera_setup.hpp
//     (tags (apriltag-36h11 40) (aruco-4x4-50 22.5))           ; families of tags that the eyes tell of without having
//                                                              ; been shown them, and the sides of their squares, mm
//     (tagged (box apriltag-36h11 17 48))                      ; objects that they know by their tags, without having
//                                                              ; been shown them: name, tag and its side
//     (bodies (crate (box (0 0 -30) (0 0 0)) (lid (0 -30 0) (-90 0 0))))   ; of which several faces bear such tags:
//                                                              ; where they are on it, and how they are turned there
//     (agent conveyor (scheme "conveyor.scm"))                 ; an agent of one's own (docs/scheme-agents.md); with
//                                                              ; (time 1000) (memory 64) (rate 1000) (key "FILE")
//     (door (tcp 7801) (serial "/dev/ttyUSB0" 9600) (keys "keys"))   ; of small devices (docs/small-devices.md)
//     (domain "../../domains/blocks.scm")                      ; relative to the cell file
//     (board "localhost" "tcp://127.0.0.1:7800")               ; its host and address; left out: the first host, ipc
//     (host "localhost" (agents robot vision planner coordinator person)))
//
// A board that other machines reach has keys: (board "bench" "tcp://bench:7800" (keys "keys")), the folder of those
// that may come; a host elsewhere comes with one: (host "desk" (agents planner) (key "keys/desk.secret")).
//
// Cameras on a pan-tilt unit: (camera (at 1330 0 200) (head ptu46-17.5)), and the agent pan-tilt, which turns that unit
// or, where (pan-tilt ...) names a line, the one there. A cell without either has no agent pan-tilt. Axes that do not
// meet in the camera: (head ptu46-17.5 (pan-axis (at 7 0 -41) (along 0 1 0)) (tilt-axis (at 0 54 -33) (along 1 0 0))),
// in its own frame; in (camera-pose ...) as (head (pan-axis ...) (tilt-axis ...)).
//
// Without (camera ...) outside of the world the cell's eyes are the simulated pair.
// Everything but the name has a default. A failure reports every error of the file, each with a caret.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lisp/forms/camera_pose.hpp"
#include "lisp/forms/camera_setup.hpp"
#include "lisp/forms/gripper_setup.hpp"
#include "lisp/forms/perception.hpp"
#include "lisp/reader.hpp"

namespace pizarra::forms {

struct CubePlacement {
  std::string name;
  std::string mark;  // such as circle or apriltag-36h11-17: docs/write-a-cell.md lists them
  double x_mm = 0;
  double y_mm = 0;
  double yaw_deg = 0;
  std::string on;  // the cube it stands on, empty: the table
  double edge_mm = 60;
  // Of faces with a mark of their own: front, back, right, left, top or bottom, and that mark.
  std::vector<std::pair<std::string, std::string>> faces = {};
  bool operator==(const CubePlacement&) const = default;
};

// A plain brick or cylinder in the world.
struct ThingPlacement {
  std::string name;
  bool is_round = false;
  std::array<double, 3> size_mm{};  // of a cylinder: its diameter twice, and its height
  double x_mm = 0;
  double y_mm = 0;
  double yaw_deg = 0;
};

struct CellNoise {
  double sensor_grey = 3;
  double blur_px = 0.7;
  double gradient = 0.12;
};

// A second lamp in the world, and which part of the light is its own.
struct CellLamp {
  std::array<double, 3> at_mm{};
  double part = 0;
};

// A photograph in the world.
struct CellPicture {
  std::string file;      // a path that can be opened
  std::string named_at;  // the place of the cell file, for who cannot read it
};

// How far the gripper opens around a cube: at least, as a rule, and where there is room.
struct GripperOpenings {
  double narrow_mm = 76;
  double normal_mm = 84;
  double wide_mm = 96;
};

// Where cubes are put down: middles on a line across the table.
struct CubeRow {
  double x_mm = 450;
  double y_low_mm = -200;
  double y_high_mm = 200;
};

// Where the pan-tilt agent's unit is reached, and which of its axes count the other way round.
struct PanTiltLine {
  std::string kind;   // serial, tcp, or empty: the simulated one, over the device link
  std::string where;  // a file or a host
  int number = 0;     // baud rate or port
  bool pan_reversed = false;
  bool tilt_reversed = false;
};

// How the arm's controller is reached, and its gripper's.
struct ArmLine {
  std::string protocol;             // of `protocols` in cell.scm; empty: the simulated arm, over the device link
  std::vector<std::string> places;  // hosts or files
  std::vector<int> ports;
  GripperSetup gripper;
};

// A box in the base frame, mm.
struct CellRoom {
  std::array<double, 3> low_mm;
  std::array<double, 3> high_mm;
};

// The arm of the agent `slave`, and where its grip centre is to be for a place of the first arm's.
struct CellSlave {
  std::string arm_file;
  std::optional<CellRoom> room;
  ArmLine line;
  std::array<double, 3> offset_mm;
  bool mirrored = false;  // y the other way round
  double rate_hz = 10;
};

// An agent that is a Scheme file.
struct CellSchemeAgent {
  std::string name;
  std::string file;  // a path that can be opened
  int time_ms = 1000;
  int memory_mb = 64;
  double messages_per_s = 1000;
  std::string key;  // the file of the secret with which it comes to the board, empty: its host's
};

// A family of tags as the eyes call it, and how large its dark squares are.
struct CellTags {
  std::string family;
  double side_mm = 0;
  bool operator==(const CellTags&) const = default;
};

// An object that the eyes know by its tag.
struct CellTagged {
  std::string name;
  std::string family;
  int number = 0;
  double side_mm = 0;
};

// Of which several faces bear tags: ((MARK (X Y Z) (RX RY RZ)) ...), mm and degrees.
struct CellBody {
  std::string name;
  Datum marks;
};

// The text door, on the board's host.
struct CellDoor {
  struct Line {
    std::string file;
    int baud = 0;
  };
  std::optional<int> tcp_port;  // of the loopback; 0: any that is free
  std::vector<Line> lines;
  std::string keys;  // the folder of its devices'
};

// Of what the simulated cameras see.
struct CellImageSize {
  int width_px = 320;
  int height_px = 240;
};

struct CellHost {
  std::string name;
  std::string key;  // the file of the secret with which it comes to a board elsewhere, empty: it has none
  std::vector<std::string> agents;
};

struct CellDescription {
  std::string name;
  CameraPose world_camera;  // where the simulated camera stands; while its head, if it stands on one, is in the middle
  BelievedCamera camera;
  std::string camera_pose_file;  // where a measured pose of the camera is kept, empty: nowhere
  std::string head;              // the simulated pan-tilt unit under it, empty: it stands still
  int frames_per_s = 10;         // of the simulated camera
  CellImageSize image;
  std::array<double, 5> lens{};  // its distortion, as OpenCV has it: k1, k2, p1, p2, k3
  CellNoise noise;
  std::optional<CellLamp> second_lamp;
  std::optional<CellPicture> background;     // behind the table
  std::optional<CellPicture> table_picture;  // over it
  double cube_mm = 60;                       // no cube is larger
  GripperOpenings openings;
  CubeRow row;
  std::vector<CubePlacement> cubes;
  std::vector<ThingPlacement> things;
  EdgesMm edges_mm() const;          // of its cubes
  std::string arm;                   // its name
  std::string arm_file;              // a path that can be opened
  std::optional<CellRoom> arm_room;  // where its grip centre may be; none: wherever it reaches
  ArmLine arm_line;
  double arm_rate_hz = 10;  // how often it tells its state while that changes
  std::optional<CellSlave> slave;
  PanTiltLine pan_tilt;
  CameraSetup eyes;            // of the vision agent
  std::vector<CellTags> tags;  // that it tells of unasked
  std::vector<CellTagged> tagged;
  std::vector<CellBody> bodies;
  std::string objects_directory;  // of the object database, empty: there is none
  std::string domain_file;        // a path that can be opened
  std::string board_host;
  std::string board_address;  // empty: an ipc address of the run
  std::string board_keys;     // the folder of the keys that may come, empty: none are asked for
  std::vector<CellHost> hosts;
  bool open_loop = false;  // of the coordinator, to compare with; no cell file says so
  std::vector<CellSchemeAgent> scheme_agents;
  std::optional<CellDoor> door;
};

// That of this name, or none.
const CellSchemeAgent* scheme_agent_called(const CellDescription& cell, std::string_view name);

Result<CellDescription> read_cell(std::string_view text, const std::string& file);
Result<CellDescription> read_cell_file(const std::string& path);

// Another arm in place of the cell's own: one of arms/, by its name or the last part of it (f3, t265, up6), or the path
// of an arm file. Failure: unknown-arm, with the nearest name.
Result<void> put_arm(CellDescription& cell, const std::string& arm);

// One `(cube NAME ...)` as the Scheme modules normalise it; shared with the scenario language.
CubePlacement cube_from_datum(const Datum& normalised);

}  // namespace pizarra::forms
