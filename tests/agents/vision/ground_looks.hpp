#pragma once

// The first look at a mark: on plain ground or on a card, whole or with something over a part of it, before a pair of
// cameras and before the left one alone. How sure FIND and the first frames of TRACK are of it, and how far off, is
// counted.
//
//   GroundLooks looks("triangle", seed);
//   looks.vary();
//   looks.put_cover(90, 5, 60, {});             // straight, from below, its edge 5 px from the mark's centre
//   looks.look();
//   looks.by_one.wrong;                         // positions told as sure, and more than a pixel off

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/vision/outline.hpp"

namespace pizarra::vision {

struct ToldAtFirst {
  static constexpr double surely = 0.9;
  static constexpr double off_px = 1;

  int told = 0;
  int sure = 0;
  int wrong = 0;  // of those that are sure, more than off_px off
  double most_off_px = 0;

  void count(double confidence, double off);
};

class GroundLooks {
 public:
  // Of mark_shape(), "rectangle", "light triangle" or "tag". It is learned from the front.
  GroundLooks(std::string of, std::uint64_t seed);

  // Another place, size, turn, light and noise as a lab may have, on plain ground.
  void vary();
  // What lies over the mark from that side: straight, or round.
  void put_cover(double from_deg, double edge_px, double level, std::optional<double> radius_px);
  // It reaches so far around the mark, turned as it; around the card it is as light as `level`.
  struct Margins {
    double left, right, up, down;
  };
  void put_card(const Margins& margins, double level);
  void look();

  // Of the ground that the mark's own edges are beside.
  double own_ground() const { return name == "light triangle" ? plate_level : ground; }

  // Of a look: by FIND, and in the first frames of TRACK.
  static constexpr int answers = 4;
  // As large it is learned.
  static constexpr double learned_px = 36;

  Random random;
  const std::string name;
  double size_px = learned_px;
  double turn_deg = 0;
  double ground = 170;
  double light_slope = 0;  // the share of light lost over the image's width
  double noise = 2;
  double blur_px = 0.7;
  ToldAtFirst by_pair;
  ToldAtFirst by_one;          // of marks as large as they were learned, and larger ones
  ToldAtFirst by_one_farther;  // of smaller ones

 private:
  static constexpr double plate_level = 40;
  static constexpr double mark_level = 25;

  double disparity_px() const;
  bench::Shape drawn_shape();
  LearnedObjects learned(const camera::StereoModel& by);
  cv::Mat1b draw(bool to_the_right);
  void find(StereoSight& sight, const LearnedObjects& objects, ToldAtFirst& told) const;
  void count(const TrackSighting& sighting, ToldAtFirst& told) const;

  const bench::Shape shape_;
  cv::Point2d centre_{100, 66};
  bench::Shape card_ = {};
  bench::Shape cover_ = {};
  double around_card_ = 0;
  double cover_level_ = 0;
  double cover_nearer_px_ = 0;
  const camera::StereoModel model_{
      .width = 176, .height = 132, .focal_px = 420, .centre_x_px = 87.5, .centre_y_px = 65.5, .base_line_mm = 40};
  const camera::StereoModel alone_;
  const LearnedObjects to_pair_;
  const LearnedObjects to_one_;
};

}  // namespace pizarra::vision
