#include <algorithm>
#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "blackboard/time/random.hpp"
#include "drivers/camera/chessboard.hpp"
#include "drivers/camera/stereo_geometry.hpp"
#include "tests/campaign.hpp"
#include "tests/drivers/camera/board_scene.hpp"
#include "tests/scratch.hpp"

namespace pizarra::camera {
namespace {

// What a calibration of the drawn scene should be.
StereoCalibration truth(const BoardScene& scene) {
  const auto lens = [&](const cv::Matx33d& camera) {
    LensModel out{camera(0, 0), camera(1, 1), camera(0, 2), camera(1, 2), {}};
    std::copy_n(scene.distortion.val, 5, out.distortion.begin());
    return out;
  };
  StereoCalibration out{.width = scene.size.width,
                        .height = scene.size.height,
                        .left = lens(scene.left),
                        .right = lens(scene.right),
                        .board = scene.board,
                        .pairs = 14,
                        .reprojection_px = 0.1,
                        .epipolar_px = 0.05,
                        .deviations = {0.5, 0.8, 0.07}};
  std::copy_n(scene.between.rotation().val, 9, out.rotation.begin());
  std::copy_n(scene.between.translation().val, 3, out.translation_mm.begin());
  return out;
}

const BoardScene& scene() {
  static const BoardScene drawn;
  return drawn;
}

TEST(Calibration, FindsTheCamerasThatDrewTheBoards) {
  std::vector<BoardView> views;
  for (const cv::Affine3d& pose : board_poses()) {
    const Result<BoardView> view = find_board(scene().draw(pose, false), scene().draw(pose, true), scene().board);
    ASSERT_TRUE(view) << view.error().sentence;
    views.push_back(*view);
  }
  const Result<CalibratedPair> pair = calibrate_pair(views, scene().size, scene().board);
  ASSERT_TRUE(pair) << pair.error().sentence;
  const StereoCalibration& c = pair->calibration;
  EXPECT_NEAR(c.left.focal_x_px, scene().left(0, 0), 2);
  EXPECT_NEAR(c.right.focal_x_px, scene().right(0, 0), 2);
  EXPECT_NEAR(c.left.centre_x_px, scene().left(0, 2), 3);
  EXPECT_NEAR(c.left.distortion[0], scene().distortion(0), 0.02);
  EXPECT_NEAR(c.translation_mm[0], scene().between.translation()[0], 0.5);
  EXPECT_LT(c.reprojection_px, 0.15);
  EXPECT_LT(c.epipolar_px, 0.15);
  EXPECT_TRUE(pair->left_out.empty());
}

TEST(Calibration, TellsWhereARectifiedPointIsInTheImageThatWasTaken) {
  const StereoGeometry geometry(truth(scene()));
  for (const StereoGeometry::Side side : {StereoGeometry::Side::left, StereoGeometry::Side::right}) {
    for (const cv::Point2d& taken : {cv::Point2d(20, 15), cv::Point2d(160, 120), cv::Point2d(300, 200)}) {
      const cv::Point2d rectified = geometry.rectified(taken, side);
      EXPECT_GT(cv::norm(rectified - taken), 0.1);
      EXPECT_LT(cv::norm(geometry.as_taken(rectified, side) - taken), 0.01);
    }
  }
}

TEST(Calibration, RectifiedImagesShowTheBoardInTheSameRowsAndAtItsDistance) {
  const StereoGeometry geometry(truth(scene()));
  const cv::Affine3d pose(cv::Vec3d(0, 0.2, 0.05), cv::Vec3d(-80, -60, 700));
  const cv::Mat left = geometry.rectified(scene().draw(pose, false), StereoGeometry::Side::left);
  const cv::Mat right = geometry.rectified(scene().draw(pose, true), StereoGeometry::Side::right);
  const Result<BoardView> view = find_board(left, right, scene().board);
  ASSERT_TRUE(view) << view.error().sentence;
  const StereoModel& model = geometry.model();
  double worst_row_px = 0;
  double worst_mm = 0;
  for (std::size_t i = 0; i < view->left.size(); ++i) {
    worst_row_px = std::max<double>(worst_row_px, std::abs(view->left[i].y - view->right[i].y));
    const double depth = model.focal_px * model.base_line_mm / (view->left[i].x - view->right[i].x);
    // The rectified pair looks along a direction of its own: distances from the left camera stay.
    const cv::Vec3d seen((view->left[i].x - model.centre_x_px) * depth / model.focal_px,
                         (view->left[i].y - model.centre_y_px) * depth / model.focal_px, depth);
    const cv::Vec3d corner = pose * scene().corner(i);
    worst_mm = std::max(worst_mm, std::abs(cv::norm(seen) - cv::norm(corner)));
  }
  EXPECT_LT(worst_row_px, 0.5);
  EXPECT_LT(worst_mm, 7) << "1 % of 0.7 m";
}

TEST(Calibration, OneCameraIsFoundByWhatItAloneSees) {
  std::vector<BoardView> views;
  for (const cv::Affine3d& pose : board_poses()) {
    const Result<BoardView> view = find_board(scene().draw(pose, false), {}, scene().board);
    ASSERT_TRUE(view) << view.error().sentence;
    views.push_back(*view);
  }
  const Result<CalibratedPair> found = calibrate_single(views, scene().size, scene().board);
  ASSERT_TRUE(found) << found.error().sentence;
  const StereoCalibration& c = found->calibration;
  EXPECT_NEAR(c.left.focal_x_px, scene().left(0, 0), 2);
  EXPECT_NEAR(c.left.distortion[0], scene().distortion(0), 0.02);
  EXPECT_LT(c.reprojection_px, 0.15);
  EXPECT_TRUE(found->left_out.empty());
  const Result<StereoCalibration> read = read_calibration(write_calibration(c), "camera.calibration");
  ASSERT_TRUE(read) << read.error().sentence << "\n" << read.error().place;
  EXPECT_TRUE(read->is_single());
  EXPECT_NEAR(read->left.focal_x_px, c.left.focal_x_px, 1e-3);
  EXPECT_EQ(read->pairs, c.pairs);
}

TEST(Calibration, OneCamerasImagesAreStraightenedAndItsModelIsTheirs) {
  StereoCalibration lens = truth(scene());
  lens.translation_mm = {};
  const forms::CameraSetup setup{.arrangement = forms::CameraSetup::Arrangement::single, .learned_at_mm = 600};
  const StereoGeometry geometry = StereoGeometry::make(setup, lens, scene().size).value();
  const StereoModel& model = geometry.model();
  EXPECT_TRUE(model.is_single());
  EXPECT_EQ(model.learned_at_mm, 600);
  const cv::Affine3d pose(cv::Vec3d(0, 0.2, 0.05), cv::Vec3d(-80, -60, 700));
  const cv::Mat seen = geometry.rectified(scene().draw(pose, false), StereoGeometry::Side::left);
  const Result<BoardView> view = find_board(seen, {}, scene().board);
  ASSERT_TRUE(view) << view.error().sentence;
  double worst_px = 0;
  for (std::size_t i = 0; i < view->left.size(); ++i) {
    const cv::Vec3d corner = pose * scene().corner(i);
    const cv::Point2d expected(model.centre_x_px + model.focal_px * corner[0] / corner[2],
                               model.centre_y_px + model.focal_px * corner[1] / corner[2]);
    worst_px = std::max(worst_px, cv::norm(cv::Point2d(view->left[i]) - expected));
  }
  EXPECT_LT(worst_px, 0.5) << "where a camera without distortion would see it";
}

TEST(Calibration, APairsFileIsNoneOfOneCameraNorTheOtherWayRound) {
  StereoCalibration lens = truth(scene());
  const forms::CameraSetup one{.arrangement = forms::CameraSetup::Arrangement::single, .calibration_file = "c"};
  EXPECT_EQ(StereoGeometry::make(one, lens, scene().size).error().sentence,
            "c is of a pair of cameras, and the cell has one");
  lens.translation_mm = {};
  const forms::CameraSetup two{.arrangement = forms::CameraSetup::Arrangement::pair, .calibration_file = "c"};
  EXPECT_EQ(StereoGeometry::make(two, lens, scene().size).error().sentence,
            "c is of one camera, and the cell has a pair");
}

TEST(Calibration, AFileOfItReadsBackAsItWas) {
  const Result<StereoCalibration> read = read_calibration(write_calibration(truth(scene())), "pair.calibration");
  ASSERT_TRUE(read) << read.error().sentence << "\n" << read.error().place;
  EXPECT_EQ(read->width, truth(scene()).width);
  EXPECT_NEAR(read->left.focal_x_px, truth(scene()).left.focal_x_px, 1e-3);
  EXPECT_NEAR(read->right.distortion[1], truth(scene()).right.distortion[1], 1e-6);
  EXPECT_NEAR(read->rotation[2], truth(scene()).rotation[2], 1e-8);
  EXPECT_NEAR(read->translation_mm[0], truth(scene()).translation_mm[0], 1e-3);
  EXPECT_EQ(read->pairs, truth(scene()).pairs);
  EXPECT_EQ(read->deviations.focal_px, 0.5);
  EXPECT_EQ(read->deviations.base_line_mm, 0.07);
  const StereoModel as_found = StereoGeometry(truth(scene())).model();
  const StereoModel as_read = StereoGeometry(*read).model();
  EXPECT_NEAR(as_found.focal_px, as_read.focal_px, 0.01);
  EXPECT_NEAR(as_found.base_line_mm, as_read.base_line_mm, 0.01);
  EXPECT_NEAR(as_read.deviations.focal_px / as_read.focal_px, 0.5 / 400, 1e-5);
  EXPECT_EQ(as_read.deviations.base_line_mm, 0.07);
}

TEST(Calibration, AFaultInAFileIsShownWhereItStands) {
  std::string text = write_calibration(truth(scene()));
  text.replace(text.find("(focal "), 7, "(fokal ");
  const Result<StereoCalibration> read = read_calibration(text, "pair.calibration");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().sentence.find("fokal"), std::string::npos) << read.error().sentence;
  EXPECT_NE(read.error().place.find("pair.calibration:4:"), std::string::npos) << read.error().place;
}

TEST(Calibration, ALensThatIsNoneIsShownWhereItStands) {
  std::string text = write_calibration(truth(scene()));
  text.replace(text.find("(focal 400.0000 401.0000)"), 25, "(focal 1 1)");
  const Result<StereoCalibration> read = read_calibration(text, "pair.calibration");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().sentence.find("the focal lengths are between 60.0 and 9600 px"), std::string::npos)
      << read.error().sentence;
  EXPECT_NE(read.error().place.find("pair.calibration:4:"), std::string::npos) << read.error().place;
}

