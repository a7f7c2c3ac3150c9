#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/objects/sample_facts.hpp"
#include "tests/agents/vision/eyes.hpp"

namespace pizarra::vision {
namespace {

// The one mark of a scene that shows one; the face's own light region is none.
const SeenMark* only_mark(DrawnSight& drawn, MarkTone tone) {
  const SeenMark* found = nullptr;
  for (const SeenMark& mark : drawn.sight.left_segmentation().marks()) {
    if (mark.tone == tone) found = &mark;
  }
  return found;
}

MarkPortrait portrait_of(DrawnSight& drawn, const SeenMark& mark) {
  return portray_mark(drawn.sight.left_segmentation().cut(), mark.contour, mark.tone).value();
}

Scene one_face(const std::string& mark, cv::Point3d place) {
  Scene scene;
  scene.faces = {{.mark = mark, .place = place}};
  return scene;
}

TEST(Contour, FollowsTheBorderPixelsOfARegionOnce) {
  cv::Mat1b mask = cv::Mat1b::zeros(12, 12);
  mask(cv::Rect(3, 4, 5, 4)).setTo(255);
  const std::optional<MarkContour> contour = contour_from_centre(MaskField(mask), {5, 6}, 2, 100);
  ASSERT_TRUE(contour);
  EXPECT_EQ(contour->size(), 14U);
}

TEST(Contour, IsNotClosedWhereTheRegionReachesTheEdge) {
  cv::Mat1b mask = cv::Mat1b::zeros(12, 12);
  mask(cv::Rect(0, 4, 5, 4)).setTo(255);
  EXPECT_FALSE(contour_from_centre(MaskField(mask), {3, 6}, 2, 100));
}

TEST(Contour, OfAHoleIsNone) {
  cv::Mat1b mask = cv::Mat1b::zeros(20, 20);
  mask(cv::Rect(3, 3, 14, 14)).setTo(255);
  mask(cv::Rect(7, 7, 4, 4)).setTo(0);
  EXPECT_FALSE(contour_from_centre(MaskField(mask), {13, 9}, 2, 200));
  EXPECT_TRUE(contour_from_centre(MaskField(mask), {5, 9}, 2, 200));
}

TEST(Contour, StopsAtItsBound) {
  cv::Mat1b mask = cv::Mat1b::zeros(40, 40);
  mask(cv::Rect(3, 3, 30, 30)).setTo(255);
  EXPECT_FALSE(contour_from_centre(MaskField(mask), {10, 10}, 2, 100));
}

TEST(Mark, ACircleMeasuresAboutWhatTheThesisPrinted) {
  Random random(1);
  DrawnSight drawn(one_face("circle", {0, 0, 850}), random);
  const SeenMark* mark = only_mark(drawn, MarkTone::dark);
  ASSERT_NE(mark, nullptr);
  EXPECT_NEAR(mark->area_px, 391, 12);
  EXPECT_NEAR(mark->perimeter_px, 59, 5);
  const MarkPortrait portrait = portrait_of(drawn, *mark);
  EXPECT_LE(portrait.corners, 1);
  EXPECT_NEAR(portrait.moments[0], 1.017, 0.02);
}

TEST(Mark, CornersAreCounted) {
  Random random(2);
  const std::vector<std::pair<std::string, int>> corners = {{"square", 4}, {"triangle", 3}, {"cross", 12}};
  for (const auto& [name, count] : corners) {
    DrawnSight drawn(one_face(name, {0, 0, 850}), random);
    const SeenMark* mark = only_mark(drawn, MarkTone::dark);
    ASSERT_NE(mark, nullptr) << name;
    EXPECT_NEAR(portrait_of(drawn, *mark).corners, count, count / 4.0) << name;
  }
}

TEST(Mark, CentresAreExactToATenthOfAPixelUnderNoiseBlurAndAGradient) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const std::string& name : cell_marks()) {
      const cv::Point3d place(random.uniform(-140, 140), random.uniform(-60, 60), random.uniform(820, 880));
      DrawnSight drawn(one_face(drawn_as(name), place), random);
      const SeenMark* mark = only_mark(drawn, name == "end-effector" ? MarkTone::light : MarkTone::dark);
      ASSERT_NE(mark, nullptr) << name;
      const cv::Point2d truth = project(DrawnSight::model(), place, false);
      EXPECT_NEAR(mark->centre.x, truth.x, 0.15) << name;
      EXPECT_NEAR(mark->centre.y, truth.y, 0.15) << name;
    }
  }
}

TEST(Mark, DistanceIsTheRangeFromTheMiddleOfTheBaseLine) {
  Random random(4);
  for (const std::string& name : cell_marks()) {
    const cv::Point3d place(random.uniform(-140, 140), random.uniform(-60, 60), random.uniform(820, 880));
    DrawnSight drawn(one_face(drawn_as(name), place), random);
    const SeenMark* left = only_mark(drawn, name == "end-effector" ? MarkTone::light : MarkTone::dark);
    ASSERT_NE(left, nullptr) << name;
    const SeenMark* right = find_partner(*left, drawn.sight.right_segmentation().marks(), std::nullopt);
    ASSERT_NE(right, nullptr) << name;
    const double range = range_mm(DrawnSight::model(), left->centre, left->centre.x - right->centre.x);
    EXPECT_NEAR(range, cv::norm(place), 3) << name;
  }
}

