#include <gtest/gtest.h>

#include "agents/coordinator/geometry/camera_watch.hpp"
#include "blackboard/time/random.hpp"

namespace pizarra::coordinator {
namespace {

const CameraModel model;
const Eigen::Vector3d usual_mark(30, 0, -66);

forms::CameraPose off_by(const forms::CameraPose& pose, double mm, double deg, Random& random) {
  forms::CameraPose off = pose;
  for (double& at : off.at_mm) at += random.uniform(-mm, mm);
  off.pan_deg += random.uniform(-deg, deg);
  off.tilt_deg += random.uniform(-deg, deg);
  off.roll_deg += random.uniform(-deg, deg);
  return off;
}

Eigen::Isometry3d somewhere(Random& random) {
  const Eigen::Vector3d at(random.uniform(340, 540), random.uniform(-180, 180), random.uniform(60, 310));
  return tool_pose(at, 180, 0, random.uniform(-30, 30));
}

MarkPair look(const forms::CameraPose& pose, const Eigen::Isometry3d& tool, double noise_px, Random& random,
              const Eigen::Vector3d& mark = usual_mark, HeadTurn head = {}) {
  const CameraView view(pose, model, head);
  const auto noise = [&] { return noise_px * random.normal(); };
  return {tool, head, seen_mark(view, tool * mark) + SeenMark(noise(), noise(), noise())};
}

std::vector<MarkPair> looks(const forms::CameraPose& pose, int many, double noise_px, Random& random,
                            const Eigen::Vector3d& mark = usual_mark) {
  std::vector<MarkPair> pairs;
  for (int i = 0; i < many; ++i) pairs.push_back(look(pose, somewhere(random), noise_px, random, mark));
  return pairs;
}

// Of points where the arm works.
double worst_mm(const forms::CameraPose& one, const forms::CameraPose& other) {
  double worst = 0;
  for (const double y : {-200.0, 200.0}) {
    for (const double z : {30.0, 250.0}) worst = std::max(worst, apart_mm(one, other, {450, y, z}));
  }
  return worst;
}

constexpr Sureness by_hand{.at_mm = 20, .turned_deg = 2, .mark_mm = 0.5};

TEST(MountFit, FindsACameraThatStandsElsewhereWithinAMillimetreWithoutNoise) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const forms::CameraPose truth = off_by({}, 100, 10, random);
    const MountedCamera guess{off_by(truth, 30, 3, random), usual_mark};
    const MountFit fit =
        fit_mount(guess, {.at_mm = 500, .turned_deg = 20, .mark_mm = 0.1}, looks(truth, 8, 0, random), model);
    EXPECT_LT(worst_mm(truth, fit.camera.pose), 0.1);
    EXPECT_LT(fit.error_px, 0.02);
  }
}

TEST(PoseFromPairs, NeedsNoGuess) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const forms::CameraPose truth = off_by({}, 200, 25, random);
    const std::vector<MarkPair> pairs = looks(truth, 12, 0, random);
    const std::optional<forms::CameraPose> found = pose_from_pairs(usual_mark, pairs, model);
    ASSERT_TRUE(found);
    EXPECT_LT(worst_mm(truth, *found), 0.01);
  }
}

TEST(PoseFromPairs, IsNotToldByPlacesAlongALine) {
  Random random(1);
  std::vector<MarkPair> pairs;
  for (int i = 0; i < 6; ++i) pairs.push_back(look({}, tool_pose({450, -100 + 40.0 * i, 300}, 180, 0, 0), 0, random));
  EXPECT_FALSE(pose_from_pairs(usual_mark, pairs, model));
  EXPECT_FALSE(pose_from_pairs(usual_mark, looks({}, 3, 0, random), model));
}

