#pragma once

// Where a camera stands, from what it saw of the mark that an arm carried before it; and, on a pan-tilt unit, about
// which axes that turns it, from what it saw of the mark standing still while the head turned. Solved from most of the
// looks, and checked on every fourth.
//
//   const Result<HandEyeResult> found = solve_hand_eye(guess, seen, model);
//   write_believed_camera(found->camera);                // for the cell's data
//
// Failures: mark-hidden, too-little-turning, uncertain. Each says what to do.

#include <string>

#include "agents/coordinator/geometry/camera_pose.hpp"

namespace pizarra::hand_eye {

constexpr const char* hand_mark = "end-effector";

// Pairs of looks at the mark and the arm's word, out of so many that were tried.
struct SeenPairs {
  std::vector<coordinator::MarkPair> pairs;
  std::size_t tried = 0;
};

struct HandEyeResult {
  forms::BelievedCamera camera;
  std::size_t poses = 0;      // that it is solved from
  double error_px = 0;        // root mean square over them
  std::size_t held_back = 0;  // poses that it was checked on:
  double checked_mm = 0;      // root mean square of how far the mark was placed from where the arm says it was
  struct Head {
    std::size_t angles = 0;  // of the head, that its axes are solved from
    std::size_t held_back = 0;
    double checked_mm = 0;
    double sure_mm = 0;  // standard deviations of an axis' place and direction
    double sure_deg = 0;
  };
  std::optional<Head> head;
};

// The camera stood still: its head, if it has one, in the middle.
Result<HandEyeResult> solve_hand_eye(const forms::BelievedCamera& guess, const SeenPairs& seen,
                                     const coordinator::CameraModel& model);

// The same looks again, and those with the head turned.
Result<HandEyeResult> solve_head(const HandEyeResult& unturned, const SeenPairs& seen, const SeenPairs& turned,
                                 const coordinator::CameraModel& model);

// As a file for a cell's (camera-pose ... (file ...)).
std::string write_believed_camera(const forms::BelievedCamera& camera);

}  // namespace pizarra::hand_eye
