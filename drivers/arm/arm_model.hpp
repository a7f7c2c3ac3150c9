#pragma once

// An arm described as data: its build, its links and what each axis counts. Lengths mm, angles degrees. Arm files
// (arms/*.scm, drivers/arm/arm_file.hpp) are read into it.
//
//   const Result<ArmModel> arm = shipped_arm("crs-t265");
//   const std::optional<std::size_t> wrist = arm->axis_of(Role::spin);      // 4: its axis 5

#include <array>
#include <cassert>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pizarra::arm {

inline constexpr std::size_t most_axes = 8;

// What the arm's axes read, axis 1 first: degrees, and mm of axes that slide.
class Joints {
 public:
  Joints() = default;
  explicit Joints(std::size_t axes) : size_(axes) { assert(axes <= most_axes); }
  Joints(std::initializer_list<double> readings) : size_(readings.size()) {
    assert(readings.size() <= most_axes);
    std::copy(readings.begin(), readings.end(), readings_.begin());
  }

  std::size_t size() const { return size_; }
  double& operator[](std::size_t axis) { return readings_[axis]; }
  double operator[](std::size_t axis) const { return readings_[axis]; }
  double* begin() { return readings_.data(); }
  double* end() { return readings_.data() + size_; }
  const double* begin() const { return readings_.data(); }
  const double* end() const { return readings_.data() + size_; }
  bool operator==(const Joints&) const = default;

 private:
  std::array<double, most_axes> readings_{};
  std::size_t size_ = 0;
};

// How the first three axes place the wrist:
//   articulated  turn, shoulder, elbow: two links in a plane that axis 1 turns
//   polar        turn, shoulder, reach: one link that slides out
//   scara        turn, elbow, lift: two level links, the tool down
//   gantry       ahead, across, lift: three slides, the tool down
enum class Build { articulated, polar, scara, gantry };

// What an axis does; the wrist's are roll, pitch and spin, or the last two, or spin alone. A track carries the arm.
enum class Role { turn, shoulder, elbow, reach, ahead, across, lift, roll, pitch, spin, track };

std::string_view role_name(Role role);
// Whether it slides (mm) and does not turn (degrees).
bool slides(Role role);

struct Range {
  double low;
  double high;
};

// An axis reads sense * (value - zero). The value of an axis that turns is
//
//   turn, spin      anticlockwise from above, the tool down
//   shoulder        the elevation of the upper arm, or of the polar arm
//   elbow, pitch    how much what follows is raised against the link before; or its elevation, where `from_base`
//   roll            about the negative approach direction
//
// The value of one that slides is
//
//   reach           from the shoulder to the wrist centre
//   ahead, across, lift, track   along x, y, z, and where the track runs
struct Axis {
  Role role;
  Range limits;
  double speed;      // a second
  double sense = 1;  // or -1
  double zero = 0;
  bool from_base = false;      // a linkage holds it against the base: the axes before it do not turn it
  std::optional<Range> stops;  // of an axis that is counted from the base: its angle to the link before
  double pulses_per_turn = 0;  // what its controller counts in; 0: in its own unit
};

struct ArmModel {
  std::string type;
  Build build;
  double height_mm;         // of axis 2 above the table; of a scara's or a gantry's wrist at lift 0
  double offset_mm;         // of axis 2 ahead of axis 1
  double side_mm;           // by how much the links' plane lies to the left of axis 1
  double upper_arm_mm;      // a
  double forearm_mm;        // elbow to wrist centre, along the forearm ...
  double forearm_raise_mm;  // ... and across it, so that b = sqrt(forearm^2 + raise^2)
  double wrist_mm;          // wrist centre to flange, along the tool ...
  double wrist_across_mm;   // ... and across it, in the links' plane: ahead where the tool is down
  double tool_mm;           // flange to grip centre
  std::vector<Axis> axes;   // axis 1 first
  bool track_along_x;       // or along y
  Joints home;              // folded high above the table, out of the way of whatever looks at it
  Joints ready;             // where work begins, the tool down over the table

  std::optional<std::size_t> axis_of(Role role) const;
  // b: elbow to wrist centre.
  double elbow_to_wrist_mm() const;
  // By how much the line from elbow to wrist centre rises above the forearm, degrees.
  double forearm_bend_deg() const;
};

}  // namespace pizarra::arm