TEST(MountFit, SaysHowFarItMayBeOff) {
  int beyond = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const forms::CameraPose truth = off_by({}, 50, 5, random);
    const MountedCamera guess{off_by(truth, 20, 2, random), usual_mark};
    const MountFit fit = fit_mount(guess, by_hand, looks(truth, 12, 0.3, random), model);
    EXPECT_LT(worst_mm(truth, fit.camera.pose), 8);
    for (const double y : {-200.0, 200.0}) {
      const Eigen::Vector3d point(450, y, 30);
      beyond += apart_mm(truth, fit.camera.pose, point) > 2.5 * fit.spread_mm(point) ? 1 : 0;
    }
  }
  EXPECT_LE(beyond, 12) << "of 400";
}

TEST(MountFit, IsNotMisledByLooksAtSomethingElse) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const forms::CameraPose truth = off_by({}, 50, 5, random);
    const MountedCamera guess{off_by(truth, 20, 2, random), usual_mark};
    std::vector<MarkPair> pairs = looks(truth, 16, 0.2, random);
    for (int i = 0; i < 4; ++i) {
      pairs[4 * i].seen += SeenMark(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-8, 8));
    }
    EXPECT_LT(worst_mm(truth, fit_mount(guess, by_hand, pairs, model).camera.pose), 8);
  }
}

TEST(MountFit, KeepsWhatPairsOnALineLeaveOpen) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const forms::CameraPose truth;
    const MountedCamera guess{off_by(truth, 10, 1, random), usual_mark};
    std::vector<MarkPair> pairs;
    for (int i = 0; i < 8; ++i) {
      pairs.push_back(look(truth, tool_pose({450, -150.0 + 40 * i, 300}, 180, 0, 0), 0.2, random));
    }
    const MountFit fit = fit_mount(guess, by_hand, pairs, model);
    const Eigen::Vector3d on_line(480, 0, 366);
    const Eigen::Vector3d aside(480, 0, 30);
    EXPECT_LT(fit.spread_mm(on_line), 3);
    EXPECT_GT(fit.spread_mm(aside), 3) << "a turn about the line is not seen";
    EXPECT_LT(worst_mm(truth, fit.camera.pose), 1.5 * worst_mm(truth, guess.pose) + 3);
  }
}

TEST(MountFit, FindsWhereTheMarkIsOnTheToolWhenTheToolTurns) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const forms::CameraPose truth = off_by({}, 50, 5, random);
    const Eigen::Vector3d mark = usual_mark + Eigen::Vector3d(random.uniform(-6, 6), random.uniform(-6, 6), 0);
    const MountedCamera guess{off_by(truth, 20, 2, random), usual_mark};
    const MountFit fit =
        fit_mount(guess, {.at_mm = 300, .turned_deg = 15, .mark_mm = 20}, looks(truth, 20, 0, random, mark), model);
    EXPECT_LT((fit.camera.mark_mm - mark).head<2>().norm(), 0.5);
  }
}

TEST(MountFit, TakesTheHeadsTurnOffAgain) {
  Random random(3);
  const forms::CameraPose truth = off_by({}, 50, 5, random);
  std::vector<MarkPair> pairs;
  for (int i = 0; i < 10; ++i) {
    const HeadTurn head{random.uniform(-8, 8), random.uniform(-4, 4)};
    pairs.push_back(look(truth, somewhere(random), 0, random, usual_mark, head));
  }
  const MountFit fit = fit_mount({off_by(truth, 20, 2, random), usual_mark}, by_hand, pairs, model);
  EXPECT_LT(worst_mm(truth, fit.camera.pose), 1);
}

// The arm stops here and there, and a few looks are made each time.
// By so much, while the mark of a tool there is seen where it was.
forms::CameraPose rolled_about(forms::CameraPose pose, double deg, const Eigen::Isometry3d& tool, Random& random) {
  const auto seen = [&](double pan_deg, double tilt_deg) {
    forms::CameraPose turned = pose;
    turned.pan_deg += pan_deg;
    turned.tilt_deg += tilt_deg;
    return Eigen::Vector2d(look(turned, tool, 0, random).seen.head<2>());
  };
  const Eigen::Vector2d before = seen(0, 0);
  pose.roll_deg += deg;
  for (int step = 0; step < 5; ++step) {
    constexpr double little = 0.01;
    Eigen::Matrix2d slope;
    slope << (seen(little, 0) - seen(0, 0)) / little, (seen(0, little) - seen(0, 0)) / little;
    const Eigen::Vector2d turn = slope.inverse() * (before - seen(0, 0));
    pose.pan_deg += turn.x();
    pose.tilt_deg += turn.y();
  }
  return pose;
}

