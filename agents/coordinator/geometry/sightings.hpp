#pragma once

// Where each object was last seen, for how many looks it has been unseen, and for how many it has lain still.
//
// A look is one `look` fact of vision. Looks are counted here and not by their frame numbers, which begin again when
// a camera is restarted.
//
//   Sightings sightings;
//   sightings.look(frame, look.seen);
//   if (sightings.recent("circle", 1)) place = sightings.find("circle")->place_mm;

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "lisp/forms/perceived_look.hpp"

namespace pizarra::coordinator {

struct Sighting {
  Eigen::Vector3d place_mm;       // of its mark, base frame
  std::int64_t frame;             // the newest it was seen in
  std::uint64_t look;             // the newest it was seen in
  Eigen::Vector3d anchor_mm;      // it has been within `still_mm` of here ...
  std::uint64_t still_since;      // ... since this look
  std::uint64_t longest_gap = 0;  // for how many looks in a row it went unseen there, at most
  int excused = 0;                // for how many looks in a row something known hid it
  std::uint64_t covered = 0;      // for so many looks in a row another object stood before it
  bool in_gripper = false;        // when it was seen last: it goes where the gripper goes
  double yaw_deg = 0;  // how far its face looks to the right of facing the camera, averaged while it is still
  int yaw_samples = 0;
};

class Sightings {
 public:
  static constexpr double still_mm = 6;

  // Takes in what one look shows. Faces are told as the camera is turned, and kept as it is mounted: its head stands
  // `pan_deg` to the right.
  void look(std::int64_t frame, std::span<const forms::SeenObject> seen, double pan_deg = 0);

  // Keeps an object that the newest look did not show as young as it was, because something known hides it; for
  // `most_excused` looks in a row, then it ages like any other.
  static constexpr int most_excused = 150;
  void excuse(const std::string& name);
  // Another object stands before one that the newest look did not show: it counts as there, as an excused one does, but
  // not as seen. The other may have come there up to `most_patience` looks ago, unseen as it fell.
  void cover(const std::string& name);
  // What is hidden now may be elsewhere: it ages from here on.
  void end_excuses();

  // The newest look shows it in the gripper.
  void hold(const std::string& name);
  // The newest look did not show it, but nothing else can have become of it: it is excused, and where it was carried.
  void carry(const std::string& name, const Eigen::Vector3d& place_mm);

  std::uint64_t looks() const { return looks_; }
  std::int64_t frame() const { return frame_; }
  const std::map<std::string, Sighting, std::less<>>& all() const { return seen_; }
  const Sighting* find(std::string_view name) const;
  // How far the face that shows its mark looks to the right of facing the camera; nothing while too few looks told.
  std::optional<double> face_deg(std::string_view name) const;
  // Whether it was seen within the last `looks` looks; 1: in the newest.
  bool recent(std::string_view name, std::uint64_t looks) const;
  // Whether it counts as there though it may be unseen: for `grace` looks. A mark that is hard to see, as at a slant,
  // counts for longer: twice the longest gap between two sights of it where it lies.
  static constexpr std::uint64_t most_patience = 60;
  bool remembered(std::string_view name, int grace) const;
  // Whether another object stood before it since it was seen.
  bool covered(std::string_view name) const;
  // For how many looks it has lain where it is.
  std::uint64_t still_looks(std::string_view name) const;

 private:
  static void face(Sighting& sighting, double yaw_deg);

  std::uint64_t looks_ = 0;
  std::int64_t frame_ = 0;
  std::map<std::string, Sighting, std::less<>> seen_;
};

}  // namespace pizarra::coordinator
