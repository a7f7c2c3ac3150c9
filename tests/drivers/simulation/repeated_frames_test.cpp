// A line that gives a camera's frame once more: it is no new one.

#include <gtest/gtest.h>

#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {
namespace {

// Each frame comes so many times before the next one does.
class RepeatingLine : public Link {
 public:
  RepeatingLine(World& world, int times) : line_(world), times_(times) {}
  Task<Result<Message>> call(Datum request, Duration timeout) override {
    const bool is_frame = request.size() > 1 && request[1].is_symbol("next");
    if (!is_frame) co_return co_await line_.call(std::move(request), timeout);
    if (given_ == 0 || given_ == times_) {
      last_ = co_await line_.call(std::move(request), timeout);
      given_ = 0;
    }
    ++given_;
    co_return last_;
  }

 private:
  LocalLink line_;
  const int times_;
  int given_ = 0;
  Result<Message> last_;
};

class RepeatedFrames : public testing::Test {
 protected:
  Result<camera::StereoFrame> next(SimulatedCamera& eyes) {
    Result<camera::StereoFrame> frame = run(bench_.executor, eyes.next(after_, false));
    if (frame) after_ = frame->captured;
    return frame;
  }
  Bench bench_{four_cubes()};
  Time after_{};
};

TEST_F(RepeatedFrames, AreGivenOnceAndNeverAsTakenLater) {
  RepeatingLine line(bench_.world, 2);
  SimulatedCamera eyes(bench_.executor, line);
  ASSERT_TRUE(run(bench_.executor, eyes.open()));
  std::uint64_t before = 0;
  for (int i = 0; i < 5; ++i) {
    const Result<camera::StereoFrame> frame = next(eyes);
    ASSERT_TRUE(frame) << frame.error().sentence;
    EXPECT_GT(frame->number, before);
    before = frame->number;
  }
}

TEST_F(RepeatedFrames, ThatNeverEndAreASilentCamera) {
  constexpr int without_end = 1'000'000;
  RepeatingLine line(bench_.world, without_end);
  SimulatedCamera eyes(bench_.executor, line);
  ASSERT_TRUE(run(bench_.executor, eyes.open()));
  EXPECT_TRUE(next(eyes));
  const Result<camera::StereoFrame> repeated = next(eyes);
  ASSERT_FALSE(repeated);
  EXPECT_EQ(repeated.error().symbol, "disconnected");
}

TEST_F(RepeatedFrames, AreNewAgainOnceTheCameraIsOpenedAnew) {
  constexpr int without_end = 1'000'000;
  RepeatingLine line(bench_.world, without_end);
  SimulatedCamera eyes(bench_.executor, line);
  ASSERT_TRUE(run(bench_.executor, eyes.open()));
  EXPECT_TRUE(next(eyes));
  ASSERT_TRUE(run(bench_.executor, eyes.open()));
  EXPECT_TRUE(next(eyes));
}

}  // namespace
}  // namespace pizarra::simulation