TEST(Calibration, ImagesWithoutABoardAreNamed) {
  const cv::Mat board = scene().draw(board_poses().front(), false);
  const cv::Mat1b nothing(scene().size, 128);
  EXPECT_EQ(find_board(board, nothing, scene().board).error().sentence,
            "no board of 9 x 6 inner corners in the right image");
  EXPECT_EQ(find_board(nothing, board, scene().board).error().sentence,
            "no board of 9 x 6 inner corners in the left image");
  EXPECT_EQ(find_board(nothing, nothing, scene().board).error().sentence,
            "no board of 9 x 6 inner corners in either image");
}

TEST(Calibration, TooFewViewsAreRefused) {
  const std::vector<BoardView> views(least_views - 1);
  const Failure pairs = calibrate_pair(views, scene().size, scene().board).error();
  EXPECT_EQ(pairs.symbol, "too-few");
  EXPECT_NE(pairs.sentence.find("at least 5 pairs"), std::string::npos) << pairs.sentence;
  const Failure images = calibrate_single({}, {}, scene().board).error();
  EXPECT_NE(images.sentence.find("at least 5 images"), std::string::npos) << images.sentence;
}

// The board's corners in each camera's image at these places; corners are found to `noise_px`.
std::vector<BoardView> views_of(const std::vector<cv::Affine3d>& poses, double noise_px) {
  std::vector<cv::Point3d> corners;
  for (int i = 0; i < scene().board.columns * scene().board.rows; ++i) {
    corners.emplace_back(scene().corner(static_cast<std::size_t>(i)));
  }
  std::vector<BoardView> views;
  cv::RNG random(5);
  for (const cv::Affine3d& pose : poses) {
    const auto seen = [&](const cv::Affine3d& from, const cv::Matx33d& camera) {
      std::vector<cv::Point2d> points;
      cv::projectPoints(corners, from.rvec(), from.translation(), camera, scene().distortion, points);
      for (cv::Point2d& p : points) p += cv::Point2d(random.gaussian(noise_px), random.gaussian(noise_px));
      return std::vector<cv::Point2f>(points.begin(), points.end());
    };
    views.push_back({seen(pose, scene().left), seen(scene().between * pose, scene().right),
                     "pair " + std::to_string(views.size() + 1)});
  }
  return views;
}

