// The vision agent alone on photographs of a printed sheet, as a person tries it: an image sequence in place of the
// camera, clicks, finds and tracks.

#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/runtime/caller.hpp"
#include "agents/vision/agent/vision_agent.hpp"
#include "agents/vision/marks/tag_detection.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "drivers/camera/frame_source.hpp"
#include "drivers/camera/video_camera.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/vision/photograph.hpp"
#include "tests/scratch.hpp"

namespace pizarra::vision {
namespace {

constexpr int shots = 3;

Datum form(std::string_view written) { return read_one(written).value(); }

Task<void> live(VisionAgent& vision) {
  const Result<void> ended = co_await vision.run();
  EXPECT_TRUE(ended.has_value());
}

class OwnCamera : public testing::TestWithParam<cv::Size> {
 protected:
  OwnCamera() : folder(scratch_folder() + fmt::format("shots-{}", GetParam().width)) {
    std::filesystem::create_directories(folder);
    learning.size = GetParam();
    learning.tilt_deg = 8;
    show(learning);
    setup.sources = {{forms::CameraSource::Kind::images, folder}};
    camera.emplace(executor, setup);
    agent.emplace(runtime::AgentContext{"vision", "here", executor, *agent_view, Random(1)}, *camera, nullptr);
    life = executor.spawn(live(*agent));
    Job started = executor.spawn(begin());
    executor.run_until([&] { return started.done(); });
  }
  ~OwnCamera() override {
    life = Job();
    agent.reset();
    camera.reset();
    std::filesystem::remove_all(folder);
  }
  Task<void> begin() {
    const Result<void> present = co_await service.start();
    EXPECT_TRUE(present.has_value());
  }

  // What the camera sees from now on.
  void show(const Photograph& photograph) {
    for (int i = 0; i < shots; ++i) {
      const std::string file = fmt::format("{}/{}.jpg", folder, i);
      const std::string fresh = fmt::format("{}/{}.tmp.jpg", scratch_folder(), i);
      ASSERT_TRUE(cv::imwrite(fresh, photograph.take(random), {cv::IMWRITE_JPEG_QUALITY, photograph.jpeg_quality}));
      std::filesystem::rename(fresh, file);
    }
  }
  std::string call(const std::string& operation) {
    std::string answer;
    const Job job = executor.spawn(ask(form(operation), answer));
    executor.run_until([&] { return job.done(); });
    return answer;
  }
  Task<void> ask(Datum operation, std::string& answer) {
    const Result<Datum> result = co_await caller.call("vision", operation, 20s);
    if (!result) {
      answer = describe(result.error());
    } else {
      answer = result->size() > 0 ? std::string((*result)[0].text()) : write(*result);
    }
  }
  void run_for(Duration duration) {
    const Time end = executor.now() + duration;
    executor.call_at(end, [] {});
    executor.run_until([&] { return executor.now() >= end; });
  }
  // Of the photographs before, one may be held for the agent, and one be read still. Each click outside of the image,
  // or each find of what is tracked, takes a newer one.
  void let_old_frames_pass(const std::string& tracked = "") {
    for (int i = 0; i < 3; ++i) call(tracked.empty() ? "(learn -1 -1 \"outside\")" : "(find \"" + tracked + "\")");
  }
  // Of the first TRACK reply from now on of which all is seen.
  std::string says() {
    const Query query = query_from_datum(form("(look vision ?frame ?text ?of)")).value();
    std::optional<Datum> before;
    const Time deadline = executor.now() + 30s;
    while (executor.now() < deadline) {
      const Answers answers = board.ask(query).value();
      if (!answers.answers.empty()) {
        const Datum frame = *answers.answers[0].bindings.find("?frame");
        std::string text(answers.answers[0].bindings.find("?text")->text());
        if (before && *before != frame && text.find("FAIL") == std::string::npos) return text;
        if (!before) before = frame;
      } else if (!before) {
        before = Datum();
      }
      run_for(5ms);
    }
    return "nothing";
  }
  std::string why() {
    const Answers answers =
        board.ask(query_from_datum(form("(vision-failed vision ?f ?t ?symbol ?why)")).value()).value();
    return answers.answers.empty() ? "" : std::string(answers.answers[0].bindings.find("?why")->text());
  }
  void learn_all() {
    for (const PrintedShape& shape : printed_shapes()) {
      const cv::Point2d at = learning.seen_at(shape.name);
      const std::string answer = call(fmt::format("(learn {:.0f} {:.0f} \"{}\")", at.x, at.y, shape.name));
      EXPECT_EQ(answer, fmt::format("(LEARN \"{}\" OK)", shape.name)) << why();
    }
  }

