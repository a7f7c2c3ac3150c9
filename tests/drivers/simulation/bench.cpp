#include "tests/drivers/simulation/bench.hpp"

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::simulation {

namespace {

constexpr Duration patience = 20s;
constexpr double travel_mm = 300;

}  // namespace

Bench::Bench(WorldConfig the_config)
    : config(std::move(the_config)),
      world(executor, config),
      link(world),
      arm(link),
      eyes(executor, link),
      at_(config.start_joints.value_or(config.arm.ready)) {
  EXPECT_TRUE(check(config));
  EXPECT_TRUE(run(executor, arm.take_control()));
}

Datum Bench::ask(std::string_view request) {
  const Result<Message> answer = run(executor, link.call(*read_one(request), patience));
  EXPECT_TRUE(answer) << request << ": " << (answer ? "" : describe(answer.error()));
  return answer ? answer->head : Datum();
}

std::string Bench::outcome(std::string_view request) {
  const Result<Message> answer = run(executor, link.call(*read_one(request), patience));
  return answer ? "ok" : answer.error().symbol;
}

TruthOf Bench::truth(std::string_view cube) {
  const Datum all = ask("(truth)");
  for (const Datum& item : all.items()) {
    const bool is_body = item.is_form("cube") || item.is_form("thing");
    if (!is_body || !item[1].is_symbol(cube)) continue;
    const double visible = item.is_form("cube") ? item[8].number() : 0;
    return {item[2].number(), item[3].number(), item[4].number(), item[5].number(),
            item[6].number(), write(item[7]),   visible};
  }
  ADD_FAILURE() << "no cube " << cube;
  return {};
}

std::string Bench::facts() {
  const Datum all = ask("(truth)");
  return write(all.items().back());
}

camera::StereoFrame Bench::frame(bool colour) {
  const Result<camera::StereoFrame> frame = run(executor, eyes.next(last_frame_, colour));
  EXPECT_TRUE(frame);
  if (frame) last_frame_ = frame->captured;
  return frame.value_or(camera::StereoFrame());
}

arm::Joints Bench::tool_down(double x_mm, double y_mm, double z_mm) const {
  arm::ToolPose pose = arm::ToolPose::Identity();
  pose.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  pose.translation() = Eigen::Vector3d(x_mm, y_mm, z_mm);
  const Result<arm::Joints> joints = arm::inverse(config.arm, pose, at_);
  EXPECT_TRUE(joints) << x_mm << " " << y_mm << " " << z_mm;
  return joints.value_or(at_);
}

arm::ArmReading Bench::reading() {
  const Result<arm::ArmReading> reading = run(executor, arm.read());
  EXPECT_TRUE(reading);
  return reading.value_or(arm::ArmReading());
}

bool Bench::go(double x_mm, double y_mm, double z_mm, double speed) {
  const Eigen::Vector3d from = arm::forward(config.arm, at_).translation();
  const Eigen::Vector3d to(x_mm, y_mm, z_mm);
  std::vector<arm::Joints> path;
  for (int i = 1; i <= 20; ++i) {
    const Eigen::Vector3d point = from + (to - from) * i / 20.0;
    path.push_back(tool_down(point.x(), point.y(), point.z()));
  }
  const Result<void> started = run(executor, arm.start_move(path, speed));
  EXPECT_TRUE(started) << (started ? "" : describe(started.error()));
  arm::ArmReading now = reading();
  for (int polls = 0; now.moving && polls < 2000; ++polls) {
    wait(10ms);
    now = reading();
  }
  EXPECT_FALSE(now.moving);
  at_ = now.joints;
  return !now.stopped;
}

double Bench::grip(double opening_mm) {
  EXPECT_TRUE(run(executor, arm.start_gripper(opening_mm)));
  arm::ArmReading now = reading();
  for (int polls = 0; now.gripper_moving && polls < 500; ++polls) {
    wait(10ms);
    now = reading();
  }
  EXPECT_FALSE(now.gripper_moving);
  return now.opening_mm;
}

void Bench::pick(double x_mm, double y_mm, double z_mm, std::optional<double> edge_mm) {
  grip(gripper_opening_mm);
  EXPECT_TRUE(go(x_mm, y_mm, travel_mm));
  EXPECT_TRUE(go(x_mm, y_mm, z_mm, 0.2));
  EXPECT_NEAR(grip(0), edge_mm.value_or(config.cube_mm), 2);
  EXPECT_TRUE(go(x_mm, y_mm, travel_mm, 0.2));
}

void Bench::put(double x_mm, double y_mm, double z_mm) {
  EXPECT_TRUE(go(x_mm, y_mm, travel_mm));
  EXPECT_TRUE(go(x_mm, y_mm, z_mm + 1.5, 0.15));
  grip(gripper_opening_mm);
  EXPECT_TRUE(go(x_mm, y_mm, travel_mm, 0.2));
  wait(300ms);
}

WorldConfig four_cubes() {
  WorldConfig config;
  config.cubes = {{.name = "circle", .mark = Mark::circle, .x_mm = 450, .y_mm = -150},
                  {.name = "cross", .mark = Mark::cross, .x_mm = 450, .y_mm = -50},
                  {.name = "square", .mark = Mark::square, .x_mm = 450, .y_mm = 50},
                  {.name = "triangle", .mark = Mark::triangle, .x_mm = 450, .y_mm = 150}};
  return config;
}

}  // namespace pizarra::simulation