std::vector<BoardView> exact_views() { return views_of(board_poses(), 0); }

// Places as people choose them who do not tilt the board.
std::vector<cv::Affine3d> poses_tilted_by(double most_deg) {
  cv::RNG random(1);
  const double most = most_deg * CV_PI / 180;
  std::vector<cv::Affine3d> out;
  for (int i = 0; i < 12; ++i) {
    const cv::Vec3d turn(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-0.1, 0.1));
    out.emplace_back(turn, cv::Vec3d(random.uniform(-160., -40.), random.uniform(-120., 0.), 450 + 150 * (i % 3)));
  }
  return out;
}

// As one camera's images too.
void expect_uncertain(std::vector<BoardView> views, const std::string& why) {
  const Result<CalibratedPair> pair = calibrate_pair(views, scene().size, scene().board);
  ASSERT_FALSE(pair) << "focal length " << pair->calibration.left.focal_x_px;
  EXPECT_EQ(pair.error().symbol, "uncertain") << pair.error().sentence;
  EXPECT_NE(pair.error().sentence.find(why), std::string::npos) << pair.error().sentence;
  for (BoardView& view : views) view.right.clear();
  const Result<CalibratedPair> lens = calibrate_single(views, scene().size, scene().board);
  ASSERT_FALSE(lens) << "focal length " << lens->calibration.left.focal_x_px;
  EXPECT_EQ(lens.error().symbol, "uncertain") << lens.error().sentence;
}

