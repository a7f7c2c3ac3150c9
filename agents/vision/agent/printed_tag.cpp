#include "agents/vision/agent/printed_tag.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tag_detection.hpp"
#include "agents/vision/sight/mark_learner.hpp"

namespace pizarra::vision {
namespace {

constexpr int print_cell_px = 8;
constexpr int print_cells_around = 3;
constexpr double print_focal_px = 500;
constexpr double printed_ink = 40;
constexpr double printed_paper = 220;

// The print as a photograph has it: not quite black and white, nor quite sharp.
cv::Mat1b photographed(const cv::Mat1b& print) {
  cv::Mat1b out;
  cv::resize(print, out, {}, print_cell_px, print_cell_px, cv::INTER_NEAREST);
  constexpr int around = print_cell_px * print_cells_around;
  cv::copyMakeBorder(out, out, around, around, around, around, cv::BORDER_CONSTANT, 255);
  out.convertTo(out, CV_8U, (printed_paper - printed_ink) / 255, printed_ink);
  cv::GaussianBlur(out, out, {}, 0.7);
  return out;
}

// One camera, so far away that the square has that size.
camera::StereoModel camera_before(const cv::Mat1b& image, double side_px, double side_mm) {
  return {.width = image.cols,
          .height = image.rows,
          .focal_px = print_focal_px,
          .centre_x_px = (image.cols - 1) / 2.0,
          .centre_y_px = (image.rows - 1) / 2.0,
          .base_line_mm = 0,
          .learned_at_mm = side_mm * print_focal_px / side_px};
}

}  // namespace

Result<LearnedSample> learn_print(const TaggedObject& object, const LearnedObjects& objects) {
  const TagFamily* family = family_called(object.tag.family);
  if (family == nullptr || object.tag.number < 0 || object.tag.number >= tags_of(*family)) {
    return fail("no-such-tag", fmt::format("there is no tag {}", tag_name(object.tag)), to_datum(object.name));
  }
  const cv::Mat1b print = print_of(*family, object.tag.number);
  const cv::Mat1b image = photographed(print);
  const camera::StereoModel model =
      camera_before(image, (print.cols - 2 * family->cells_around) * print_cell_px, object.side_mm);
  const cv::Mat1b nothing(image.size(), static_cast<std::uint8_t>(0));
  MarkLearner learner(object.name, {model.centre_x_px, model.centre_y_px}, objects);
  while (!learner.done()) {
    StereoSight sight(image, nothing, model);
    const Result<void> fed = learner.feed(sight);
    if (!fed) return fail(fed);
  }
  LearnedSample sample = learner.sample();
  // It was not guessed how far away it is.
  sample.size_by = LearnedSample::SizeBy::measured_face;
  return sample;
}

}  // namespace pizarra::vision
