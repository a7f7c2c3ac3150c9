#include "drivers/camera/fit_deviations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

namespace pizarra::camera {
namespace {

// The order of what is fitted: of each camera fx fy cx cy k1 k2 p1 p2, then how the right one is turned and where it
// is. A board's place is its turn and where it is.
constexpr int lens_values = 8;
constexpr int place_values = 6;
constexpr int turn_values = 3;

struct Camera {
  cv::Matx33d matrix;
  cv::Vec<double, 5> distortion;
};

Camera camera_of(const LensModel& lens) {
  return {{lens.focal_x_px, 0, lens.centre_x_px, 0, lens.focal_y_px, lens.centre_y_px, 0, 0, 1},
          cv::Vec<double, 5>(lens.distortion.data())};
}

struct Place {
  cv::Vec3d turn;
  cv::Vec3d at;
};

// How a camera's corners move with the board's place before it, and with its lens.
struct Moves {
  cv::Mat1d with_turn;
  cv::Mat1d with_place;
  cv::Mat1d with_lens;
};

Moves moves_of(const Camera& camera, const Place& board, const std::vector<cv::Point3f>& corners) {
  std::vector<cv::Point2f> unused;
  cv::Mat all;
  cv::projectPoints(corners, board.turn, board.at, camera.matrix, camera.distortion, unused, all);
  return {all.colRange(0, turn_values), all.colRange(turn_values, place_values),
          all.colRange(place_values, place_values + lens_values)};
}

// The normal matrix of what all views share. Each view's own, the board's place, is taken out as it comes.
class SharedNormal {
 public:
  explicit SharedNormal(int values) : matrix_(cv::Mat1d::zeros(values, values)) {}

  void add(const cv::Mat1d& with_shared, const cv::Mat1d& with_own) {
    const cv::Mat1d cross = with_own.t() * with_shared;
    cv::Mat1d fixed;
    cv::solve(with_own.t() * with_own, cross, fixed, cv::DECOMP_SVD);
    matrix_ += with_shared.t() * with_shared - cross.t() * fixed;
    corners_ += with_shared.rows;
    own_ += with_own.cols;
  }

  // Empty where something is left open.
  cv::Mat1d covariance(double reprojection_px) const {
    const int spare = corners_ - own_ - matrix_.rows;
    if (spare <= 0) return {};
    // In units of their own: focal lengths are hundreds, distortions hundredths.
    cv::Mat1d scale(matrix_.size(), 0.0);
    for (int i = 0; i < matrix_.rows; ++i) {
      if (matrix_(i, i) <= 0) return {};
      scale(i, i) = 1 / std::sqrt(matrix_(i, i));
    }
    cv::Mat1d inverse;
    if (cv::invert(scale * matrix_ * scale, inverse, cv::DECOMP_CHOLESKY) == 0) return {};
    const double variance = reprojection_px * reprojection_px / 2 * corners_ / spare;
    return variance * scale * inverse * scale;
  }

 private:
  cv::Mat1d matrix_;
  int corners_ = 0;  // coordinates of corners
  int own_ = 0;
};

double deviation(double variance) {
  return variance >= 0 && std::isfinite(variance) ? std::sqrt(variance) : std::numeric_limits<double>::infinity();
}

class Fitted {
 public:
  explicit Fitted(const StereoCalibration& calibration)
      : calibration_(calibration), left_(camera_of(calibration.left)), right_(camera_of(calibration.right)) {
    between_.at = cv::Vec3d(calibration.translation_mm.data());
    cv::Rodrigues(cv::Matx33d(calibration.rotation.data()), between_.turn);
  }