TEST(Calibration, BoardsThatAreNotTiltedLeaveItOpenAndAreRefused) {
  expect_uncertain(views_of(poses_tilted_by(2), 0.1), "at more angles");
  expect_uncertain(views_of(poses_tilted_by(4), 0.1), "at more angles");
}

TEST(Calibration, TheSamePlaceOverAndOverTellsNoMore) {
  for (const std::size_t place : {0, 3, 7}) {
    SCOPED_TRACE(place);
    expect_uncertain(views_of(std::vector(8, board_poses()[place]), 0.1), "tilted by 0 degrees to one another");
  }
}

TEST(Calibration, CornersThatAreNotWellFoundLeaveTheFocalLengthOpen) {
  std::vector<cv::Affine3d> poses = poses_tilted_by(11);
  poses.resize(6);
  expect_uncertain(views_of(poses, 0.35), "leave the focal length open");
}

TEST(Calibration, WhatItFindsIsAsFarOffAsItSays) {
  int beyond = 0;
  const std::vector<cv::Affine3d> poses = board_poses();
  for (std::size_t first = 0; first < 7; ++first) {
    const std::vector<cv::Affine3d> some(poses.begin() + static_cast<std::ptrdiff_t>(first),
                                         poses.begin() + static_cast<std::ptrdiff_t>(first) + 8);
    const StereoCalibration c = calibrate_pair(views_of(some, 0.3), scene().size, scene().board).value().calibration;
    EXPECT_GT(c.deviations.focal_px, 0.1);
    EXPECT_LT(c.deviations.focal_px, 4);
    EXPECT_LT(c.deviations.base_line_mm, 1);
    const double base_line_mm = cv::norm(cv::Vec3d(c.translation_mm.data()));
    const double true_mm = cv::norm(scene().between.translation());
    beyond += std::abs(c.left.focal_x_px - scene().left(0, 0)) > 2 * c.deviations.focal_px;
    beyond += std::abs(c.left.centre_x_px - scene().left(0, 2)) > 2 * c.deviations.centre_px;
    beyond += std::abs(base_line_mm - true_mm) > 2 * c.deviations.base_line_mm;
  }
  EXPECT_LE(beyond, 4) << "of 21: one of twenty is more than two deviations off, and these have boards in common";
}

// How far off the range of a point is that the calibrated pair sees, as a part of it; nothing where it does not.
std::optional<double> range_error(const StereoGeometry& geometry, const cv::Vec3d& point) {
  const auto seen = [&](const cv::Affine3d& from, const cv::Matx33d& camera) {
    std::vector<cv::Point2d> out;
    cv::projectPoints(std::vector{cv::Point3d(point)}, from.rvec(), from.translation(), camera, scene().distortion,
                      out);
    return out.front();
  };
  const cv::Point2d left = seen(cv::Affine3d(), scene().left);
  const cv::Point2d right = seen(scene().between, scene().right);
  const cv::Rect2d image({0, 0}, cv::Size2d(scene().size));
  if (!image.contains(left) || !image.contains(right)) return std::nullopt;
  const cv::Point2d at = geometry.rectified(left, StereoGeometry::Side::left);
  const StereoModel& model = geometry.model();
  const double disparity = at.x - geometry.rectified(right, StereoGeometry::Side::right).x;
  const double mm_per_px = model.base_line_mm / disparity;
  const cv::Vec3d told((at.x - model.centre_x_px) * mm_per_px, (at.y - model.centre_y_px) * mm_per_px,
                       model.focal_px * mm_per_px);
  return cv::norm(told) / cv::norm(point) - 1;
}