  const std::string folder;
  Random random{5};
  Photograph learning;
  forms::CameraSetup setup{.arrangement = forms::CameraSetup::Arrangement::single, .rate_hz = 60, .learned_at_mm = 500};
  RealExecutor executor;
  memory::MemoryBoard board{executor};
  std::unique_ptr<Board> agent_view = board.view("vision");
  std::unique_ptr<Board> own_view = board.view("tester");
  runtime::AgentContext context{"tester", "here", executor, *own_view, Random(2)};
  runtime::Service service{context, runtime::contract_from_text("(contract tester)").value()};
  runtime::Caller caller{context, service};
  std::optional<camera::VideoCamera> camera;
  std::optional<VisionAgent> agent;
  Job life;
};

TEST_P(OwnCamera, LearnsPrintedShapesAndFindsThemWhereTheyAre) {
  learn_all();
  for (const PrintedShape& shape : printed_shapes()) {
    double x = 0;
    double y = 0;
    const std::string answer = call(fmt::format("(find \"{}\")", shape.name));
    char name[16];
    ASSERT_EQ(std::sscanf(answer.c_str(), "(FIND \"%15[a-z]\" OK (%lf, %lf))", name, &x, &y), 3) << answer << why();
    EXPECT_LT(cv::norm(cv::Point2d(x, y) - learning.seen_at(shape.name)), 1.5) << answer;
  }
  EXPECT_EQ(call("(find \"star\")"), "(FIND \"star\" FAIL)");
}

TEST_P(OwnCamera, FindsThemInOtherPhotographsToo) {
  learn_all();
  Photograph other = learning;
  other.tilt_deg = -12;
  other.pan_deg = 18;
  other.roll_deg = 20;
  other.distance_mm = 640;
  other.light = 0.6;
  other.slope = -0.5;
  other.noise = 6;
  other.jpeg_quality = 70;
  show(other);
  let_old_frames_pass();
  for (const PrintedShape& shape : printed_shapes()) {
    const std::string answer = call(fmt::format("(find \"{}\")", shape.name));
    double x = 0;
    double y = 0;
    char name[16];
    ASSERT_EQ(std::sscanf(answer.c_str(), "(FIND \"%15[a-z]\" OK (%lf, %lf))", name, &x, &y), 3) << answer << why();
    EXPECT_LT(cv::norm(cv::Point2d(x, y) - other.seen_at(shape.name)), 2) << answer;
  }
}

TEST_P(OwnCamera, TracksThemAndSaysHowFarAwayByTheirSize) {
  learn_all();
  EXPECT_EQ(call("(track \"circle\")"), "()");
  EXPECT_EQ(call("(track \"square\")"), "()");
  Photograph nearer = learning;
  nearer.distance_mm = 440;
  show(nearer);
  let_old_frames_pass("circle");
  const std::string text = says();
  double x[2];
  double y[2];
  double d[2];
  ASSERT_EQ(std::sscanf(text.c_str(), "(TRACK 2 (\"circle\" OK (%lf, %lf, %lf)) (\"square\" OK (%lf, %lf, %lf)))", x, y,
                        d, x + 1, y + 1, d + 1),
            6)
      << text;
  for (const int i : {0, 1}) {
    const PrintedShape& shape = printed_shapes()[i == 0 ? 0 : 2];
    EXPECT_LT(cv::norm(cv::Point2d(x[i], y[i]) - nearer.seen_at(shape.name)), 1.5) << text;
    EXPECT_NEAR(d[i], nearer.range_mm(shape.at_mm), 0.04 * 440) << text;
  }
}

// A person's desk: the sheet does not fill the picture, a keyboard and fingers lie about, a lamp's shadow falls across,
// and the pictures come from a telephone.
TEST_P(OwnCamera, TracksShapesOfEitherToneThroughASequenceOnAClutteredDesk) {
  for (const bool light_on_dark : {false, true}) {
    SCOPED_TRACE(light_on_dark ? "light on dark" : "dark on light");
    const std::string suffix = light_on_dark ? "-light" : "";
    learning = {.size = GetParam(),
                .tilt_deg = 6,
                .distance_mm = 280,
                .shadow = 0.7,
                .light_on_dark = light_on_dark,
                .cluttered = true,
                .noise = 5,
                .jpeg_quality = 60};
    show(learning);
    let_old_frames_pass();
    for (const PrintedShape& shape : printed_shapes()) {
      const cv::Point2d at = learning.seen_at(shape.name);
      const std::string name = shape.name + suffix;
      EXPECT_EQ(call(fmt::format("(learn {:.0f} {:.0f} \"{}\")", at.x, at.y, name)),
                fmt::format("(LEARN \"{}\" OK)", name))
          << why();
      EXPECT_TRUE(call(fmt::format("(find \"{}\")", name)).find("OK") != std::string::npos) << name << why();
    }
    const std::string hero = printed_shapes()[light_on_dark ? 1 : 3].name;
    EXPECT_EQ(call(fmt::format("(track \"{}\")", hero + suffix)), "()");
    Photograph seen = learning;
    for (int step = 0; step < 4; ++step) {
      seen.distance_mm += 22;
      seen.roll_deg += 3;
      seen.pan_deg += 2;
      show(seen);
      let_old_frames_pass(hero + suffix);
      double x = 0;
      double y = 0;
      double d = 0;
      const std::string text = says();
      const std::string form = fmt::format("(TRACK 1 (\"{}\" OK (%lf, %lf, %lf)))", hero + suffix);
      ASSERT_EQ(std::sscanf(text.c_str(), form.c_str(), &x, &y, &d), 3) << text << " after " << step;
      EXPECT_LT(cv::norm(cv::Point2d(x, y) - seen.seen_at(hero)), 0.004 * seen.size.width) << text;
    }
    EXPECT_EQ(call("(end-track)"), "()");
  }
}

TEST_P(OwnCamera, AClickOnThePaperIsRefusedWithItsReason) {
  const cv::Point2d paper = learning.project({0, 0});
  EXPECT_EQ(call(fmt::format("(learn {:.0f} {:.0f} \"paper\")", paper.x, paper.y)), "(LEARN \"paper\" FAIL)");
  EXPECT_FALSE(why().empty());
  EXPECT_EQ(call("(learn 5000 10 \"outside\")"), "(LEARN \"outside\" FAIL)");
  EXPECT_NE(why().find("outside the image"), std::string::npos) << why();
}

INSTANTIATE_TEST_SUITE_P(Sizes, OwnCamera, testing::Values(cv::Size(640, 480), cv::Size(1280, 960)),
                         [](const auto& size) { return fmt::format("Width{}", size.param.width); });

// A cell file that names tags and image files: nobody asks the eyes for anything.
TEST(OwnCameraOfACell, TellsTheTagsOfItsImageFiles) {
  constexpr int side_px = 96;
  constexpr double focal_px = 500;
  constexpr double side_mm = 50;
  const std::string folder = scratch_folder() + "tags-of-a-cell";
  std::filesystem::create_directories(folder);
  cv::Mat1b image(240, 320, std::uint8_t{200});
  cv::Mat1b print;
  cv::resize(print_of(*family_called("apriltag-36h11"), 17), print, {side_px, side_px}, 0, 0, cv::INTER_NEAREST);
  image(cv::Rect(102, 62, side_px, side_px)).setTo(30, print == 0);
  ASSERT_TRUE(cv::imwrite(folder + "/1.png", image));
  const Result<forms::CellDescription> cell =
      forms::read_cell(fmt::format("(cell c (camera (single (images \"{}\")) (focal {})) (tags (apriltag-36h11 {})))",
                                   folder, focal_px, side_mm),
                       "c");
  ASSERT_TRUE(cell) << describe(cell.error());
  RealExecutor executor;
  memory::MemoryBoard board(executor);
  const std::unique_ptr<Board> view = board.view("vision");
  camera::VideoCamera camera(executor, cell->eyes);
  VisionAgent agent({"vision", "here", executor, *view, Random(1)}, camera, nullptr,
                    {.objects_directory = "", .tags = {{cell->tags.front().family, cell->tags.front().side_mm}}});
  Job life = executor.spawn(live(agent));
  const Query query = query_from_datum(form("(tags-seen vision ?frame ?captured ?tags)")).value();
  std::optional<Datum> tags;
  const Time deadline = executor.now() + 60s;
  executor.call_at(deadline, [] {});
  executor.run_until([&] {
    const Result<Answers> answers = board.ask(query);
    if (answers && !answers->answers.empty()) tags = *answers->answers[0].bindings.find("?tags");
    return tags || executor.now() >= deadline;
  });
  life = Job();
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(tags);
  ASSERT_EQ(tags->size(), 1U) << write(*tags);
  const Datum& tag = (*tags)[0];
  EXPECT_EQ(tag[1].integer(), 17);
  const Datum& pose = tag[tag.size() - 1];
  ASSERT_TRUE(pose.is_form("pose")) << write(tag);
  EXPECT_NEAR(pose[1].number(), (149.5 - 159.5) * side_mm / side_px, 0.5);
  EXPECT_NEAR(pose[3].number(), focal_px * side_mm / side_px, 3);
}

}  // namespace
}  // namespace pizarra::vision
