// In which size a page is sent pictures over lines of all kinds.

#include "agents/console/picture_size.hpp"

#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace pizarra::console {
namespace {

// What a scene takes as a picture.
struct Scene {
  std::size_t light;
  std::size_t full;
};

// Two streams of ten pictures a second over a line that carries so much, one picture after the other; each also waits
// for the page and the console, now and then for long.
class Watching {
 public:
  explicit Watching(double bytes_a_second, double busy_ms = 4) : bytes_a_second_(bytes_a_second), busy_ms_(busy_ms) {}

  void watch(const Scene& scene, int seconds) {
    full_ = 0;
    changes_ = 0;
    for (int frame = 0; frame < 10 * seconds; ++frame) {
      now_ += 100ms;
      for (int stream = 0; stream < 2; ++stream) send(scene);
    }
    pictures_ = 20 * seconds;
  }
  int changes() const { return changes_; }
  double full_part() const { return static_cast<double>(full_) / pictures_; }

 private:
  // Those of a line that is so far behind are replaced by newer ones before they are sent.
  void send(const Scene& scene) {
    if (free_ > now_ + 400ms) return;
    const bool light = size_.is_light();
    full_ += light ? 0 : 1;
    const std::size_t bytes = light ? scene.light : scene.full;
    const Duration takes(static_cast<std::int64_t>(1e6 * static_cast<double>(bytes) / bytes_a_second_));
    free_ = std::max(free_, now_) + takes;
    size_.note({now_, bytes, light ? estimate(scene) : bytes, free_ - now_ + busy()});
    changes_ += size_.is_light() == light ? 0 : 1;
  }
  static std::size_t estimate(const Scene& scene) { return scene.full * 3 / 2; }
  Duration busy() {
    const double ms = std::exponential_distribution<double>(1 / busy_ms_)(random_);
    return Duration(static_cast<std::int64_t>(1000 * ms));
  }

  const double bytes_a_second_;
  const double busy_ms_;
  std::mt19937_64 random_{7};
  PictureSize size_;
  Time now_{};
  Time free_{};
  int pictures_ = 0;
  int full_ = 0;
  int changes_ = 0;
};

// From a wall to a table full of things.
const std::vector<Scene> scenes{{800, 2500},    {1500, 4000},   {3000, 9000},  {3150, 35'000},
                                {4700, 12'000}, {5500, 20'000}, {8000, 60'000}};

double needed(const Scene& scene) { return 20 * static_cast<double>(scene.full); }

TEST(SizeOfPictures, IsLightWhereTheLineCarriesNoFullOnes) {
  for (const double line : {30e3, 60e3, 125e3, 250e3, 500e3, 1e6}) {
    for (const Scene& scene : scenes) {
      if (needed(scene) < line) continue;
      Watching page(line);
      page.watch(scene, 300);
      EXPECT_LE(page.full_part(), 0.06) << line << " bytes/s, " << scene.full << " bytes a picture";
      EXPECT_LE(page.changes(), 10) << line << " bytes/s, " << scene.full << " bytes a picture";
    }
  }
}

TEST(SizeOfPictures, IsFullWhereTheLineCarriesThemWithEase) {
  for (const double line : {250e3, 500e3, 1e6, 10e6, 100e6}) {
    for (const Scene& scene : scenes) {
      if (4 * needed(scene) > line) continue;
      Watching page(line);
      page.watch(scene, 60);
      EXPECT_GE(page.full_part(), 0.9) << line << " bytes/s, " << scene.full << " bytes a picture";
    }
  }
}

// The line of the bench, 2 Mbit/s: a light picture of the second scene hardly waits.
TEST(SizeOfPictures, DoesNotBecomeFullBecauseALightPictureOfASimplerSceneHardlyWaits) {
  Watching page(250e3);
  page.watch({4700, 12'000}, 30);
  EXPECT_EQ(page.full_part(), 0);
  page.watch({2400, 9000}, 120);
  EXPECT_EQ(page.full_part(), 0);
}

TEST(SizeOfPictures, BecomesLightWhereTheSceneBecomesTooMuchForTheLine) {
  Watching page(500e3);
  page.watch({1500, 4000}, 30);
  EXPECT_GE(page.full_part(), 0.8);
  page.watch({8000, 60'000}, 30);
  EXPECT_LE(page.full_part(), 0.1);
  EXPECT_EQ(page.changes(), 1);
}

TEST(SizeOfPictures, IsLightForAPageThatIsSlowByItself) {
  Watching page(10e6, 60);
  page.watch({4700, 12'000}, 60);
  EXPECT_LE(page.full_part(), 0.1);
}

}  // namespace
}  // namespace pizarra::console