// Discs of many sizes, dark and light, in uneven light.
cv::Mat1b scattered_discs(cv::Size size, Random& random) {
  cv::Mat1f image(size, 130.0F);
  for (int i = 0; i < 60; ++i) {
    const cv::Point middle(static_cast<int>(random.uniform(0, size.width)),
                           static_cast<int>(random.uniform(0, size.height)));
    const int radius = static_cast<int>(random.uniform(4, 0.06 * size.height));
    cv::circle(image, middle, radius, random.below(2) == 0 ? 30 : 230, cv::FILLED, cv::LINE_AA);
  }
  cv::Mat1b out(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const double light = 0.6 + 0.4 * x / size.width + 0.2 * y / size.height;
      out(y, x) = cv::saturate_cast<std::uint8_t>(image(y, x) * light + 2 * random.normal());
    }
  }
  return out;
}

TEST(Mark, IsTheSameWhereOnlyAnAreaAroundItIsLookedAt) {
  Random random(6);
  for (const cv::Size size : {cv::Size(320, 240), cv::Size(333, 251), cv::Size(752, 480), cv::Size(1000, 701)}) {
    const cv::Mat1b image = scattered_discs(size, random);
    const double noise = noise_of(image);
    ImageSegmentation whole(image, noise);
    ASSERT_GT(whole.marks().size(), 10U);
    for (int i = 0; i < 40; ++i) {
      const int first = static_cast<int>(random.uniform(-20, size.height - 10));
      const int left = static_cast<int>(random.uniform(-20, size.width / 2.0));
      const cv::Rect area(left, first, static_cast<int>(random.uniform(10, size.width)),
                          static_cast<int>(random.uniform(10, size.height)));
      SCOPED_TRACE(testing::Message() << size << ", area " << area);
      const cv::Rect shown = area & cv::Rect({0, 0}, size);
      std::vector<SeenMark> expected = whole.marks();
      std::erase_if(expected, [&](const SeenMark& mark) {
        const cv::Rect around(mark.box.tl() - cv::Point(1, 1), mark.box.size() + cv::Size(2, 2));
        return (around & shown) != around;
      });
      ImageSegmentation part(image, noise, 0, area);
      ASSERT_EQ(part.marks().size(), expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(part.marks()[k].centre, expected[k].centre);
        EXPECT_EQ(part.marks()[k].contour, expected[k].contour);
      }
    }
  }
}

TEST(Mark, IsSegmentedInHalfTheLight) {
  Random random(5);
  Scene scene = one_face("cross", {0, 0, 850});
  scene.gradient = 0.8;
  DrawnSight drawn(scene, random);
  EXPECT_NE(only_mark(drawn, MarkTone::dark), nullptr);
}

TEST(Template, SurvivesItsText) {
  Random random(6);
  MarkTemplate picture{};
  for (std::uint8_t& level : picture) level = static_cast<std::uint8_t>(random.below(16));
  EXPECT_EQ(template_from_text(template_to_text(picture)).value(), picture);
  EXPECT_FALSE(template_from_text("0123"));
  EXPECT_FALSE(template_from_text(std::string(1024, 'g')));
}

TEST(LearnedFacts, WithoutATemplateAreDamaged) {
  const LearnedObject& object = learned_cell().all().front();
  const Result<LearnedSample> read = sample_from_facts({learned_fact(object.name, object.samples.front())});
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().symbol, "damaged");
}

TEST(LearnedFacts, SayHowASlimMarkLies) {
  LearnedSample slim = learned_cell().all().front().samples.front();
  slim.axis_deg = 30;
  EXPECT_EQ(sample_from_facts(facts_of_sample("bar", slim))->axis_deg, 30);
}

TEST(LearnedFacts, SayTheWholeSample) {
  for (const LearnedObject& object : learned_cell().all()) {
    const LearnedSample& sample = object.samples.front();
    const Result<LearnedSample> back = sample_from_facts(facts_of_sample(object.name, sample));
    ASSERT_TRUE(back);
    EXPECT_GT(back->contrast, 1);
    EXPECT_EQ(back->contrast, sample.contrast);
    EXPECT_EQ(back->focal_px, DrawnSight::model().focal_px);
    EXPECT_EQ(back->number, 1);
    EXPECT_EQ(back->tone, sample.tone);
    EXPECT_EQ(back->size_mm, sample.size_mm);
    EXPECT_EQ(back->signatures.back().unturned().samples, sample.signatures.back().unturned().samples);
    EXPECT_NEAR(back->area_px, sample.area_px, 0.001);
  }
}

}  // namespace
}  // namespace pizarra::vision
