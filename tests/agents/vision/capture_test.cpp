// The camera behind the agent: when it is open, what of it is sent, and what is said when it is lost.

#include <algorithm>
#include <fmt/format.h>
#include <span>

#include "agents/vision/agent/camera_feed.hpp"
#include "tests/agents/vision/vision_life.hpp"
#include "tests/run_task.hpp"

namespace pizarra::vision {
namespace {

// Has a newer frame whenever it is asked, so many of them.
class CameraThatIsAhead : public camera::StereoCamera {
 public:
  static constexpr std::uint64_t frames = 50;

  Task<Result<camera::StereoModel>> open() override { co_return model_; }
  Task<Result<camera::StereoFrame>> next(Time after, bool) override {
    if (number_ >= frames) co_return fail("disconnected", "that was all");
    camera::StereoFrame frame = draw_scene({}, model_, ++number_, random_);
    frame.captured = after + Duration(1);
    co_return frame;
  }

 private:
  camera::StereoModel model_;
  Random random_{1};
  std::uint64_t number_ = 0;
};

TEST(CameraFeed, LeavesTimeForOthersWhereFramesComeFasterThanTheyAreLookedAt) {
  VirtualExecutor executor;
  CameraThatIsAhead camera;
  CameraFeed feed(
      executor, camera, [](camera::StereoFrame) -> Task<void> { co_return; }, []() -> Task<void> { co_return; });
  feed.start();
  std::uint64_t seen_by_others = CameraThatIsAhead::frames;
  executor.post([&] { seen_by_others = feed.frame_number(); });
  executor.run_for(100ms);
  EXPECT_LT(seen_by_others, 3U);
  EXPECT_EQ(feed.frame_number(), CameraThatIsAhead::frames);
  feed.abandon();
}

// Is there, and none of its images can be read.
class CameraOfDamage : public camera::StereoCamera {
 public:
  explicit CameraOfDamage(Executor& executor) : executor_(executor) {}

  Task<Result<camera::StereoModel>> open() override { co_return camera::StereoModel(); }
  Task<Result<camera::StereoFrame>> next(Time, bool) override {
    while (true) {
      co_await sleep(executor_, 500ms);
      drops_.why_corrupt = fmt::format("shots/{}.png ends too early", ++drops_.corrupt);
    }
  }
  camera::CameraDrops drops() const override { return drops_; }

 private:
  Executor& executor_;
  camera::CameraDrops drops_;
};

TEST(CameraFeed, WhoWaitsForAnImageIsToldWhyThoseThatCameCannotBeRead) {
  VirtualExecutor executor;
  CameraOfDamage camera(executor);
  CameraFeed feed(
      executor, camera, [](camera::StereoFrame) -> Task<void> { co_return; }, []() -> Task<void> { co_return; });
  feed.start();
  const Result<camera::StereoFrame> frame = run(executor, feed.next(executor.now(), 3200ms));
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().sentence, "the camera's images cannot be read: shots/6.png ends too early");
  feed.abandon();
}

TEST_F(Vision, DisconnectedItCapturesOnlyWhileItMust) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  run_for(300ms);
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
  EXPECT_EQ(facts("(camera-state vision ? ?)"), "(camera-state vision closed \"\")");
  EXPECT_EQ(call("(connect)"), "()");
  run_for(300ms);
  EXPECT_EQ(facts("(camera-state vision ? ?)"), "(camera-state vision open \"\")");
  EXPECT_EQ(facts("(camera-model vision ? ? ? ? ? ?)"), "(camera-model vision 320 240 431.0 159.5 119.5 90.0)");
  EXPECT_EQ(call("(disconnect)"), "()");
  EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision idle no)");
}

TEST_F(Vision, ImagesOfASizeThatDoesNotWorkAreRefusedWithTheSizesThatDo) {
  camera.plugged = false;
  run_for(1s);
  camera.resize(60, 60);
  camera.plugged = true;
  call("(connect)");
  run_for(6s);
  EXPECT_EQ(facts("(camera-state vision ? ?)"),
            "(camera-state vision lost \"the camera's images are 60x60, and what works is 64x64 to 8192x8192\")");
}

TEST_F(Vision, WhatIsLeftOutOfAnOpenCamerasImagesIsCountedAndWhyIsSaid) {
  EXPECT_EQ(call("(connect)"), "()");
  run_for(300ms);
  camera.dropped = {.corrupt = 3, .why_corrupt = "shots/7.png: it ends too early"};
  run_for(3s);
  EXPECT_EQ(facts("(camera-state vision ? ?)"), "(camera-state vision open \"shots/7.png: it ends too early\")");
  EXPECT_EQ(facts("(camera-drops vision ? ? ?)"), "(camera-drops vision 0 0 3)");
}

