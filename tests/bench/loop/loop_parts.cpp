#include "tests/bench/loop/loop_parts.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

#include "agents/planner/agent/planner_forms.hpp"
#include "agents/planner/agent/running_plan.hpp"
#include "agents/planner/agent/shortest_way.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "drivers/simulation/face_mark.hpp"
#include "lisp/forms/domain.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/vision/scene.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::bench {

namespace {

constexpr const char* family = "aruco-4x4-50";
constexpr int looks = 60;
constexpr int first_counted = 6;
constexpr int plans = 5;
constexpr int choices = 200;

cv::Mat1b dark_cells(int number) {
  const auto mark = simulation::face_mark_from_name(fmt::format("{}-{}", family, number));
  const simulation::TagPrint& print = *std::get<simulation::TagMark>(mark.value()).print;
  cv::Mat1b cells(print.side, print.side);
  for (int row = 0; row < print.side; ++row) {
    for (int column = 0; column < print.side; ++column) cells(row, column) = print.is_light(column, row) ? 0 : 255;
  }
  return cells;
}

// Four in a row.
Scene tags_in_rows(int objects) {
  constexpr int in_a_row = 4;
  Scene scene;
  for (int i = 0; i < objects; ++i) {
    const int row = i / in_a_row;
    const cv::Point2d centre(80.3 + 60.2 * (i % in_a_row), 40.4 + 75.2 * row);
    scene.marks.push_back({.name = fmt::format("c{}", i), .centre = centre, .tag = dark_cells(i)});
  }
  return scene;
}

vision::LearnedObjects learned(const Scene& scene) {
  vision::LearnedObjects out;
  for (std::size_t i = 0; i < scene.marks.size(); ++i) {
    vision::LearnedSample sample;
    sample.number = 1;
    sample.tag = vision::Tag{family, static_cast<int>(i)};
    out.add(scene.marks[i].name, std::move(sample));
  }
  return out;
}

struct Pair {
  cv::Mat1b left;
  cv::Mat1b right;
};

std::vector<Pair> pairs_of(const Scene& scene) {
  Random random(1);
  std::vector<Pair> out;
  for (const double step : {0.0, 1.3, 3.1, 4.7, 3.6, 1.8}) {
    Scene moved = scene;
    for (SceneMark& mark : moved.marks) mark.centre += cv::Point2d(-step, 0.5 * step);
    const cv::Mat1b left = draw(moved, Side::left, random);
    out.push_back({left, draw(moved, Side::right, random)});
  }
  return out;
}

// Without the goals, which a plan is asked for with.
planner::PlanningTask cubes_on_the_table(int objects) {
  const forms::Domain domain = forms::read_domain_file(source_dir() + "/domains/blocks.scm").value();
  std::vector<Datum> operators;
  for (const forms::Operator& each : domain.operators) operators.push_back(forms::operator_form(each));
  planner::PlanningTask task;
  task.operators = planner::operators_from_list(Datum::list(std::move(operators))).value();
  task.initials.push_back(list("arm-empty"_sym));
  for (int i = 0; i < objects; ++i) {
    const Datum cube = Datum::symbol(fmt::format("c{}", i));
    task.objects.push_back({cube, "OBJECT"});
    task.initials.push_back(list("on-table"_sym, cube));
    task.initials.push_back(list("clear"_sym, cube));
    task.initials.push_back(list("bare"_sym, cube));
  }
  return task;
}

std::vector<Datum> tower_goal(int tower) {
  std::vector<Datum> goals;
  for (int i = 1; i < tower; ++i) {
    goals.push_back(list("on"_sym, Datum::symbol(fmt::format("c{}", i)), Datum::symbol(fmt::format("c{}", i - 1))));
  }
  return goals;
}

// The thread's median time of so many.
double median_seconds(int rounds, const std::function<void()>& work) {
  std::vector<double> seconds;
  for (int i = 0; i < rounds; ++i) seconds.push_back(thread_seconds_of(work));
  return percentile(seconds, 0.5);
}

}  // namespace

std::optional<double> look_seconds(int objects) {
  if (objects > most_looked_at) return std::nullopt;
  const Scene scene = tags_in_rows(objects);
  const vision::LearnedObjects known = learned(scene);
  const std::vector<Pair> pairs = pairs_of(scene);
  vision::MarkTracker tracker(known);
  for (const vision::LearnedObject& object : known.all()) {
    if (!tracker.add(object)) return std::nullopt;
  }
  std::vector<double> seconds;
  Time now = {};
  for (int i = 0; i < looks; ++i) {
    const Pair& pair = pairs[static_cast<std::size_t>(i) % pairs.size()];
    std::vector<vision::TrackSighting> sightings;
    const double took_s = thread_seconds_of([&] {
      vision::StereoSight sight(pair.left, pair.right, scene_camera());
      sightings = tracker.update(sight, now += 100ms);
    });
    if (!std::ranges::all_of(sightings, &vision::TrackSighting::seen)) return std::nullopt;
    if (i >= first_counted) seconds.push_back(took_s);
  }
  return percentile(seconds, 0.5);
}

PlanSeconds plan_seconds(int objects, int tower) {
  const planner::PlanningTask task = cubes_on_the_table(objects);
  const std::vector<Datum> goals = tower_goal(tower);
  std::optional<planner::ShortestWay> found;
  PlanSeconds out;
  out.plan = median_seconds(plans, [&] {
    planner::Replanner replanner;
    const Result<planner::ShortestWay> plan =
        planner::plan_shortest_way(replanner, task, goals, planner::Budget{}, [] { return false; });
    if (!plan) throw std::runtime_error(describe(plan.error()));
    found = *plan;
  });
  const planner::RunningPlan running(1, planner::operations_of(found->plan.steps), task.operators, goals);
  const planner::RunningPlan::Facts believed(task.initials.begin(), task.initials.end());
  out.choose = median_seconds(choices, [&] {
    if (running.next(believed) != 0) throw std::runtime_error("the plan does not begin with its first operation");
  });
  return out;
}

}  // namespace pizarra::bench
