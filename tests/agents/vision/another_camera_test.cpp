// An object that one camera has learned is found and followed by one of another resolution or lens, as far away.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"

namespace pizarra::vision {
namespace {

// The cell's pair, or the left one of it alone, with so many times the pixels along and across, and with a lens that
// shows everything so many times larger.
struct Eyes {
  double pixels = 1;
  double lens = 1;
  bool alone = false;

  camera::StereoModel model() const {
    camera::StereoModel out;
    out = two_cameras(cvRound(pixels * out.width), cvRound(pixels * out.height));
    out.focal_px *= pixels * lens;
    return alone ? one_camera_of(out) : out;
  }
};

struct Exchange {
  const char* name;
  Eyes learning;
  Eyes looking;

  friend void PrintTo(const Exchange& exchange, std::ostream* out) { *out << exchange.name; }
};

constexpr Exchange exchanges[] = {
    {"MorePixels", {.pixels = 1}, {.pixels = 4}},
    {"FewerPixels", {.pixels = 4}, {.pixels = 1}},
    {"LongerLens", {.pixels = 1.5}, {.pixels = 1.5, .lens = 2}},
    {"ShorterLens", {.pixels = 1.5, .lens = 2}, {.pixels = 1.5}},
    {"MorePixelsOfOneAlone", {.pixels = 1, .alone = true}, {.pixels = 4, .alone = true}},
    {"FewerPixelsOfOneAlone", {.pixels = 4, .alone = true}, {.pixels = 1, .alone = true}},
    {"OneAloneAfterAPair", {.pixels = 2}, {.pixels = 1, .alone = true}},
    {"APairAfterOneAlone", {.pixels = 1, .alone = true}, {.pixels = 2}},
};

// What such eyes see of a mark.
struct View {
  View(const SceneFace& face, const camera::StereoModel& model, Random& random)
      : frame(draw_scene({.faces = {face}}, model, 1, random)),
        right(model.is_single() ? cv::Mat(cv::Mat::zeros(model.height, model.width, CV_8U)) : as_mat(*frame.right)),
        sight(as_mat(*frame.left), right, model) {}
  camera::StereoFrame frame;
  cv::Mat right;
  StereoSight sight;
};

class AnotherCamera : public testing::TestWithParam<std::tuple<std::string, Exchange>> {
 protected:
  // From two frames, in turns.
  LearnedObjects learned(const camera::StereoModel& model) {
    const SceneFace face{.mark = drawn_as(name), .place = {0, 0, 850}};
    View views[] = {{face, model, random}, {face, model, random}};
    LearnedObjects out;
    MarkLearner learner(name, project(model, face.place, false) + cv::Point2d(1.2, -2), out);
    for (std::size_t i = 0; !learner.done(); ++i) learner.feed(views[i % 2].sight).value();
    LearnedSample sample = learner.sample();
    sample.number = 1;
    out.add(name, std::move(sample));
    return out;
  }
  void expect_another_size(const LearnedObjects& objects, const camera::StereoModel& model, double scale) {
    SCOPED_TRACE(scale);
    View view({.mark = drawn_as(name), .place = {0, 0, 850 / scale}}, model, random);
    for (const SeenMark& mark : view.sight.left_segmentation().marks()) {
      EXPECT_FALSE(is_recognised(mark, objects, *objects.find(name)));
      const std::optional<double> told = scale_of_another_size(mark, *objects.find(name));
      EXPECT_NEAR(told.value_or(scale), scale, 0.1 * scale);
    }
  }
  const std::string& name = std::get<0>(GetParam());
  const Exchange& exchange = std::get<1>(GetParam());
  const camera::StereoModel learning = exchange.learning.model();
  const camera::StereoModel looking = exchange.looking.model();
  Random random = Random(5).split(name);
};

TEST_P(AnotherCamera, FindsAndFollowsWhatWasLearnedAndNothingOfAnotherSize) {
  const LearnedObjects objects = learned(learning);
  const LearnedObject& object = *objects.find(name);
  EXPECT_EQ(object.samples.front().focal_px, learning.focal_px);
  MarkTracker tracker{objects};
  ASSERT_TRUE(tracker.add(object));
  Time now = {};
  for (int step = 0; step < 4; ++step) {
    SCOPED_TRACE(step);
    const SceneFace face{
        .mark = drawn_as(name), .place = {20.0 + 4 * step, 10, 860.0 - 40 * step}, .roll_deg = 2.0 * step};
    View view(face, looking, random);
    const cv::Point2d place = project(looking, face.place, false);
    const double half_a_px = 0.5 * looking.width / 320;
    const std::optional<SeenPair> found = view.sight.find(objects, object);
    ASSERT_TRUE(found);
    EXPECT_LT(cv::norm(found->left.centre - place), half_a_px);
    const TrackSighting sighting = tracker.update(view.sight, now += 100ms).front();
    ASSERT_TRUE(sighting.seen);
    EXPECT_LT(cv::norm(sighting.centre - place), half_a_px);
    EXPECT_GE(sighting.confidence, 0.9);
    // Of few pixels blur makes a mark seem larger, by some percent of a triangle.
    EXPECT_NEAR(sighting.range_mm, cv::norm(face.place), 0.04 * face.place.z);
  }
  for (const double scale : {0.3, 3.0}) expect_another_size(objects, looking, scale);
}

std::string another_camera_name(const testing::TestParamInfo<AnotherCamera::ParamType>& one) {
  std::string name = std::get<0>(one.param);
  std::erase(name, '-');
  return name + std::get<1>(one.param).name;
}

INSTANTIATE_TEST_SUITE_P(Marks, AnotherCamera,
                         testing::Combine(testing::ValuesIn(cell_marks()), testing::ValuesIn(exchanges)),
                         another_camera_name);

}  // namespace
}  // namespace pizarra::vision
