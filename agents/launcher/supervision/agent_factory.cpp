#include "agents/launcher/supervision/agent_factory.hpp"

#include <fmt/format.h>

#include "agents/coordinator/coordinator_agent.hpp"
#include "agents/person/person_agent.hpp"
#include "agents/planner/planner_agent.hpp"
#include "agents/robot/robot_agent.hpp"
#include "agents/vision/vision_agent.hpp"
#include "drivers/simulation/simulated_arm.hpp"
#include "drivers/simulation/simulated_camera.hpp"

namespace pizarra {

namespace {

// An agent and the device it owns, if any: the device is there before it and after it.
template <class A, class Device>
class WithDevice : public BuiltAgent {
 public:
  template <class Make>
  WithDevice(Link& link, Make make) : device_(link), agent_(make(device_)) {}

 private:
  Agent& agent() override { return *agent_; }
  Device device_;
  std::unique_ptr<A> agent_;
};

class WithoutDevice : public BuiltAgent {
 public:
  explicit WithoutDevice(std::unique_ptr<Agent> agent) : agent_(std::move(agent)) {}

 private:
  Agent& agent() override { return *agent_; }
  std::unique_ptr<Agent> agent_;
};

CoordinatorOptions coordinator_options(const CellDescription& description) {
  CoordinatorOptions options;
  options.domain_file = description.domain_file;
  options.camera = description.camera;
  options.cube_mm = description.cube_mm;
  options.gripper.openings = description.openings;
  options.row = description.row;
  return options;
}

std::unique_ptr<BuiltAgent> build_person(AgentContext context, const CellDescription& description, Link& link) {
  std::vector<std::string> names;
  for (const CubePlacement& cube : description.cubes) names.push_back(cube.name);
  return std::make_unique<WithoutDevice>(std::make_unique<PersonAgent>(std::move(context), link, std::move(names)));
}

}  // namespace

const std::vector<std::string>& agent_kinds() {
  static const std::vector<std::string> kinds{"robot", "vision", "planner", "coordinator", "person"};
  return kinds;
}

WorldConfig world_config(const CellDescription& description, std::uint64_t seed) {
  WorldConfig config;
  config.seed = seed;
  config.cube_mm = description.cube_mm;
  CameraConfig& camera = config.camera;
  camera.pose = description.camera;
  camera.noise_sigma = description.noise.sensor_grey;
  camera.blur_sigma_px = description.noise.blur_px;
  camera.light_gradient = description.noise.gradient;
  for (const CubePlacement& cube : description.cubes) {
    const Mark mark = mark_from_name(cube.mark).value_or(Mark::circle);
    config.cubes.push_back({cube.name, mark, cube.x_mm, cube.y_mm, cube.yaw_deg, cube.on});
  }
  return config;
}

Task<void> BuiltAgent::run() {
  Result<void> ended = co_await agent().run();
  ended_ = std::move(ended);
}

Result<std::unique_ptr<BuiltAgent>> build_agent(const std::string& kind, AgentContext context,
                                                const CellDescription& description, Link& link, Streams* streams) {
  if (kind == "robot") {
    return std::make_unique<WithDevice<RobotAgent, SimulatedArm>>(
        link, [&](SimulatedArm& arm) { return std::make_unique<RobotAgent>(std::move(context), arm); });
  }
  if (kind == "vision") {
    return std::make_unique<WithDevice<VisionAgent, SimulatedCamera>>(link, [&](SimulatedCamera& camera) {
      return std::make_unique<VisionAgent>(std::move(context), camera, streams);
    });
  }
  if (kind == "planner") {
    return std::make_unique<WithoutDevice>(std::make_unique<PlannerAgent>(std::move(context)));
  }
  if (kind == "coordinator") {
    return std::make_unique<WithoutDevice>(
        std::make_unique<CoordinatorAgent>(std::move(context), coordinator_options(description)));
  }
  if (kind == "person") return build_person(std::move(context), description, link);
  return fail("unknown-agent", fmt::format("there is no agent {}", kind), Datum::symbol(kind));
}

}  // namespace pizarra