class Watched {
 public:
  Watched(const forms::CameraPose& truth, const forms::BelievedCamera& believed, std::uint64_t seed)
      : random(seed), stands(truth), watch(believed, {}) {}

  std::vector<CameraWatch::News> stop_at(const Eigen::Isometry3d& tool, int looks = 4) {
    std::vector<CameraWatch::News> news;
    for (int i = 0; i < looks; ++i) {
      const CameraWatch::News told = watch.take(look(stands, tool, 0.15, random), model);
      if (told != CameraWatch::News::nothing) news.push_back(told);
    }
    return news;
  }

  Random random;
  forms::CameraPose stands;
  CameraWatch watch;
};

using News = CameraWatch::News;

TEST(CameraWatch, OfACameraThatStandsWhereItIsSaidToTellsNothing) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(seed);
    Watched cell({}, {}, seed);
    for (int i = 0; i < 40; ++i) EXPECT_TRUE(cell.stop_at(somewhere(cell.random)).empty());
    EXPECT_TRUE(cell.watch.known());
    EXPECT_EQ(cell.watch.pose(), forms::CameraPose());
  }
}

TEST(CameraWatch, CorrectsAGuessAndIsKnownThen) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Watched cell(off_by({}, 20, 2, random), {.pose = {}, .sure_mm = 20, .sure_deg = 2}, seed);
    EXPECT_FALSE(cell.watch.known());
    for (int i = 0; i < 8; ++i) {
      for (const News news : cell.stop_at(somewhere(cell.random))) EXPECT_EQ(news, News::corrected);
    }
    EXPECT_TRUE(cell.watch.known());
    EXPECT_LT(worst_mm(cell.stands, cell.watch.pose()), 6);
  }
}

TEST(CameraWatch, NoticesABumpDoubtsItAndFindsTheCameraAgain) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(seed);
    Watched cell({}, {}, seed);
    for (int i = 0; i < 6; ++i) cell.stop_at(somewhere(cell.random));
    cell.stands.at_mm[1] += 25;
    cell.stands.pan_deg -= 1;
    cell.stands.tilt_deg += 2;
    const Eigen::Isometry3d here = somewhere(cell.random);
    EXPECT_EQ(cell.stop_at(here, 10), std::vector{News::doubtful});
    EXPECT_FALSE(cell.watch.known());
    EXPECT_EQ(cell.watch.pose(), forms::CameraPose()) << "the arm's word may be old";
    Eigen::Isometry3d there = here;
    there.translation() += Eigen::Vector3d(0, here.translation().y() > 0 ? -120 : 120, 0);
    const std::vector<News> news = cell.stop_at(there);
    ASSERT_FALSE(news.empty());
    EXPECT_EQ(news.front(), News::moved);
    for (int i = 0; i < 8; ++i) cell.stop_at(somewhere(cell.random));
    EXPECT_TRUE(cell.watch.known());
    EXPECT_LT(worst_mm(cell.stands, cell.watch.pose()), 6);
  }
}

// It was turned about the line of sight to a place, and shows the mark there as before.
TEST(CameraWatch, NoticesABumpOfWhichOnePlaceShowsNothing) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(seed);
    Watched cell({}, {}, seed);
    for (int i = 0; i < 6; ++i) cell.stop_at(somewhere(cell.random));
    const auto at = [](double x_mm, double y_mm, double z_mm) { return tool_pose({x_mm, y_mm, z_mm}, 180, 0, 0); };
    const Eigen::Isometry3d blind = at(450, 0, 300);
    cell.stands = rolled_about(cell.stands, 3, blind, cell.random);
    const Eigen::Isometry3d others[] = {at(460, 160, 300), at(460, 160, 200), at(460, 160, 120)};
    for (int stop = 0; stop < 4; ++stop) {
      for (const Eigen::Isometry3d& other : others) cell.stop_at(other, 2);
      cell.stop_at(blind);
      EXPECT_TRUE(!cell.watch.known() || worst_mm(cell.stands, cell.watch.pose()) < 15);
    }
    for (int i = 0; i < 8; ++i) cell.stop_at(somewhere(cell.random));
    EXPECT_TRUE(cell.watch.known());
    EXPECT_LT(worst_mm(cell.stands, cell.watch.pose()), 6);
  }
}

