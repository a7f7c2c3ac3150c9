// Bodies of which several faces bear tags.

#include <Eigen/Dense>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/agent/known_bodies.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/numbers.hpp"
#include "tests/agents/vision/printed_tags.hpp"

namespace pizarra::vision {
namespace {

constexpr double half_edge_mm = 25;
constexpr double tag_side_mm = 100.0 / 3;  // with two light cells around it the tag fills its face
constexpr const char* cube_marks =
    R"((("front" (0 0 -25) (0 0 0)) ("left" (-25 0 0) (0 90 0)) ("right" (25 0 0) (0 -90 0)) )"
    R"x(("back" (0 0 25) (0 180 0)) ("top" (0 -25 0) (-90 0 0)) ("bottom" (0 25 0) (90 0 0))))x";

const Body& cube() {
  static const Body body = body_from(form(cube_marks), "cube").value();
  return body;
}

// The cube's marks as the eyes know them: the first tags of a family.
const LearnedObjects& cube_tags() {
  static const LearnedObjects objects = [] {
    LearnedObjects out;
    int number = 0;
    for (const MarkOnBody& mark : cube().marks) {
      LearnedSample sample = learn_print({mark.name, {"apriltag-36h11", number++}, tag_side_mm}, out).value();
      sample.number = 1;
      out.add(mark.name, std::move(sample));
    }
    return out;
  }();
  return objects;
}

struct Placed {
  cv::Matx33d turn;
  cv::Vec3d place_mm;  // from the middle of the base line
};

camera::StereoModel pair_of_cameras() {
  camera::StereoModel out;
  out.width = 640;
  out.height = 480;
  out.focal_px = 860;
  out.centre_x_px = 319.5;
  out.centre_y_px = 239.5;
  return out;
}

cv::Point2f seen_at(const camera::StereoModel& model, const cv::Vec3d& point, bool right) {
  const double x = point[0] + (right ? -1 : 1) * model.base_line_mm / 2;
  return {static_cast<float>(model.centre_x_px + model.focal_px * x / point[2]),
          static_cast<float>(model.centre_y_px + model.focal_px * point[1] / point[2])};
}

// One image of the cube: each face that looks at the camera, drawn three times as large and then made smaller.
cv::Mat1b image_of_cube(const camera::StereoModel& model, const Placed& at, bool right, Random& random) {
  constexpr int finer = 3;
  constexpr int cell_px = 12;
  constexpr int around_px = 2 * cell_px;
  cv::Mat1b large(finer * model.height, finer * model.width, 110);
  const cv::Vec3d camera((right ? 0.5 : -0.5) * model.base_line_mm, 0, 0);
  int number = 0;
  for (const MarkOnBody& mark : cube().marks) {
    cv::Mat1b print;
    cv::resize(print_of(*family_called("apriltag-36h11"), number++), print, {}, cell_px, cell_px, cv::INTER_NEAREST);
    cv::copyMakeBorder(print, print, around_px, around_px, around_px, around_px, cv::BORDER_CONSTANT, 255);
    const cv::Matx33d turn = at.turn * mark.turn;
    const cv::Vec3d middle = at.place_mm + at.turn * mark.place_mm;
    const cv::Vec3d into(turn(0, 2), turn(1, 2), turn(2, 2));
    if (into.dot(middle - camera) <= 0) continue;
    std::vector<cv::Point2f> from, to;
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
      const auto px = static_cast<float>(print.cols);
      from.emplace_back((static_cast<float>(x) + 1) / 2 * px - 0.5F, (static_cast<float>(y) + 1) / 2 * px - 0.5F);
      const cv::Vec3d corner = middle + turn * cv::Vec3d(x * half_edge_mm, y * half_edge_mm, 0);
      const cv::Point2f seen = seen_at(model, corner, right);
      to.emplace_back(finer * (seen.x + 0.5F) - 0.5F, finer * (seen.y + 0.5F) - 0.5F);
    }
    const cv::Mat look = cv::getPerspectiveTransform(from, to);
    cv::Mat1b face, within;
    cv::warpPerspective(print, face, look, large.size());
    cv::warpPerspective(cv::Mat1b(print.size(), 255), within, look, large.size(), cv::INTER_NEAREST);
    face.copyTo(large, within);
  }
  cv::Mat1b out;
  cv::resize(large, out, {model.width, model.height}, 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(out, out, {}, 0.6);
  for (std::uint8_t& pixel : out) pixel = cv::saturate_cast<std::uint8_t>(20 + 0.8 * pixel + 2 * random.normal());
  return out;
}

const camera::StereoModel& cameras() {
  static const camera::StereoModel model = pair_of_cameras();
  return model;
}

StereoSight look_at(const Placed& at, Random& random) {
  return {image_of_cube(cameras(), at, false, random), image_of_cube(cameras(), at, true, random), cameras()};
}

void track_all(MarkTracker& tracker) {
  for (const MarkOnBody& mark : cube().marks) EXPECT_TRUE(tracker.add(*cube_tags().find(mark.name)));
}

// What tracking tells of the cube's marks in one look.
std::vector<MarkInSight> marks_in_sight(const Placed& at, Random& random) {
  StereoSight sight = look_at(at, random);
  MarkTracker tracker(cube_tags());
  track_all(tracker);
  std::vector<MarkInSight> out;
  for (const TrackSighting& sighting : tracker.update(sight, Time(1s))) {
    if (!sighting.seen || !sighting.pose) continue;
    const auto mark = std::ranges::find(cube().marks, sighting.name, &MarkOnBody::name);
    out.push_back({&*mark, *sighting.pose});
  }
  return out;
}

double turn_between_deg(const cv::Matx33d& a, const cv::Matx33d& b) {
  const double cosine = (cv::trace(a.t() * b) - 1) / 2;
  return degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
}

// A turn that shows the camera any side, all alike.
cv::Matx33d any_turn(Random& random) {
  const Eigen::Quaterniond q =
      Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
  const Eigen::Matrix3d m = q.toRotationMatrix();
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

TEST(Body, IsWhereItIsWhateverSideItShows) {
  Random random(17);
  std::set<std::string> faces;
  int told = 0;
  int by_several = 0;
  int covered = 0;
  constexpr int views = 60;
  for (int view = 0; view < views; ++view) {
    SCOPED_TRACE(view);
    const Placed at{any_turn(random), {random.uniform(-60, 60), random.uniform(-40, 40), random.uniform(350, 500)}};
    const std::vector<MarkInSight> marks = marks_in_sight(at, random);
    const std::optional<BodyPose> lies = body_pose(marks);
    if (!lies) continue;
    ++told;
    by_several += lies->by.size() > 1 ? 1 : 0;
    faces.insert(lies->by.begin(), lies->by.end());
    const cv::Vec3d off = lies->pose.place_mm - at.place_mm;
    EXPECT_LT(cv::norm(off), 3);
    EXPECT_LT(turn_between_deg(lies->pose.turn, at.turn), 4);
    for (int i = 0; i < 3; ++i) covered += std::abs(off[i]) < 2 * std::sqrt(lies->pose.covariance(i, i)) ? 1 : 0;
  }
  EXPECT_GE(told, views - 2);
  EXPECT_GE(by_several, views / 2);
  EXPECT_EQ(faces.size(), cube().marks.size()) << "each face was seen";
  EXPECT_GE(covered, 3 * told * 9 / 10) << "within two spreads, of " << 3 * told;
}

TEST(Body, IsKnownBetterByTwoMarksThanByEither) {
  Random random(5);
  const double side = std::sqrt(0.5);
  const Placed at{cv::Matx33d(side, 0, side, 0, 1, 0, -side, 0, side), {10, 5, 400}};
  const std::vector<MarkInSight> marks = marks_in_sight(at, random);
  ASSERT_EQ(marks.size(), 2U);
  const auto spread = [](const BodyPose& lies) { return lies.pose.covariance.topLeftCorner<3, 3>().trace(); };
  const double both = spread(body_pose(marks).value());
  EXPECT_LT(both, spread(body_pose({&marks[0], 1}).value()));
  EXPECT_LT(both, spread(body_pose({&marks[1], 1}).value()));
}

TEST(Body, DoesNotGoByAMarkThatTheOthersContradict) {
  Random random(6);
  const cv::Matx33d turn =
      cv::Matx33d(0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8) * cv::Matx33d(1, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8);
  const Placed at{turn, {0, 0, 400}};
  std::vector<MarkInSight> marks = marks_in_sight(at, random);
  ASSERT_EQ(marks.size(), 3U);
  const std::string stranger = marks[1].mark->name;
  marks[1].pose.place_mm[0] += 15;
  const BodyPose lies = body_pose(marks).value();
  EXPECT_EQ(std::ranges::count(lies.by, stranger), 0);
  EXPECT_EQ(lies.by.size(), 2U);
  EXPECT_LT(cv::norm(lies.pose.place_mm - at.place_mm), 2);
}

TrackSighting sighting_of(const std::string& name, Time captured) {
  TrackSighting out;
  out.name = name;
  out.captured = captured;
  return out;
}

// The cube's front and right marks as tracking tells them, the cube turned about its upright axis.
std::vector<TrackSighting> turned_marks(double deg) {
  const double by = radians(deg);
  const cv::Matx33d turn(std::cos(by), 0, std::sin(by), 0, 1, 0, -std::sin(by), 0, std::cos(by));
  std::vector<TrackSighting> out;
  for (const char* name : {"front", "right"}) {
    const MarkOnBody& mark = *cube().mark(name);
    const Eigen::Matrix<double, 6, 6> covariance = 1e-4 * Eigen::Matrix<double, 6, 6>::Identity();
    const MarkPose pose{cv::Vec3d(0, 0, 400) + turn * mark.place_mm, turn * mark.turn, covariance};
    out.push_back(sighting_of(name, Time(1s)));
    out.back().seen = true;
    out.back().pose = pose;
  }
  return out;
}

TEST(Body, KeepsItsFrontUntilAnotherFaceLooksAtTheCamerasClearlyMore) {
  std::string front;
  std::vector<int> changes;
  const auto look = [&](int deg) {
    const std::string before = front;
    const TrackSighting seen = body_sighting(cube(), turned_marks(deg), front);
    EXPECT_EQ(seen.name, "cube");
    EXPECT_LT(cv::norm(seen.pose.value().place_mm - cv::Vec3d(0, 0, 400)), 0.01) << deg;
    if (!before.empty() && before != front) changes.push_back(deg);
  };
  for (int deg = 0; deg <= 90; ++deg) look(deg);
  for (int deg = 90; deg >= 0; --deg) look(deg);
  ASSERT_EQ(changes.size(), 2U) << "there and back";
  EXPECT_GT(changes[0], changes[1] + 8);
}

TEST(Body, IsLostOnlyWhereAllOfItsMarksAre) {
  std::vector<TrackSighting> marks = turned_marks(20);
  std::string front;
  EXPECT_TRUE(body_sighting(cube(), marks, front).seen);
  EXPECT_EQ(front, "front");
  marks[0] = sighting_of("front", Time(2s));
  marks[0].bridged = true;
  EXPECT_TRUE(body_sighting(cube(), marks, front).seen) << "by its right side";
  marks[1] = sighting_of("right", Time(3s));
  const TrackSighting bridged = body_sighting(cube(), marks, front);
  EXPECT_FALSE(bridged.seen);
  EXPECT_TRUE(bridged.bridged);
  marks[0].bridged = false;
  const TrackSighting lost = body_sighting(cube(), marks, front);
  EXPECT_FALSE(lost.seen || lost.bridged);
  EXPECT_FALSE(lost.pose);
}

TEST(Body, IsToldByTheNewestFrameAlone) {
  std::vector<TrackSighting> marks = turned_marks(20);
  marks[1].captured = Time(2s);
  std::string front;
  EXPECT_EQ(body_sighting(cube(), marks, front).by, std::vector<std::string>{"right"});
}

// By up to 12 degrees and 15 mm, as between two frames.
Placed moved(const Placed& at, Random& random) {
  const cv::Matx33d way = any_turn(random);
  const double by = radians(random.uniform(0, 12));
  const cv::Matx33d about_z(std::cos(by), -std::sin(by), 0, std::sin(by), std::cos(by), 0, 0, 0, 1);
  const cv::Vec3d step(random.uniform(-15, 15), random.uniform(-15, 15), random.uniform(-15, 15));
  return {way * about_z * way.t() * at.turn, at.place_mm + step};
}

double turned_away_deg(const MarkOnBody& mark, const Placed& at) {
  const cv::Matx33d turn = at.turn * mark.turn;
  const cv::Vec3d middle = at.place_mm + at.turn * mark.place_mm;
  return degrees(std::acos(cv::Vec3d(turn(0, 2), turn(1, 2), turn(2, 2)).dot(middle) / cv::norm(middle)));
}

// As if nobody had seen the mark in this look.
std::map<std::string, cv::Rect> areas_without(const std::string& mark, std::vector<TrackSighting> seen) {
  std::ranges::find(seen, mark, &TrackSighting::name)->seen = false;
  return areas_of_unseen(cube(), seen, Time(1s), cameras().focal_px);
}

TEST(Body, AMarkOfItIsInTheNextLookWhereTheOthersSay) {
  Random random(31);
  int foreseen = 0;
  int turned_away = 0;
  constexpr int views = 25;
  for (int view = 0; view < views; ++view) {
    SCOPED_TRACE(view);
    const Placed before{any_turn(random), {random.uniform(-40, 40), random.uniform(-30, 30), random.uniform(350, 500)}};
    MarkTracker tracker(cube_tags());
    track_all(tracker);
    StereoSight first = look_at(before, random);
    const std::vector<TrackSighting> seen = tracker.update(first, Time(1s));
    StereoSight second = look_at(moved(before, random), random);
    for (const TrackSighting& now : tracker.update(second, Time(1s + 33ms))) {
      const auto areas = areas_without(now.name, seen);
      const auto area = areas.find(now.name);
      if (area == areas.end()) continue;
      const double away_deg = turned_away_deg(*cube().mark(now.name), before);
      if (area->second.empty()) {
        ++turned_away;
        EXPECT_GT(away_deg, 68) << now.name;
        continue;
      }
      if (!now.seen) continue;
      ++foreseen;
      const cv::Rect box = cv::boundingRect(now.contour);
      EXPECT_EQ(box & area->second, box) << now.name;
    }
  }
  EXPECT_GT(foreseen, views);
  EXPECT_GT(turned_away, 2 * views) << "three of its faces or more";
}

TEST(Body, AMarkIsLookedForOnlyWhereItCanBe) {
  Random random(8);
  const Placed at{cv::Matx33d::eye(), {0, 0, 400}};
  const auto sees_front_within = [&](std::optional<cv::Rect> area) {
    StereoSight sight = look_at(at, random);
    MarkTracker tracker(cube_tags());
    track_all(tracker);
    if (area) tracker.look_within({{"front", *area}});
    const std::vector<TrackSighting> seen = tracker.update(sight, Time(1s));
    return std::ranges::find(seen, "front", &TrackSighting::name)->seen;
  };
  EXPECT_TRUE(sees_front_within(std::nullopt));
  EXPECT_TRUE(sees_front_within(cv::Rect(200, 120, 300, 240)));
  EXPECT_FALSE(sees_front_within(cv::Rect(0, 0, 200, 200)));
  EXPECT_FALSE(sees_front_within(cv::Rect())) << "it is turned away";
}

TEST(Body, NothingIsSaidOfItsMarksWhereNoneIsSeenInThisLook) {
  std::vector<TrackSighting> marks = turned_marks(20);
  marks.push_back(sighting_of("left", Time(2s)));
  EXPECT_TRUE(areas_of_unseen(cube(), marks, Time(2s), cameras().focal_px).empty()) << "they are of a look before";
}

// Reads a cell file of so many bodies, each with so many marks at that distance. Answers the error's
// sentence, or nothing.
std::string fault_of_file(std::size_t bodies, std::size_t marks, double distance_mm) {
  std::string tagged;
  std::string defined;
  for (std::size_t body = 0; body < bodies; ++body) {
    defined += fmt::format("(body{}", body);
    for (std::size_t mark = 0; mark < marks; ++mark) {
      tagged += fmt::format("(m{}-{} apriltag-36h11 {} 40)", body, mark, body * marks + mark);
      defined += fmt::format(" (m{}-{} (0 0 {}) (0 0 0))", body, mark, distance_mm);
    }
    defined += ")";
  }
  const Result<forms::CellDescription> cell =
      forms::read_cell(fmt::format("(cell c (tagged {}) (bodies {}))", tagged, defined), "c");
  return cell ? "" : cell.error().sentence;
}

TEST(BodiesOfACell, HaveTheBoundsOfTheEyes) {
  EXPECT_EQ(fault_of_file(most_bodies, 1, farthest_on_a_body_mm), "");
  EXPECT_EQ(fault_of_file(1, most_marks_of_a_body, farthest_on_a_body_mm), "");
  const auto refuses = [](const std::string& fault, const std::string& why) {
    EXPECT_NE(fault.find(why), std::string::npos) << fault;
  };
  refuses(fault_of_file(most_bodies + 1, 1, 0), fmt::format("at most {} bodies", most_bodies));
  refuses(fault_of_file(1, most_marks_of_a_body + 1, 0), fmt::format("at most {} marks", most_marks_of_a_body));
  refuses(fault_of_file(1, 1, farthest_on_a_body_mm + 1), fmt::format("and {}", farthest_on_a_body_mm));
}

class Bodies : public PrintedTags {
 protected:
  Bodies() {
    show(17, {60, 60});
    show(3, {180, 120});
    options = {.objects_directory = "",
               .tagged = {{"lid", {"apriltag-36h11", 17}, side_mm()}, {"box", {"apriltag-36h11", 3}, side_mm()}}};
    live_with(options);
    run_for(1s);
  }
  // Both tags in one plane; the body's zero in the middle of the lid.
  std::string plate() const {
    const double mm_per_px = side_mm() / tag_px;
    return fmt::format(R"(("lid" (0 0 0) (0 0 0)) ("box" ({:.3f} {:.3f} 0) (0 0 0)))", 120 * mm_per_px, 60 * mm_per_px);
  }
  // What a look says of an object under that word.
  static std::string part(std::string_view word, const Datum& object) {
    for (const Datum& each : object.items()) {
      if (each.is_form(word)) return write(each);
    }
    return "";
  }
  VisionOptions options;
};

TEST_F(Bodies, AreToldAsOneObjectByAllOfTheirMarksInView) {
  EXPECT_EQ(call("(define-body (" + plate() + ") \"plate\")"), "()");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("plate")))x") << "its marks are no objects of their own";
  EXPECT_EQ(call("(track \"Plate\")"), "()");
  run_for(1s);
  const Datum look = form(facts("(look vision ? ? ?)"));
  EXPECT_TRUE(look[3].text().starts_with(R"x((TRACK 1 ("plate" OK ()x")) << look[3].text();
  ASSERT_EQ(look[4].size(), 1U);
  const Datum seen = look[4][0];
  EXPECT_EQ(part("by", seen), R"((by "box" "lid"))");
  const Datum pose = form(part("pose", seen));
  const double mm_per_px = side_mm() / tag_px;
  EXPECT_NEAR(pose[1].number(), (60 + 23.5 - camera.model().centre_x_px) * mm_per_px - 45, 1);
  EXPECT_NEAR(pose[2].number(), (60 + 23.5 - camera.model().centre_y_px) * mm_per_px, 1);
  EXPECT_NEAR(pose[3].number(), depth_mm(), 4);
  for (std::size_t angle = 4; angle < 7; ++angle) EXPECT_NEAR(pose[angle].number(), 0, 3);
  EXPECT_EQ(pose[7].size(), 21U);
}

TEST_F(Bodies, AreToldByTheMarksThatAreInView) {
  EXPECT_EQ(call("(define-body (" + plate() + ") \"plate\")"), "()");
  EXPECT_EQ(call("(track \"plate\")"), "()");
  camera.pictures.pop_back();
  run_for(1s);
  EXPECT_EQ(part("by", form(facts("(look vision ? ? ?)"))[4][0]), R"((by "lid"))");
  EXPECT_TRUE(call("(find \"plate\")").starts_with(R"x((FIND "plate" OK (83.)x")) << call("(find \"plate\")");
  camera.pictures.clear();
  run_for(1s);
  EXPECT_EQ(says(), R"x((TRACK 1 ("plate" FAIL)))x") << "nothing of it is in view";
  EXPECT_TRUE(call("(find \"plate\")").starts_with(R"x((FIND "plate" FAIL))x")) << call("(find \"plate\")");
}

TEST_F(Bodies, AMarkThatSomebodyTracksAsSuchIsToldBesideTheBody) {
  EXPECT_EQ(call("(define-body (" + plate() + ") \"plate\")"), "()");
  EXPECT_EQ(call("(track \"plate\")"), "()");
  EXPECT_EQ(call("(track \"lid\")"), "()");
  run_for(1s);
  EXPECT_TRUE(says().starts_with("(TRACK 2 ")) << says();
  EXPECT_NE(says().find("(\"lid\" OK ("), std::string::npos) << says();
  EXPECT_EQ(call("(end-track)"), "()");
  run_for(1s);
  EXPECT_EQ(says(), "nothing");
}

TEST_F(Bodies, OutliveTheEyesAndAreForgotten) {
  EXPECT_EQ(call("(define-body (" + plate() + ") \"plate\")"), "()");
  const std::string defined = facts("(body vision ? ?)");
  live_with(options);
  run_for(3s);
  EXPECT_EQ(facts("(body vision ? ?)"), defined);
  EXPECT_EQ(call("(track \"plate\")"), "()");
  EXPECT_TRUE(call("(forget-body \"plate\")").starts_with("busy ")) << "it is tracked";
  EXPECT_EQ(call("(end-track)"), "()");
  EXPECT_EQ(call("(forget-body \"plate\")"), "()");
  EXPECT_EQ(facts("(body vision ? ?)"), "");
  EXPECT_EQ(call("(get-objects)"), R"x((GET 2 ("lid", "box")))x");
  EXPECT_EQ(call("(forget-body \"plate\")"), "not-defined \"plate\"");
}

TEST_F(Bodies, OfTheCellFileTakeThePlaceOfWhatContradictsThem) {
  EXPECT_EQ(call(R"x((define-body (("lid" (0 0 0) (0 0 0))) "cover"))x"), "()");
  options.bodies = {{"plate", form("(" + plate() + ")")}};
  live_with(options);
  run_for(1s);
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("plate")))x");
  EXPECT_EQ(facts("(body vision \"cover\" ?)"), "");
  EXPECT_NE(facts("(body vision \"plate\" ?)"), "");
}

