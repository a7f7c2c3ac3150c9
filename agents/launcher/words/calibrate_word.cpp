// `calibrate`: what a pair of cameras is, or one, from images of a chessboard.

#include <algorithm>
#include <fmt/format.h>

#include "agents/launcher/command_line/word_tools.hpp"
#include "agents/launcher/story/output_file.hpp"
#include "agents/launcher/words/board_pairs.hpp"
#include "agents/launcher/words/board_session.hpp"
#include "agents/launcher/words/words.hpp"
#include "drivers/camera/chessboard.hpp"
#include "drivers/camera/stereo_geometry.hpp"
#include "lisp/forms/cell.hpp"
#include "lisp/json.hpp"

namespace pizarra {
namespace {

// Live, the board must have moved by this part of the image's width before it is taken again.
constexpr double least_motion = 0.04;

struct CalibrateChoices {
  std::vector<std::string> images;
  std::string cell;
  std::string out;  // empty: pair.calibration, of one camera camera.calibration
  CalibrationBoard board;
  std::size_t pairs = 20;
  bool json = false;
};

class Calibration {
 public:
  Calibration(const CalibrateChoices& choices, BoardPairs& pairs) : choices_(choices), pairs_(pairs) {}

  int run() {
    while (!enough()) {
      const std::optional<Result<ImagePair>> pair = pairs_.next();
      if (!pair) break;
      const Result<void> taken = *pair ? take(**pair) : Result<void>(fail(pair->error()));
      // A live camera would go on giving what cannot be used.
      const bool wrong_size = !taken && taken.error().symbol == "wrong-size";
      if (wrong_size && pairs_.endless()) return complain_as(style(), taken.error(), exit_usage);
      tell_pair(taken);
    }
    const Result<CalibratedPair> found = calibrate_pair(views_, size_, choices_.board);
    if (!found) return complain_as(style(), found.error(), exit_failed);
    const std::string text = write_calibration(found->calibration);
    const Result<void> written = write_file(out(), {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    if (!written) return complain_as(style(), written.error(), exit_unavailable);
    tell_result(*found);
    return exit_reached;
  }

 private:
  Style style() const { return choices_.json ? Style::json : Style::text; }
  std::string out() const {
    if (!choices_.out.empty()) return choices_.out;
    return pairs_.single() ? "camera.calibration" : "pair.calibration";
  }
  bool enough() const { return pairs_.endless() && views_.size() >= choices_.pairs; }

  Result<void> take(const ImagePair& pair) {
    const cv::Size size = pair.left.size();
    if (!pair.right.empty() && pair.right.size() != size) {
      return fail("wrong-size", fmt::format("images of {}x{} and {}x{}", size.width, size.height, pair.right.cols,
                                            pair.right.rows));
    }
    if (!views_.empty() && size != size_) {
      return fail("wrong-size", fmt::format("an image of {}x{}, and those before are {}x{}", size.width, size.height,
                                            size_.width, size_.height));
    }
    Result<BoardView> view = find_board(pair.left, pair.right, choices_.board);
    if (!view) return fail(view);
    if (pairs_.endless() && !views_.empty() && !has_moved(*view)) return fail("still", "the board stands still");
    size_ = size;
    view->name = pairs_.name();
    views_.push_back(std::move(*view));
    return {};
  }

  bool has_moved(const BoardView& view) const {
    const auto far = [&](const cv::Point2f& a, const cv::Point2f& b) {
      return cv::norm(a - b) > least_motion * size_.width;
    };
    return far(view.left.front(), views_.back().left.front()) || far(view.left.back(), views_.back().left.back());
  }

  // A camera shows no board, or the same one, most of the time.
  void tell_pair(const Result<void>& taken) const {
    if (!taken && pairs_.endless()) return;
    if (choices_.json) {
      fmt::print("{{\"pair\":{},\"found\":{},\"reason\":{}}}\n", json_string(pairs_.name()), taken.has_value(),
                 taken ? "null" : json_string(taken.error().sentence));
    } else {
      fmt::print("{}: {}\n", pairs_.name(), taken ? "board found" : taken.error().sentence);
    }
    std::fflush(stdout);
  }

  void tell_result(const CalibratedPair& found) const {
    const StereoCalibration& c = found.calibration;
    const StereoModel model = StereoGeometry(c).model();
    tell_left_out(found);
    if (c.is_single()) {
      tell_lens(c, found.worst);
      return;
    }
    if (choices_.json) {
      fmt::print(
          "{{\"file\":{},\"pairs\":{},\"reprojection_px\":{:.4f},\"worst_px\":{:.4f},\"worst\":{},"
          "\"epipolar_px\":{:.4f},\"focal_px\":{:.3f},\"base_line_mm\":{:.3f}}}\n",
          json_string(out()), c.pairs, c.reprojection_px, found.worst.px, json_string(found.worst.name), c.epipolar_px,
          model.focal_px, model.base_line_mm);
      return;
    }
    fmt::print("{} pairs of {} x {}\n", c.pairs, c.width, c.height);
    fmt::print("reprojection error {:.3f} px RMS, at most {:.3f} in {}\n", c.reprojection_px, found.worst.px,
               found.worst.name);
    fmt::print("rectified, a corner's rows differ by {:.3f} px\n", c.epipolar_px);
    fmt::print("focal length {:.1f} px, base line {:.2f} mm\n", model.focal_px, model.base_line_mm);
    fmt::print("{} written; in the cell file: (camera ... (calibration \"{}\"))\n", out(), out());
  }

  void tell_left_out(const CalibratedPair& found) const {
    for (const ViewError& odd : found.left_out) {
      if (choices_.json) {
        fmt::print("{{\"left_out\":{},\"error_px\":{:.4f}}}\n", json_string(odd.name), odd.px);
      } else {
        fmt::print("{}: left out, {:.1f} px off: it does not belong to the others\n", odd.name, odd.px);
      }
    }
  }

  void tell_lens(const StereoCalibration& c, const ViewError& worst) const {
    if (choices_.json) {
      fmt::print(
          "{{\"file\":{},\"images\":{},\"reprojection_px\":{:.4f},\"worst_px\":{:.4f},\"worst\":{},"
          "\"focal_px\":{:.3f}}}\n",
          json_string(out()), c.pairs, c.reprojection_px, worst.px, json_string(worst.name), c.left.focal_x_px);
      return;
    }
    fmt::print("{} images of {} x {}\n", c.pairs, c.width, c.height);
    fmt::print("reprojection error {:.3f} px RMS, at most {:.3f} in {}\n", c.reprojection_px, worst.px, worst.name);
    fmt::print("focal length {:.1f} px across, {:.1f} down; centre {:.1f} {:.1f}; distortion k1 {:.3f}, k2 {:.3f}\n",
               c.left.focal_x_px, c.left.focal_y_px, c.left.centre_x_px, c.left.centre_y_px, c.left.distortion[0],
               c.left.distortion[1]);
    fmt::print("{} written; in the cell file: (camera (single ...) (calibration \"{}\"))\n", out(), out());
  }

  const CalibrateChoices& choices_;
  BoardPairs& pairs_;
  cv::Size size_;  // of the images with a board
  std::vector<BoardView> views_;
};

Result<std::unique_ptr<BoardPairs>> pairs_of(const CalibrateChoices& choices) {
  if (choices.cell.empty()) {
    const std::string right = choices.images.size() == 2 ? choices.images[1] : "";
    return BoardPairs::of_files(choices.images[0], right);
  }
  const Result<CellDescription> cell = read_cell_file(choices.cell);
  if (!cell) return fail(cell);
  return BoardPairs::of_cameras(cell->eyes);
}

int run_calibrate(const CalibrateChoices& choices) {
  const Style style = choices.json ? Style::json : Style::text;
  if (choices.cell.empty() == choices.images.empty()) {
    const Failure which{"no-images",
                        "say LEFT and RIGHT, where the images are (of one camera alone the one place), or --cell, "
                        "whose cameras see them",
                        {},
                        {}};
    return complain_as(style, which, exit_usage);
  }
  const Result<std::unique_ptr<BoardPairs>> pairs = pairs_of(choices);
  if (!pairs) return complain_as(style, pairs.error(), exit_usage);
  return Calibration(choices, **pairs).run();
}

}  // namespace

void add_calibrate_word(CLI::App& app, int& status) {
  auto choices = std::make_shared<CalibrateChoices>();
  CLI::App* word = app.add_subcommand("calibrate",
                                      "Find out what a pair of cameras is, or one alone, from images of a chessboard "
                                      "(`shapes --board` prints one),\n"
                                      "and keep it in a file for a cell's (camera ...).");
  word->add_option("IMAGES", choices->images,
                   "LEFT and RIGHT: folders of images, or quoted patterns; in one order. Of one camera "
                   "alone the one place")
      ->expected(1, 2)
      ->type_name("LEFT [RIGHT]");
  word->add_option("--cell", choices->cell, "Instead: what the cameras of this cell see, while the board is moved")
      ->check(CLI::ExistingFile);
  word->add_option("--out", choices->out, "The file to write; else pair.calibration, or camera.calibration");
  word->add_option("--columns", choices->board.columns, "Inner corners of the board, one way")
      ->check(CLI::Range(3, 50))
      ->capture_default_str();
  word->add_option("--rows", choices->board.rows, "And the other way")->check(CLI::Range(3, 50))->capture_default_str();
  word->add_option("--square", choices->board.square_mm, "The edge of a square, mm")
      ->check(number_check(0.1, 1000))
      ->capture_default_str();
  word->add_option("--pairs", choices->pairs, "With --cell, of a live camera: how many pairs or images to take")
      ->check(CLI::Range(5, 200))
      ->capture_default_str();
  word->add_flag("--json", choices->json, "One JSON object a line");
  word->footer(help_footer("calibrate 'left[01]*.jpg' 'right[01]*.jpg' --square 25 --out pair.calibration"));
  word->callback([choices, &status] { status = run_calibrate(*choices); });
}

}  // namespace pizarra