// Other boards each time, and points as near and as far as cubes are.
TEST(Calibration, WhatItLeavesOpenIsHowFarRangesAreOff) {
  int within_two = 0;
  int seen = 0;
  double squares = 0;
  const int calibrations = campaign(6, 16);
  for (int seed = 1; seed <= calibrations; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    std::vector<cv::Affine3d> poses;
    for (int i = 0; i < 12; ++i) {
      const auto turn = [&] { return random.uniform(-0.4, 0.4); };
      poses.emplace_back(cv::Vec3d(turn(), turn(), turn() / 2),
                         cv::Vec3d(random.uniform(-190, 0), random.uniform(-110, -20), random.uniform(480, 760)));
    }
    const Result<CalibratedPair> pair = calibrate_pair(views_of(poses, 0.25), scene().size, scene().board);
    if (!pair) continue;
    const StereoGeometry geometry(pair->calibration);
    const StereoModel& model = geometry.model();
    for (int i = 0; i < 40; ++i) {
      const double depth = random.uniform(350, 1200);
      const cv::Vec3d point(random.uniform(-0.3, 0.4) * depth, random.uniform(-0.3, 0.3) * depth, depth);
      const std::optional<double> error = range_error(geometry, point);
      if (!error) continue;
      const double disparity = model.focal_px * model.base_line_mm / depth;
      const double off = *error / cv::norm(cv::Vec3d(model.deviations.focal_px / model.focal_px,
                                                     model.deviations.base_line_mm / model.base_line_mm,
                                                     model.deviations.disparity_px / disparity));
      within_two += std::abs(off) < 2 ? 1 : 0;
      squares += off * off;
      ++seen;
    }
  }
  ASSERT_GT(seen, 19 * calibrations);
  EXPECT_GE(within_two, 0.9 * seen);
  EXPECT_GT(std::sqrt(squares / seen), 0.4) << "told to be worse than it is";
}

// As if both cameras had been turned by a quarter.
std::vector<cv::Point2f> turned(const std::vector<cv::Point2f>& corners) {
  std::vector<cv::Point2f> out;
  for (const cv::Point2f& corner : corners)
    out.emplace_back(static_cast<float>(scene().size.height) - corner.y, corner.x);
  return out;
}

TEST(Calibration, CamerasOneAboveTheOtherAreToldSoEitherWayRound) {
  std::vector<BoardView> views = exact_views();
  for (BoardView& view : views) view = {turned(view.left), turned(view.right), view.name};
  const cv::Size size(scene().size.height, scene().size.width);
  const Failure below = calibrate_pair(views, size, scene().board).error();
  EXPECT_EQ(below.symbol, "turned");
  EXPECT_NE(below.sentence.find("turn the images of both by a quarter, counterclockwise"), std::string::npos)
      << below.sentence;
  for (BoardView& view : views) std::swap(view.left, view.right);
  const Failure above = calibrate_pair(views, size, scene().board).error();
  EXPECT_EQ(above.symbol, "turned");
  EXPECT_NE(
      above.sentence.find("stands above the left one, not beside it: turn the images of both by a quarter, clock"),
      std::string::npos)
      << above.sentence;
}

TEST(Calibration, WhatItDoesIsToldStepByStep) {
  std::vector<std::string> steps;
  const auto tell = [&](const std::string& step) { steps.push_back(step); };
  ASSERT_TRUE(calibrate_pair(exact_views(), scene().size, scene().board, tell));
  EXPECT_EQ(steps,
            (std::vector<std::string>{"fitting the left camera to 14 boards", "fitting the right camera to 14 boards",
                                      "fitting both cameras to 14 boards"}));
}

TEST(Calibration, SwappedCamerasAreToldSo) {
  std::vector<BoardView> views = exact_views();
  for (BoardView& view : views) std::swap(view.left, view.right);
  EXPECT_EQ(calibrate_pair(views, scene().size, scene().board).error().symbol, "swapped");
}