TEST_F(Vision, ALostCameraIsSaidAndTriedAgain) {
  EXPECT_EQ(call("(connect)"), "()");
  run_for(300ms);
  camera.plugged = false;
  run_for(5s);
  EXPECT_TRUE(facts("(camera-state vision ? ?)").starts_with("(camera-state vision lost \"the camera is unplugged"));
  EXPECT_LT(camera.opened, 9);
  EXPECT_EQ(call("(learn 100 100 \"circle\")"), R"x((LEARN "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? ? ?)").find("unplugged"), std::string::npos);
  camera.plugged = true;
  run_for(6s);
  EXPECT_EQ(facts("(camera-state vision ? ?)"), "(camera-state vision open \"\")");
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
}

TEST_F(Vision, ALostCameraLeavesNoOldPositionsAndTrackingGoesOnWhenItIsBack) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(300ms);
  EXPECT_NE(says(), "nothing");
  camera.plugged = false;
  run_for(300ms);
  EXPECT_EQ(says(), "nothing");
  camera.plugged = true;
  run_for(2s);
  EXPECT_TRUE(says().starts_with(R"x((TRACK 1 ("circle" OK ()x")) << says();
}

// While somebody watches what is being filled, too.
TEST_F(Vision, ALearningFailsWhenTheCameraComesBackWithImagesOfAnotherSize) {
  const auto watching = streams.subscribe("vision-annotated", [](const StreamFrame&) {});
  for (const int frames : {5, 15}) {
    SCOPED_TRACE(frames);
    std::string learned;
    const Job learning = executor.spawn(ask("vision", form(learn_request(0, "circle")), 20s, learned));
    run_for(frames * 100ms);
    EXPECT_EQ(facts("(vision-mode vision ? ?)"), "(vision-mode vision learning no)");
    camera.plugged = false;
    run_for(300ms);
    camera.resize(camera.model().width + 80, camera.model().height + 60);
    camera.plugged = true;
    executor.run_until([&] { return learning.done(); });
    EXPECT_EQ(learned, R"x((LEARN "circle" FAIL))x");
    EXPECT_EQ(facts("(vision-failed vision ? ? wrong-size ?)").find("(vision-failed"), 0U);
  }
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
}

// A mark that is smaller there would pass for a covered one.
TEST_F(Vision, WhatIsTrackedIsSeenAtOnceInImagesOfAnotherSize) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(call("(track \"circle\")"), "()");
  for (const double scale : {1.6, 1 / 1.6}) {
    SCOPED_TRACE(scale);
    run_for(500ms);
    EXPECT_TRUE(says().starts_with(R"x((TRACK 1 ("circle" OK ()x")) << says();
    camera.plugged = false;
    run_for(300ms);
    camera.magnify(scale);
    camera.plugged = true;
    while (says() == "nothing") run_for(50ms);
    EXPECT_TRUE(says().starts_with(R"x((TRACK 1 ("circle" OK ()x")) << says();
  }
}

TEST_F(Vision, WhatTheBoardRemembersIsFoundByACameraOfAnotherResolution) {
  EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
  EXPECT_EQ(facts("(learned-focal vision ? ? ?)"), "(learned-focal vision \"circle\" 1 431.0)");
  const auto find_with = [&](double scale) {
    life.reset();
    run_for(3s);
    camera.magnify(scale);
    live();
    return call("(find \"circle\")");
  };
  EXPECT_TRUE(find_with(3).starts_with(R"x((FIND "circle" OK ()x"));
  EXPECT_TRUE(find_with(1 / 3.0).starts_with(R"x((FIND "circle" OK ()x"));
  // Nobody knows by which camera an older version learned it.
  retract("(learned-focal vision ? ? ?)");
  EXPECT_EQ(find_with(3), R"x((FIND "circle" FAIL))x");
  EXPECT_NE(facts("(vision-failed vision ? ? too-large ?)"), "");
}

TEST_F(Vision, WhatIsForgottenAndLearnedAnewHasOneFocalLength) {
  for (const double scale : {1.0, 1.5}) {
    camera.magnify(scale);
    EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
    EXPECT_EQ(facts("(learned-focal vision ? ? ?)").find('\n'), std::string::npos);
    EXPECT_EQ(call("(rename \"circle\" \"disc\")"), "()");
    EXPECT_NE(facts("(learned-focal vision \"disc\" 1 ?)"), "");
    EXPECT_EQ(call("(forget \"disc\")"), "()");
    EXPECT_EQ(facts("(learned-focal vision ? ? ?)"), "");
  }
}

TEST_F(Vision, PublishesImagesWhileTheyAreWatched) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  int grey = 0;
  std::map<std::string, int> channels;
  std::shared_ptr<const Image> annotated;
  {
    const auto left = streams.subscribe("vision-left", [&](const StreamFrame& f) { grey += f.image->channels == 1; });
    std::vector<std::unique_ptr<Streams::Subscription>> others;
    for (const std::string kind : {"colour", "grey", "right"}) {
      others.push_back(streams.subscribe(
          "vision-" + kind, [&channels, kind](const StreamFrame& f) { channels[kind] = f.image->channels; }));
    }
    const auto shown = streams.subscribe("vision-annotated", [&](const StreamFrame& f) { annotated = f.image; });
    run_for(350ms);
  }
  EXPECT_EQ(grey, 3);
  EXPECT_EQ(facts("(stream ? annotated ?)"), "(stream vision-annotated annotated ())");
  EXPECT_EQ(channels, (std::map<std::string, int>{{"colour", 3}, {"grey", 1}, {"right", 1}}));
  ASSERT_NE(annotated, nullptr);
  EXPECT_EQ(annotated->channels, 3);
  EXPECT_EQ(annotated->width, 640);
  run_for(300ms);
  EXPECT_EQ(grey, 3);
}