TEST_F(Bodies, OfTheCellFileThatCannotBeAreToldAndTheOthersAreKnown) {
  options.bodies = {{"cover", form(R"x((("star" (0 0 0) (0 0 0))))x")}, {"plate", form("(" + plate() + ")")}};
  live_with(options);
  run_for(1s);
  EXPECT_EQ(call("(get-objects)"), R"x((GET 1 ("plate")))x");
  EXPECT_NE(facts(R"x((vision-failed vision ? "(LEARN \"cover\" FAIL)" not-learned ?))x"), "");
}

TEST_F(Bodies, AreLearnedFromOtherEyes) {
  EXPECT_EQ(call("(define-body (" + plate() + ") \"plate\")"), "()");
  VisionLife other(executor, board, camera, &streams, {.objects_directory = ""}, "other-eyes");
  run_for(1s);
  EXPECT_EQ(call("(learn-from vision)", 20s, "other-eyes"), R"(("lid" "box"))");
  EXPECT_EQ(call("(get-objects)", 20s, "other-eyes"), R"x((GET 1 ("plate")))x");
}

TEST_F(Bodies, WhatIsRefusedIsSaidAndChangesNothing) {
  EXPECT_EQ(call("(define-body (" + plate() + ") \"plate\")"), "()");
  const std::string defined = facts("(body vision ? ?)");
  for (const char* marks :
       {"()", R"(("lid"))", R"((("lid" (0 0) (0 0 0))))", R"((("lid" (0 0 0) (0 0 x))))",
        R"((("lid" (0 0 2001) (0 0 0))))", R"((("lid" (0 0 0) (0 361 0))))", R"(((lid (0 0 0) (0 0 0))))"}) {
    const std::string answer = call(fmt::format("(define-body {} \"plate\")", marks));
    EXPECT_TRUE(answer.starts_with("malformed ")) << marks << ": " << answer;
  }
  const std::string lid = R"(("lid" (0 0 0) (0 0 0)))";
  EXPECT_TRUE(call("(define-body (" + lid + " " + lid + ") \"plate\")").starts_with("twice "));
  EXPECT_EQ(call("(define-body (" + lid + ") \"other\")"), "taken \"lid\"");
  EXPECT_EQ(call("(define-body (" + lid + ") \"box\")"), "name-taken \"box\"");
  EXPECT_EQ(call("(define-body (" + lid + ") \"a b\")"), "bad-name \"a b\"");
  EXPECT_EQ(call(R"x((define-body (("star" (0 0 0) (0 0 0))) "plate"))x"), "not-learned \"star\"");
  EXPECT_EQ(call("(rename \"lid\" \"cover\")"), "taken \"lid\"");
  EXPECT_EQ(call("(forget \"lid\")"), "taken \"lid\"");
  EXPECT_EQ(call("(forget \"plate\")"), "not-learned \"plate\"");
  EXPECT_EQ(call("(learn 80 60 \"plate\")"), "name-taken \"plate\"");
  EXPECT_EQ(facts("(body vision ? ?)"), defined);
}

}  // namespace
}  // namespace pizarra::vision