TEST(Calibration, ImagesThatDoNotBelongTogetherAreRefused) {
  const std::vector<BoardView> views = exact_views();
  std::vector<BoardView> shifted = views;
  for (std::size_t i = 0; i < views.size(); ++i) shifted[i].right = views[(i + 1) % views.size()].right;
  const Result<CalibratedPair> off_by_one = calibrate_pair(shifted, scene().size, scene().board);
  ASSERT_FALSE(off_by_one);
  EXPECT_EQ(off_by_one.error().symbol, "misfit");
  EXPECT_NE(off_by_one.error().sentence.find("of each pair belong together"), std::string::npos);

  // A board that was bent, or another one: the left camera alone cannot have seen it.
  std::vector<BoardView> bent = views;
  for (BoardView& view : bent) std::swap(view.left[0], view.left[30]);
  EXPECT_NE(calibrate_pair(bent, scene().size, scene().board).error().sentence.find("no left camera"),
            std::string::npos);
}

TEST(Calibration, TwoTimesTheSameImagesAreToldSo) {
  std::vector<BoardView> views = exact_views();
  for (BoardView& view : views) view.right = view.left;
  const Result<CalibratedPair> found = calibrate_pair(views, scene().size, scene().board);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().symbol, "one-camera");
  EXPECT_NE(found.error().sentence.find("both are the same camera's images"), std::string::npos);
}

std::vector<cv::Point2f> moved(std::vector<cv::Point2f> corners, cv::Point2f by) {
  for (cv::Point2f& corner : corners) corner += by;
  return corners;
}

// As a picture that was cropped and brought back to its size.
std::vector<cv::Point2f> zoomed(std::vector<cv::Point2f> corners, float by) {
  const cv::Point2f middle(static_cast<float>(scene().size.width) / 2, static_cast<float>(scene().size.height) / 2);
  for (cv::Point2f& corner : corners) corner = middle + by * (corner - middle);
  return corners;
}

// That the views named are left out and the cameras found as they are.
void expect_found_without(const std::vector<std::string>& odd, const std::vector<BoardView>& views) {
  const Result<CalibratedPair> pair = calibrate_pair(views, scene().size, scene().board);
  ASSERT_TRUE(pair) << pair.error().sentence;
  std::vector<std::string> left_out;
  for (const ViewError& view : pair->left_out) left_out.push_back(view.name);
  std::ranges::sort(left_out);
  EXPECT_EQ(left_out, odd);
  EXPECT_EQ(pair->calibration.pairs, static_cast<int>(views.size() - odd.size()));
  EXPECT_NEAR(pair->calibration.right.focal_x_px, scene().right(0, 0), 1);
  EXPECT_NEAR(pair->calibration.translation_mm[0], scene().between.translation()[0], 0.5);
}

TEST(Calibration, OfSomePairsThatDoNotBelongItLeavesOutThose) {
  const std::vector<BoardView> sound = exact_views();
  std::vector<BoardView> views = sound;
  views[4].right = sound[9].right;
  expect_found_without({"pair 5"}, views);
  for (const cv::Point2f by : {cv::Point2f(12, 8), cv::Point2f(20, 0), cv::Point2f(0, 5), cv::Point2f(-6, 0)}) {
    SCOPED_TRACE(by);
    views[4].right = moved(sound[4].right, by);
    expect_found_without({"pair 5"}, views);
  }
  views = sound;
  for (const std::size_t odd : {1, 5, 8}) views[odd].right = zoomed(sound[odd].right, 1.1F);
  expect_found_without({"pair 2", "pair 6", "pair 9"}, views);
}

TEST(Calibration, WhatIsNoBetterWithoutSomeIsRefused) {
  std::vector<BoardView> views = exact_views();
  for (std::size_t i = 0; i < views.size(); i += 2) views[i].right = zoomed(views[i].right, 1.1F);
  const Result<CalibratedPair> found = calibrate_pair(views, scene().size, scene().board);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().symbol, "misfit");
  EXPECT_NE(found.error().sentence.find("farthest off is pair "), std::string::npos) << found.error().sentence;
}

TEST(Calibration, ImagesOfAnotherSizeCannotBeRectified) {
  const std::string file = scratch_folder() + "other.calibration";
  const forms::CameraSetup setup{.arrangement = forms::CameraSetup::Arrangement::pair, .calibration_file = file};
  const StereoCalibration calibration = truth(scene());
  EXPECT_TRUE(StereoGeometry::make(setup, calibration, scene().size));
  const Result<StereoGeometry> geometry = StereoGeometry::make(setup, calibration, {320, 240});
  ASSERT_FALSE(geometry);
  EXPECT_EQ(geometry.error().symbol, "wrong-size");
  EXPECT_EQ(geometry.error().sentence, "the camera's images are 320x240, and " + file + " is of 480x360");
}

}  // namespace
}  // namespace pizarra::camera