// The middle of a dark mark is dark but for the cross.
TEST_F(Vision, ShowsForAWhileWhatWasFound) {
  learn_all();
  const cv::Point2d circle = project(camera.model(), camera.scene.faces[0].place, false);
  std::shared_ptr<const Image> annotated;
  const auto watching = streams.subscribe("vision-annotated", [&](const StreamFrame& f) { annotated = f.image; });
  const auto is_crossed = [&] {
    const int x = cvRound(2 * circle.x + 0.5) + 5;
    const int y = cvRound(2 * circle.y + 0.5);
    const auto at = static_cast<std::size_t>(3 * (y * annotated->width + x));
    return std::ranges::all_of(std::span(annotated->pixels).subspan(at, 3), [](int level) { return level > 150; });
  };
  EXPECT_NE(call("(find \"circle\")").find("OK"), std::string::npos);
  run_for(300ms);
  ASSERT_NE(annotated, nullptr);
  EXPECT_TRUE(is_crossed()) << "also by eyes that rest again";
  EXPECT_EQ(call("(connect)"), "()");
  run_for(1s);
  EXPECT_TRUE(is_crossed());
  run_for(3s);
  EXPECT_FALSE(is_crossed());
  EXPECT_NE(call("(find \"circle\")").find("OK"), std::string::npos);
  run_for(300ms);
  EXPECT_TRUE(is_crossed());
  EXPECT_EQ(call("(forget \"circle\")"), "()");
  run_for(300ms);
  EXPECT_FALSE(is_crossed());
}

TEST_F(Vision, ShowsWhatItMakesOfItInGreyWhileItTracks) {
  learn_all();
  std::shared_ptr<const Image> annotated;
  const auto watching = streams.subscribe("vision-annotated", [&](const StreamFrame& f) { annotated = f.image; });
  const auto is_grey = [&] {
    const auto corner = std::span(annotated->pixels).first(3);
    return corner[0] == corner[1] && corner[1] == corner[2];
  };
  EXPECT_EQ(call("(connect)"), "()");
  run_for(300ms);
  ASSERT_NE(annotated, nullptr);
  EXPECT_FALSE(is_grey());
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(300ms);
  EXPECT_TRUE(is_grey());
  EXPECT_EQ(call("(end-track)"), "()");
  run_for(300ms);
  EXPECT_FALSE(is_grey());
}

// The camera moves on between the eyes' grey image and the one in colour.
TEST_F(Vision, CallsWhatItShowsByTheNumberOfTheFrameThatIsInIt) {
  learn_all();
  camera.moves_on = true;
  std::vector<std::uint64_t> coloured;
  std::vector<std::uint64_t> annotated;
  std::vector<std::uint64_t> eyes;
  const auto grey = streams.subscribe("vision-left", [&](const StreamFrame& f) { eyes.push_back(f.number); });
  const auto colour = streams.subscribe("vision-colour", [&](const StreamFrame& f) { coloured.push_back(f.number); });
  const auto shown =
      streams.subscribe("vision-annotated", [&](const StreamFrame& f) { annotated.push_back(f.number); });
  EXPECT_EQ(call("(connect)"), "()");
  run_for(1s);
  EXPECT_GE(annotated.size(), 3U);
  EXPECT_EQ(annotated, coloured) << "both are the same image";
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(300ms);
  annotated.clear();
  eyes.clear();
  run_for(1s);
  EXPECT_GE(annotated.size(), 5U);
  EXPECT_EQ(annotated, eyes) << "each grey image is shown as soon as it is looked at";
}

// Colour is asked of the camera, and pictures are drawn, only for those who look. What is tracked is shown in grey.
TEST_F(Vision, SendsEachImageOnlyWhileSomeoneWatchesThatKind) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  run_for(500ms);
  EXPECT_EQ(camera.colour_asked, 0);
  for (const std::string kind : {"left", "right", "grey", "colour", "annotated"}) {
    SCOPED_TRACE(kind);
    std::map<std::string, int> sent;
    const int colours = camera.colour_asked;
    {
      const auto watching = streams.subscribe("vision-" + kind, [&](const StreamFrame&) { ++sent[kind]; });
      run_for(350ms);
    }
    EXPECT_GE(sent[kind], 3);
    EXPECT_EQ(camera.colour_asked > colours, kind == "colour");
    const int before = sent[kind];
    const int colours_before = camera.colour_asked;
    run_for(300ms);
    EXPECT_EQ(sent[kind], before);
    EXPECT_EQ(camera.colour_asked, colours_before);
  }
}

}  // namespace
}  // namespace pizarra::vision