  CalibrationDeviations deviations(const std::vector<BoardView>& views) const {
    const bool single = calibration_.is_single();
    SharedNormal normal(single ? lens_values : 2 * lens_values + place_values);
    for (const BoardView& view : views) single ? add_single(normal, view) : add_pair(normal, view);
    const cv::Mat1d covariance = normal.covariance(calibration_.reprojection_px);
    if (covariance.empty()) {
      constexpr double open = std::numeric_limits<double>::infinity();
      return {open, open, single ? 0 : open};
    }
    CalibrationDeviations out = lens_deviations(covariance, 0);
    if (single) return out;
    const CalibrationDeviations right = lens_deviations(covariance, lens_values);
    out.focal_px = std::max(out.focal_px, right.focal_px);
    out.centre_px = std::max(out.centre_px, right.centre_px);
    out.base_line_mm = base_line_deviation(covariance);
    return out;
  }

 private:
  Place place_of(const BoardView& view, const std::vector<cv::Point3f>& corners) const {
    Place board;
    cv::solvePnP(corners, view.left, left_.matrix, left_.distortion, board.turn, board.at);
    return board;
  }

  void add_single(SharedNormal& normal, const BoardView& view) const {
    const std::vector<cv::Point3f> corners = corners_of(view, calibration_.board);
    const Moves moves = moves_of(left_, place_of(view, corners), corners);
    cv::Mat1d own;
    cv::hconcat(moves.with_turn, moves.with_place, own);
    normal.add(moves.with_lens, own);
  }

  void add_pair(SharedNormal& normal, const BoardView& view) const {
    const std::vector<cv::Point3f> corners = corners_of(view, calibration_.board);
    const Place board = place_of(view, corners);
    const Moves left = moves_of(left_, board, corners);
    Place seen;
    cv::Mat1d turn_by_turn, turn_by_at, turn_by_camera_turn, turn_by_camera_at;
    cv::Mat1d at_by_turn, at_by_at, at_by_camera_turn, at_by_camera_at;
    cv::composeRT(board.turn, board.at, between_.turn, between_.at, seen.turn, seen.at, turn_by_turn, turn_by_at,
                  turn_by_camera_turn, turn_by_camera_at, at_by_turn, at_by_at, at_by_camera_turn, at_by_camera_at);
    const Moves right = moves_of(right_, seen, corners);
    const int rows = right.with_lens.rows;
    cv::Mat1d shared(2 * rows, 2 * lens_values + place_values, 0.0);
    cv::Mat1d own(2 * rows, place_values);
    const auto put = [rows](cv::Mat1d& into, int side, int column, const cv::Mat1d& what) {
      what.copyTo(into(cv::Rect(column, side * rows, what.cols, rows)));
    };
    put(shared, 0, 0, left.with_lens);
    put(shared, 1, lens_values, right.with_lens);
    put(shared, 1, 2 * lens_values, right.with_turn * turn_by_camera_turn + right.with_place * at_by_camera_turn);
    put(shared, 1, 2 * lens_values + turn_values,
        right.with_turn * turn_by_camera_at + right.with_place * at_by_camera_at);
    put(own, 0, 0, left.with_turn);
    put(own, 0, turn_values, left.with_place);
    put(own, 1, 0, right.with_turn * turn_by_turn + right.with_place * at_by_turn);
    put(own, 1, turn_values, right.with_turn * turn_by_at + right.with_place * at_by_at);
    normal.add(shared, own);
  }

  static CalibrationDeviations lens_deviations(const cv::Mat1d& covariance, int first) {
    const auto of = [&](int value) { return deviation(covariance(first + value, first + value)); };
    return {std::max(of(0), of(1)), std::max(of(2), of(3)), 0};
  }

  double base_line_deviation(const cv::Mat1d& covariance) const {
    const int first = 2 * lens_values + turn_values;
    const cv::Mat1d along(cv::normalize(between_.at));
    const cv::Mat1d of_place = covariance(cv::Rect(first, first, 3, 3));
    return deviation(cv::Mat1d(along.t() * of_place * along)(0, 0));
  }

  const StereoCalibration& calibration_;
  Camera left_;
  Camera right_;
  Place between_;
};

}  // namespace

CalibrationDeviations deviations_of(const StereoCalibration& calibration, const std::vector<BoardView>& views) {
  return Fitted(calibration).deviations(views);
}

}  // namespace pizarra::camera