TEST(CameraWatch, FindsACameraThatIsBumpedAgainWhileItIsInDoubt) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(seed);
    Watched cell({}, {}, seed);
    for (int i = 0; i < 6; ++i) cell.stop_at(somewhere(cell.random));
    cell.stands.pan_deg += 2;
    cell.stop_at(somewhere(cell.random), 10);
    cell.stands.at_mm[1] += 25;
    cell.stands.roll_deg += 1;
    for (int i = 0; i < 10; ++i) cell.stop_at(somewhere(cell.random));
    EXPECT_TRUE(cell.watch.known());
    EXPECT_LT(worst_mm(cell.stands, cell.watch.pose()), 6);
  }
}

// The arm was stopped a little before the second place, and its word was from the motion.
TEST(CameraWatch, KnowsNoPoseThatOneWrongLookAmongThreeBends) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(seed);
    Watched cell({}, {}, seed);
    for (int i = 0; i < 6; ++i) cell.stop_at(somewhere(cell.random));
    cell.stands = off_by({}, 15, 1.5, cell.random);
    const auto at = [](double x_mm, double y_mm, double z_mm) { return tool_pose({x_mm, y_mm, z_mm}, 180, 0, 0); };
    cell.stop_at(at(360, -160, 300));
    for (int i = 0; i < 10; ++i) {
      MarkPair late = look(cell.stands, at(500, 160, 280), 0.15, cell.random);
      late.tool = at(500, 160, 300);
      cell.watch.take(late, model);
    }
    const Eigen::Isometry3d places[] = {at(360, 160, 300),  at(500, -160, 200), at(360, 0, 200),   at(500, 0, 300),
                                        at(360, -160, 200), at(500, 160, 300),  at(360, -160, 300)};
    for (int stop = 0; stop < 14; ++stop) {
      cell.stop_at(places[stop % std::size(places)]);
      EXPECT_TRUE(!cell.watch.known() || worst_mm(cell.stands, cell.watch.pose()) < 15);
    }
    EXPECT_TRUE(cell.watch.known());
    EXPECT_LT(worst_mm(cell.stands, cell.watch.pose()), 6);
  }
}

TEST(CameraWatch, ForgivesAnOldWordOfTheArm) {
  Watched cell({}, {}, 1);
  const Eigen::Isometry3d here = tool_pose({450, -100, 300}, 180, 0, 0);
  const Eigen::Isometry3d there = tool_pose({450, 100, 300}, 180, 0, 0);
  cell.stop_at(here);
  for (int i = 0; i < 10; ++i) {
    MarkPair late = look({}, there, 0, cell.random);
    late.tool = here;
    cell.watch.take(late, model);
  }
  EXPECT_TRUE(cell.watch.doubtful());
  cell.stop_at(there, 1);
  EXPECT_TRUE(cell.watch.known());
  EXPECT_EQ(cell.watch.pose(), forms::CameraPose());
}

TEST(CameraWatch, ForgivesLooksAtAnotherMarkForAMoment) {
  Watched cell({}, {}, 1);
  const Eigen::Isometry3d here = tool_pose({450, -100, 300}, 180, 0, 0);
  cell.stop_at(here);
  for (int i = 0; i < 3; ++i) {
    MarkPair other = look({}, here, 0, cell.random);
    other.seen.x() += 50;
    EXPECT_EQ(cell.watch.take(other, model), News::nothing);
  }
  EXPECT_TRUE(cell.watch.known());
}

}  // namespace
}  // namespace pizarra::coordinator
