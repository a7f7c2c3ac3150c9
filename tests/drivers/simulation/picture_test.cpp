#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <fmt/format.h>

#include "drivers/simulation/render/stereo_renderer.hpp"
#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {

namespace {

struct Blob {
  int area = 0;
  int border = 0;  // its pixels with a neighbour (of four) that is not dark
  double x = 0;
  double y = 0;
};

std::size_t index(const Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
}

int level(const Image& image, int x, int y) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return 255;
  return image.pixels[index(image, x, y)];
}

// The pixels darker than half of a cube's white that hang together with the one given.
Blob dark_blob(const Image& image, int x0, int y0) {
  constexpr int threshold = 110;
  Blob blob;
  std::vector<char> seen(image.pixels.size());
  std::deque<std::pair<int, int>> open{{x0, y0}};
  while (!open.empty()) {
    const auto [x, y] = open.front();
    open.pop_front();
    if (level(image, x, y) >= threshold || seen[index(image, x, y)] != 0) continue;
    seen[index(image, x, y)] = 1;
    ++blob.area;
    blob.x += x;
    blob.y += y;
    bool border = false;
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      border = border || level(image, x + dx, y + dy) >= threshold;
      open.emplace_back(x + dx, y + dy);
    }
    if (border) ++blob.border;
  }
  if (blob.area > 0) {
    blob.x /= blob.area;
    blob.y /= blob.area;
  }
  return blob;
}

WorldConfig one_cube(Mark mark) {
  WorldConfig config;
  config.cubes = {{.name = "it", .mark = mark, .x_mm = 450, .y_mm = 0}};
  return config;
}

Blob seen_from(const Image& image, Bench& bench, const char* request) {
  const Datum at = bench.ask(request);
  return dark_blob(image, static_cast<int>(std::lround(at[0].number())), static_cast<int>(std::lround(at[1].number())));
}

// The images of things that move about, painted where something changed, and painted anew.
void expect_the_same_pictures(const WorldConfig& config, const std::vector<FaceMark>& marks) {
  StereoRenderer steady(config, Random(5));
  Random random(11);
  Snapshot snapshot;
  snapshot.opening_mm = 84;
  for (const FaceMark& mark : marks)
    snapshot.cubes.push_back({Eigen::Isometry3d::Identity(), on_each_face(mark), true, cube_shape(60)});
  for (std::uint64_t frame = 1; frame <= 12; ++frame) {
    for (Snapshot::Cube& cube : snapshot.cubes) {
      if (random.below(2) == 0) continue;
      const Eigen::Vector3d axis(random.normal(), random.normal(), random.normal());
      cube.pose.linear() = Eigen::AngleAxisd(random.uniform(0, 3), axis.normalized()).toRotationMatrix();
      cube.pose.translation() =
          Eigen::Vector3d(random.uniform(300, 600), random.uniform(-300, 300), random.uniform(30, 300));
      cube.present = random.below(5) != 0;
    }
    if (random.below(2) == 0) snapshot.joints = {random.uniform(-40, 40), -30, -80, 0, -70, 0};
    if (random.below(4) == 0) snapshot.fist_mm = Eigen::Vector3d(450, random.uniform(-200, 200), 100);
    StereoRenderer fresh(config, Random(5));
    const StereoPair kept = steady.render(snapshot, config.camera, frame, frame % 3 == 0);
    const StereoPair whole = fresh.render(snapshot, config.camera, frame, frame % 3 == 0);
    EXPECT_EQ(kept.left->pixels, whole.left->pixels) << "seed 11, frame " << frame;
    EXPECT_EQ(kept.right->pixels, whole.right->pixels) << "seed 11, frame " << frame;
  }
}

}  // namespace

TEST(Picture, ACircleMeasuresWhatTheThesisPrinted) {
  Bench bench(one_cube(Mark::circle));
  const camera::StereoFrame frame = bench.frame();
  ASSERT_EQ(frame.left->width, 320);
  ASSERT_EQ(frame.left->height, 240);
  const Blob blob = seen_from(*frame.left, bench, "(where-seen it)");
  EXPECT_NEAR(blob.area, 390, 15);
  EXPECT_NEAR(blob.border, 60, 4);
}

TEST(Picture, MarksAreWhereTheGeometrySays) {
  for (const std::string_view name : mark_names()) {
    const Mark mark = mark_from_name(name).value();
    Bench bench(one_cube(mark));
    const camera::StereoFrame frame = bench.frame();
    const Blob left = seen_from(*frame.left, bench, "(where-seen it)");
    // The face is 850 ahead; the left eye stands 45 to the left of the mark, the right one 45 to its right.
    const double aside = 431 * 45.0 / 850;
    EXPECT_NEAR(left.x, 159.5 + aside, 0.4) << mark_name(mark);
    EXPECT_NEAR(left.y, 119.5 + 431 * 170.0 / 850, 0.4) << mark_name(mark);
    const Blob right = dark_blob(*frame.right, static_cast<int>(std::lround(left.x - 2 * aside)),
                                 static_cast<int>(std::lround(left.y)));
    EXPECT_NEAR(left.x - right.x, 2 * aside, 0.5) << mark_name(mark);
    EXPECT_NEAR(left.area, right.area, 25) << mark_name(mark);
  }
}

