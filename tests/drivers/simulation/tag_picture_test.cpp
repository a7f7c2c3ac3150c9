// Cubes that wear tags, as the cameras show them.

#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/tag.hpp"
#include "agents/vision/marks/tag_detection.hpp"
#include "agents/vision/marks/tags.hpp"
#include "drivers/simulation/render/eye.hpp"
#include "lisp/numbers.hpp"
#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {
namespace {

constexpr double px_per_mm = 431.0 / 850;  // of a face in the row

std::string name_of(const vision::TagFamily& family, int number) {
  return vision::tag_name({std::string(family.name), number});
}

WorldConfig tagged_cube(const std::string& tag, double yaw_deg = 0) {
  WorldConfig config;
  config.camera.noise_sigma = 1;
  config.cubes = {{.name = "it", .mark = face_mark_from_name(tag).value(), .x_mm = 450, .yaw_deg = yaw_deg}};
  return config;
}

cv::Mat1b left_image(Bench& bench) {
  const camera::StereoFrame frame = bench.frame();
  cv::Mat1b image(frame.left->height, frame.left->width);
  std::ranges::copy(frame.left->pixels, image.begin());
  return image;
}

TEST(TagPicture, PrintsWithADarkSquareAreThoseThatTheEyesRead) {
  for (const vision::TagFamily& family : vision::tag_families()) {
    if (family.is_wide()) continue;
    const int last = vision::tags_of(family) - 1;
    for (const int number : {0, 7, last}) {
      const cv::Mat1b expected = vision::print_of(family, number);
      const std::string name = name_of(family, number);
      const std::optional<FaceMark> mark = face_mark_from_name(name);
      ASSERT_TRUE(mark) << name;
      EXPECT_EQ(face_mark_name(*mark), name);
      const TagPrint& print = *std::get<TagMark>(*mark).print;
      ASSERT_EQ(print.side, expected.cols) << name;
      for (int row = 0; row < print.side; ++row) {
        for (int column = 0; column < print.side; ++column) {
          EXPECT_EQ(print.is_light(column, row), expected(row, column) > 0) << name;
        }
      }
    }
    EXPECT_FALSE(face_mark_from_name(name_of(family, last + 1)));
  }
  for (const char* none : {"apriltag-36h11", "apriltag-36h11-", "apriltag-36h11-x", "apriltag-36h11-01",
                           "apriltag-36h11--1", "apriltag-99h9-1", "-1", ""}) {
    EXPECT_FALSE(face_mark_from_name(none)) << none;
  }
}

TEST(TagPicture, CellsAreDrawnInPerspective) {
  for (const double yaw_deg : {-40.0, -15.0, 0.0, 15.0, 40.0}) {
    WorldConfig config = tagged_cube("apriltag-36h11-17", yaw_deg);
    config.camera.model = {.width = 1280, .height = 960, .focal_px = 1724, .centre_x_px = 639.5, .centre_y_px = 479.5};
    Bench bench(config);
    const cv::Mat1b image = left_image(bench);
    const Eye eye = make_eye(config.camera, Side::left);
    const TagPrint& print = *std::get<TagMark>(config.cubes.front().mark).print;
    const Eigen::Vector3d out =
        Eigen::AngleAxisd(radians(yaw_deg), Eigen::Vector3d::UnitZ()) * Eigen::Vector3d::UnitX();
    const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(out);
    const double cell_mm = tag_part_of_edge * 60 / print.side;
    for (int row = 0; row < print.side; ++row) {
      for (int column = 0; column < print.side; ++column) {
        const double aside_mm = (column + 0.5 - print.side / 2.0) * cell_mm;
        const double up_mm = (print.side / 2.0 - row - 0.5) * cell_mm;
        const Eigen::Vector3d at(450, 0, 30 + up_mm);
        const Eigen::Vector3d seen = eye.project(at + 30 * out + aside_mm * right);
        const int level = image(cvRound(seen.y()), cvRound(seen.x()));
        EXPECT_EQ(level > 110, print.is_light(column, row)) << yaw_deg << ": " << column << " " << row;
      }
    }
  }
}

TEST(TagPicture, ATagIsReadWhereItIs) {
  for (const char* family_name : {"apriltag-16h5", "aruco-4x4-50"}) {
    const vision::TagFamily& family = *vision::family_called(family_name);
    for (int number = 0; number < 30; ++number) {
      Bench bench(tagged_cube(name_of(family, number)));
      const std::vector<vision::SeenMark> seen =
          vision::find_tags(left_image(bench), {std::string(family.name), number});
      ASSERT_EQ(seen.size(), 1U) << family_name << " " << number;
      EXPECT_NEAR(seen[0].centre.x, 159.5 + 45 * px_per_mm, 0.8) << family_name << " " << number;
      EXPECT_NEAR(seen[0].centre.y, 119.5 + 170 * px_per_mm, 0.8) << family_name << " " << number;
      const Datum told = bench.ask("(where-seen it)");
      EXPECT_NEAR(told[0].number(), 159.5 + 45 * px_per_mm, 0.5);
      EXPECT_NEAR(told[1].number(), 119.5 + 170 * px_per_mm, 0.5);
    }
  }
}

TEST(TagPicture, ACubeThatIsTurnedShowsTheMarkOfItsOtherFace) {
  WorldConfig config = tagged_cube("aruco-4x4-50-1");
  const auto face_mark = [&](CubeFace face, const char* mark) {
    config.cubes.front().faces[static_cast<std::size_t>(face)] = face_mark_from_name(mark);
  };
  face_mark(CubeFace::left, "aruco-4x4-50-2");
  face_mark(CubeFace::back, "aruco-4x4-50-3");
  face_mark(CubeFace::right, "aruco-4x4-50-4");
  Bench bench(config);
  for (const int shown : {1, 2, 3, 4}) {
    const std::vector<vision::SeenMark> seen = vision::find_tags(left_image(bench), {"aruco-4x4-50", shown});
    EXPECT_EQ(seen.size(), 1U) << "tag " << shown;
    bench.ask("(hand turn it 90)");
  }
}

}  // namespace
}  // namespace pizarra::simulation
