// Outlines of drawn shapes: alike at every turn, size, slant and blur, unlike where the shape is another.

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/mark_outline.hpp"
#include "agents/vision/marks/segmentation.hpp"
#include "tests/bench/vision/unlearned.hpp"

namespace pizarra::vision {
namespace {

// So many standard deviations a lens may blur at most.
constexpr double most_blur = 0.5;

// What pixels and blur may make of one.
double alike(const MarkOutline& learned) { return 0.0003 + 0.03 * learned.power(); }

// Of a dark shape on light ground, 0.5 px a mm at scale 1.
MarkOutline outline_of_shape(const bench::Shape& shape, double scale, double turn_deg, double blur_px) {
  cv::Mat1f image(120, 120, 160.F);
  bench::paint(image, bench::placed(shape, {60.3, 59.6}, 0.5 * scale, turn_deg), 25);
  if (blur_px > 0) cv::GaussianBlur(image, image, {}, blur_px);
  cv::Mat1b grey;
  image.convertTo(grey, CV_8U);
  ImageSegmentation segmentation(grey);
  EXPECT_EQ(segmentation.marks().size(), 1U);
  return outline_of(segmentation.marks().at(0).signature);
}

MarkOutline outline_of_mark(const std::string& name, double scale = 1, double turn_deg = 0, double blur_px = 0.6) {
  return outline_of_shape(bench::mark_shape(name), scale, turn_deg, blur_px);
}

TEST(Outline, OfADiscIsRound) { EXPECT_LT(outline_of_mark("circle").power(), 0.0003); }

TEST(Outline, IsTheSameAtAnyTurnSizeAndBlur) {
  for (const std::string name : {"circle", "square", "triangle", "cross"}) {
    const MarkOutline learned = outline_of_mark(name);
    for (double turn_deg = 0; turn_deg < 90; turn_deg += 2.3) {
      for (const double scale : {0.8, 1.6}) {
        for (const double blur_px : {0.0, 1.5}) {
          const MarkOutline seen = outline_of_mark(name, scale, turn_deg, blur_px);
          EXPECT_LT(outline_difference(seen, learned, most_blur).in_all, alike(learned))
              << name << " turned by " << turn_deg << " degrees, " << scale << " as large, blurred by " << blur_px
              << " px";
        }
      }
    }
  }
}

TEST(Outline, OfAnotherShapeIsAnother) {
  const MarkOutline circle = outline_of_mark("circle");
  for (const bench::UnlearnedShape& shape : bench::unlearned_shapes()) {
    if (!shape.no_view_of_a_mark) continue;
    const MarkOutline other = outline_of_shape(shape.shape, 1, 7, 0.6);
    EXPECT_GT(outline_difference(other, circle, most_blur).in_all, 2 * alike(circle)) << shape.name;
  }
  const MarkOutline square = outline_of_mark("square");
  for (const std::string name : {"circle", "triangle", "cross"}) {
    EXPECT_GT(outline_difference(outline_of_mark(name), square, most_blur).in_all, 2 * alike(square)) << name;
  }
}

// A camera that looks at it aslant sees a square as one.
TEST(Outline, OfAParallelogramIsASquares) {
  const bench::Shape& parallelogram = bench::unlearned_shapes().back().shape;
  const MarkOutline square = outline_of_mark("square");
  EXPECT_LT(outline_difference(outline_of_shape(parallelogram, 1, 7, 0.6), square, most_blur).in_all, alike(square));
}

}  // namespace
}  // namespace pizarra::vision