TEST(Picture, MarksHaveTheirShapesAreas) {
  const double px_per_mm = 431.0 / 850;
  const auto area = [&](Mark mark) {
    Bench bench(one_cube(mark));
    const camera::StereoFrame frame = bench.frame();
    return seen_from(*frame.left, bench, "(where-seen it)").area / (px_per_mm * px_per_mm);
  };
  EXPECT_NEAR(area(Mark::square), 44 * 44, 60);
  EXPECT_NEAR(area(Mark::cross), 2 * 44 * 14.7 - 14.7 * 14.7, 60);
  EXPECT_NEAR(area(Mark::triangle), 44 * 37 / 2.0, 60);
}

TEST(Picture, FramesComeEveryTenthOfASecondOnTheDot) {
  Bench bench(four_cubes());
  camera::StereoFrame last;
  for (int i = 0; i < 5; ++i) {
    const Result<camera::StereoFrame> frame = run(bench.executor, bench.eyes.next(last.captured, false));
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->captured.time_since_epoch() % 100ms, 0us);
    EXPECT_EQ(frame->captured, bench.executor.now());
    if (last.number != 0) {
      EXPECT_EQ(frame->number, last.number + 1);
    }
    last = *frame;
  }
  bench.wait(350ms);
  const Result<camera::StereoFrame> late = run(bench.executor, bench.eyes.next(last.captured, false));
  ASSERT_TRUE(late);
  EXPECT_EQ(late->number, last.number + 4);
  // A time by another clock does not make it wait for ever.
  const Time never = bench.executor.now() + 1000s;
  const Result<camera::StereoFrame> stale = run(bench.executor, bench.eyes.next(never, false));
  ASSERT_TRUE(stale);
  EXPECT_LE(stale->number, last.number + 6);
}

TEST(Picture, ColourAndGreyShowTheSame) {
  Bench bench(four_cubes());
  const camera::StereoFrame grey = bench.frame(false);
  const camera::StereoFrame colour = bench.frame(true);
  ASSERT_EQ(colour.left->channels, 3);
  double difference = 0;
  for (std::size_t i = 0; i < grey.left->pixels.size(); ++i) {
    const std::uint8_t* bgr = colour.left->pixels.data() + 3 * i;
    difference += std::abs(0.114 * bgr[0] + 0.587 * bgr[1] + 0.299 * bgr[2] - grey.left->pixels[i]);
  }
  EXPECT_LT(difference / static_cast<double>(grey.left->pixels.size()), 4);
}

TEST(Picture, NoiseHasTheSigmaAskedFor) {
  Bench bench(four_cubes());
  const camera::StereoFrame a = bench.frame();
  const camera::StereoFrame b = bench.frame();
  ASSERT_NE(a.number, b.number);
  double sum = 0;
  for (std::size_t i = 0; i < a.left->pixels.size(); ++i) {
    sum += std::pow(static_cast<double>(a.left->pixels[i]) - b.left->pixels[i], 2);
  }
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(a.left->pixels.size()) / 2), 3, 0.15);
}

TEST(Picture, DrawingOnlyWhatChangedGivesTheWholePicture) {
  expect_the_same_pictures(four_cubes(), {Mark::circle, Mark::square, Mark::cross, Mark::triangle});
}

TEST(Picture, DrawingOnlyWhatChangedGivesTheWholePictureOfTagsAndHardShadows) {
  WorldConfig config = four_cubes();
  config.second_lamp = LampConfig{.at_mm = {1200, 800, 1000}, .part = 0.5};
  const FaceMark tag = face_mark_from_name("aruco-4x4-50-3").value();
  const FaceMark other_tag = face_mark_from_name("apriltag-36h11-17").value();
  expect_the_same_pictures(config, {Mark::circle, tag, Mark::star, other_tag});
}

TEST(Picture, DrawingOnlyWhatChangedGivesTheWholePictureThroughALens) {
  WorldConfig config = four_cubes();
  config.camera.lens = {-0.3, 0.08, 0.001, -0.002, 0.01};
  config.table_picture = std::make_shared<const Photograph>(Image{2, 1, 3, {20, 40, 60, 220, 200, 180}});
  expect_the_same_pictures(config, {Mark::circle, Mark::square, Mark::cross, Mark::triangle});
}

TEST(Picture, APairCostsLittle) {
  Bench bench(four_cubes());
  bench.frame();
  arm::Joints aside = bench.config.arm.ready;
  aside[0] = 60;
  ASSERT_TRUE(run(bench.executor, bench.arm.start_move({aside, bench.config.arm.ready}, 0.05)));
  constexpr int frames = 50;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < frames; ++i) bench.frame();
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  fmt::print("a grey pair with the arm moving, physics included: {:.2f} ms\n", took.count() / frames);
  EXPECT_LT(took.count() / frames, 100);
}

}  // namespace pizarra::simulation
