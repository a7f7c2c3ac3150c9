#pragma once

// Whether the camera stands where it is taken to be: every look at the gripper's mark while the arm stands still is
// compared with the arm's own word.
//
// Looks that agree make the pose surer, and correct it where it is off by more than it may be. Looks in a row that do
// not agree make it doubtful: the arm's word may be old as well. Where the arm has been elsewhere meanwhile and both
// places tell of one and the same other pose, the camera was moved. All is solved anew from there.
//
// A pose that was made from looks is known once so many places agree that a wrong one among them would not.
//
//   CameraWatch watch(believed, row);
//   if (watch.take(pair, model) == CameraWatch::News::moved) ...
//   watch.pose();                    // by which things are placed
//   watch.known();                   // well enough to work by it

#include "agents/coordinator/geometry/camera_pose.hpp"
#include "lisp/forms/cell_file.hpp"

namespace pizarra::coordinator {

struct CameraMeasured {
  forms::CameraPose pose;
  bool is_doubtful = false;  // newer looks did not agree
};

class CameraWatch {
 public:
  enum class News { nothing, found, corrected, doubtful, moved };

  // `row`: where the arm works, and things must be placed well.
  CameraWatch(const forms::BelievedCamera& guess, const forms::CubeRow& row);
  // An earlier life had measured it.
  void go_on_from(const CameraMeasured& measured);

  News take(const MarkPair& pair, const CameraModel& model);
  // The mark is not seen where it should be in view. A look that agrees ends this doubt.
  void doubt() { doubtful_ = true; }

  const forms::CameraPose& pose() const { return pose_; }
  // Nothing at all is known of it yet: what is seen has pixels, and no place.
  bool unknown() const { return unknown_; }
  bool doubtful() const { return doubtful_; }
  bool known() const { return !unknown_ && !doubtful_ && confirmed_ && spread_mm_ <= most_spread_mm; }
  // Looks at the mark that agree, one a place of the tool.
  const std::vector<MarkPair>& pairs() const { return pairs_; }
  // How far things in the row may be placed off.
  double spread_mm() const { return spread_mm_; }
  // How far the last correction or move took what stands in the row.
  double shift_mm() const { return shift_mm_; }

 private:
  static constexpr double most_spread_mm = 5;

  News take_first(const MarkPair& pair, const CameraModel& model);
  News take_agreeing(const MarkPair& pair, const CameraModel& model);
  News take_strange(const MarkPair& pair, const CameraModel& model);
  // Ends the doubt once as many places agree as disagree.
  void outvote_strange(const MarkPair& agreeing);
  std::vector<MarkPair> strange_well_seen() const;
  bool is_confirmed() const;
  bool tell_of_one_pose(const MountFit& moved) const;
  // From the pose by which things are placed now.
  void begin_anew(const Sureness& sure, std::vector<MarkPair> pairs, const CameraModel& model);
  void fit(const CameraModel& model);
  void place_by(const forms::CameraPose& pose);

  std::vector<Eigen::Vector3d> row_;  // points in which poses are compared
  MountedCamera guess_;
  Sureness sure_;
  std::vector<MarkPair> pairs_;    // that agree; one a place of the tool, the oldest first
  std::vector<MarkPair> strange_;  // that disagree, until they are outvoted; before the pose is confirmed they are kept
  std::vector<MarkPair> agreeing_;  // that agree since the first strange one
  MountFit fit_;
  forms::CameraPose pose_;
  double spread_mm_ = 0;
  double shift_mm_ = 0;
  bool unknown_ = false;
  bool doubtful_ = false;
  bool confirmed_ = false;  // by places enough that agree
};

}  // namespace pizarra::coordinator
