#pragma once

// Gathers what a calibration is made of: views of a board, each from a place of its own, sorted by the images' size. A
// wrong size is known only in the end, by what most have.
//
//   BoardViews views(board, 0.01);
//   Result<void> taken = views.take(pair, "left01.jpg right01.jpg");
//   calibrate_pair(views.of_most().views, views.of_most().size, board);

#include <optional>

#include "drivers/camera/chessboard.hpp"
#include "programs/commands/board_pairs.hpp"

namespace pizarra::programs {

class BoardViews {
 public:
  struct OneSize {
    cv::Size size;
    std::vector<camera::BoardView> views;
  };

  // `least_motion`: how far a corner must be from where any view before had it, of the image's width.
  BoardViews(const camera::CalibrationBoard& board, double least_motion) : board_(board), least_motion_(least_motion) {}

  // Failures: no-board; still, where a view before shows the same; wrong-size, where a pair's images differ, or where
  // there are more sizes than cameras have.
  Result<void> take(const ImagePair& pair, const std::string& name);

  // The board in the image or pair that was given last, also where a view before shows the same; none where there is
  // none.
  const std::optional<camera::BoardView>& newest() const { return newest_; }

  // Of as many, those that came first.
  const OneSize& of_most() const;
  std::vector<const OneSize*> others() const;

 private:
  Result<OneSize*> with_size(cv::Size size);

  camera::CalibrationBoard board_;
  double least_motion_;
  std::vector<OneSize> sizes_;
  std::optional<camera::BoardView> newest_;
};

}  // namespace pizarra::programs
