// The fact tags-seen: all tags in view, told although nobody has asked, clicked or connected.

#include "agents/vision/agent/reply_text.hpp"
#include "lisp/forms/cell_file.hpp"
#include "tests/agents/vision/printed_tags.hpp"

namespace pizarra::vision {
namespace {

class TagsSeen : public PrintedTags {
 protected:
  void live_with_tags() { live_with({.objects_directory = "", .tags = {{"apriltag-36h11", side_mm()}}}); }
  static cv::Point2d middle(cv::Point at) { return cv::Point2d(at) + cv::Point2d((tag_px - 1) / 2, (tag_px - 1) / 2); }

  // None as well where the eyes have not said yet that they tell any.
  std::optional<Datum> look() {
    static const Query any = query_from_datum(form("(tags-seen vision ? ? ?)")).value();
    const Result<Answers> told = board.ask(any);
    if (!told || told->answers.empty()) return std::nullopt;
    return told->answers.front().facts.front().datum;
  }
  // The first look, within ten seconds, that this holds of.
  std::optional<Datum> look_where(const std::function<bool(const std::optional<Datum>&)>& holds) {
    const Time deadline = executor.now() + 10s;
    executor.call_at(deadline, [] {});
    executor.run_until([&] { return executor.now() >= deadline || holds(look()); });
    EXPECT_TRUE(holds(look()));
    return look();
  }
  std::optional<Datum> look_at(std::size_t tags) {
    return look_where([tags](const std::optional<Datum>& seen) { return seen && (*seen)[4].size() == tags; });
  }
  static const Datum* part(const Datum& tag, std::string_view name) {
    for (const Datum& each : tag.items()) {
      if (each.is_form(name)) return &each;
    }
    return nullptr;
  }
};

TEST_F(TagsSeen, HaveTheirPlaceAndPoseAlthoughNobodyAsked) {
  show(17, {80, 60});
  show(3, {180, 120});
  live_with_tags();
  const Time before = executor.now();
  const std::optional<Datum> seen = look_at(2);
  ASSERT_TRUE(seen);
  const Time captured{Duration((*seen)[3].integer())};
  EXPECT_GT(captured, before);
  EXPECT_LE(captured, executor.now());
  for (const Datum& tag : (*seen)[4].items()) {
    EXPECT_TRUE(tag[0].is_symbol("apriltag-36h11"));
    const cv::Point2d truth = tag[1].integer() == 17 ? middle({80, 60}) : middle({180, 120});
    EXPECT_GT(tag[2].number(), 0.5) << write(tag);
    const Datum* const left = part(tag, "left");
    const Datum* const pose = part(tag, "pose");
    ASSERT_TRUE(left && pose && part(tag, "right") && part(tag, "range")) << write(tag);
    EXPECT_LT(cv::norm(cv::Point2d((*left)[1].number(), (*left)[2].number()) - truth), 0.5) << write(tag);
    const camera::StereoModel& model = camera.model();
    const double x = (truth.x - model.centre_x_px) * depth_mm() / model.focal_px - model.base_line_mm / 2;
    EXPECT_NEAR((*pose)[1].number(), x, 2) << write(tag);
    EXPECT_NEAR((*pose)[3].number(), depth_mm(), 5) << write(tag);
    EXPECT_EQ((*pose)[7].size(), 21U) << "the covariance";
  }
  EXPECT_EQ((*seen)[4][0][1].integer() + (*seen)[4][1][1].integer(), 20);
}

TEST_F(TagsSeen, OfEachFamilyWithCellsAroundItsSquareAreToldWithTheirPose) {
  for (const std::string family : {"apriltag-standard41h12", "apriltag-circle21h7", "apriltag-standard52h13"}) {
    const int cells = print_of(*family_called(family), 0).cols;
    const int side_cells = cells - 2 * family_called(family)->cells_around;
    camera.pictures.clear();
    show(9, {90, 70}, family);
    life.reset();
    life.emplace(executor, board, camera, &streams,
                 VisionOptions{.objects_directory = "",
                               .tags = {{family, side_cells * cell_px * depth_mm() / camera.model().focal_px}}});
    const std::optional<Datum> seen =
        look_where([&](const std::optional<Datum>& now) { return now && write(*now).contains(family); });
    ASSERT_TRUE(seen) << family;
    ASSERT_EQ((*seen)[4].size(), 1U) << write(*seen);
    const Datum& tag = (*seen)[4][0];
    EXPECT_EQ(tag[1].integer(), 9);
    const Datum* const pose = part(tag, "pose");
    ASSERT_TRUE(pose) << write(tag);
    EXPECT_NEAR((*pose)[3].number(), depth_mm(), 5) << write(tag);
  }
}

TEST_F(TagsSeen, ThatThereAreNoneIsToldOnce) {
  live_with_tags();
  const std::optional<Datum> first = look_at(0);
  ASSERT_TRUE(first);
  run_for(2s);
  EXPECT_EQ(look(), first) << "no other look without tags was told";
  show(5, {120, 80});
  const std::optional<Datum> seen = look_at(1);
  ASSERT_TRUE(seen);
  EXPECT_GT((*seen)[2].integer(), (*first)[2].integer());
  look_where([&](const std::optional<Datum>& now) { return now && now != seen; });
  camera.pictures.clear();
  const std::optional<Datum> gone = look_at(0);
  ASSERT_TRUE(gone);
  EXPECT_GT((*gone)[2].integer(), (*seen)[2].integer()) << "as soon as it is gone";
}

TEST_F(TagsSeen, GoWithTheCameraAndComeBackWithIt) {
  show(5, {120, 80});
  live_with_tags();
  look_at(1);
  camera.plugged = false;
  look_where([](const std::optional<Datum>& seen) { return !seen; });
  camera.plugged = true;
  look_at(1);
}

TEST_F(TagsSeen, AreToldOnBesideWhatClientsDo) {
  show(5, {120, 80});
  live_with_tags();
  look_at(1);
  EXPECT_EQ(call("(connect)"), "()");
  EXPECT_EQ(call("(disconnect)"), "()");
  const std::optional<Datum> then = look();
  look_where([&](const std::optional<Datum>& seen) { return seen && seen != then; });
}

TEST_F(TagsSeen, WithoutFamiliesTheCameraRests) {
  show(5, {120, 80});
  run_for(3s);
  EXPECT_FALSE(look());
  EXPECT_EQ(camera.opened, 0);
}

TEST(TagsFact, HoldsSoManyAtMost) {
  std::vector<FoundMark> seen(most_tags_told + 5);
  for (std::size_t i = 0; i < seen.size(); ++i) seen[i].pair.left.tag = Tag{"apriltag-36h11", static_cast<int>(i)};
  const Datum fact = tags_fact(1, Time(), seen);
  EXPECT_EQ(fact[3].size(), most_tags_told);
  EXPECT_EQ(fact[3][most_tags_told - 1][1].integer(), static_cast<std::int64_t>(most_tags_told) - 1);
}

TEST(TagsOfACell, MayBeOfEveryFamilyThatTheEyesKnow) {
  for (const TagFamily& family : tag_families()) {
    const std::string name(family.name);
    const Result<forms::CellDescription> cell = forms::read_cell("(cell c (tags (" + name + " 40)))", "c");
    ASSERT_TRUE(cell) << describe(cell.error());
    EXPECT_EQ(cell->tags, (std::vector<forms::CellTags>{{name, 40}}));
  }
}

}  // namespace
}  // namespace pizarra::vision
