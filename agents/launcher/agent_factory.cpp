#include "agents/launcher/agent_factory.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

#include "agents/coordinator/pursue/coordinator_agent.hpp"
#include "agents/follower/follower_agent.hpp"
#include "agents/launcher/cell_arm.hpp"
#include "agents/pan_tilt/pan_tilt_agent.hpp"
#include "agents/person/person_agent.hpp"
#include "agents/planner/agent/planner_agent.hpp"
#include "agents/robot/robot_agent.hpp"
#include "agents/scheme/scheme_agent.hpp"
#include "agents/speech/speech_agent.hpp"
#include "agents/vision/agent/vision_agent.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/camera/video_camera.hpp"
#include "drivers/line/serial_wire.hpp"
#include "drivers/line/tcp_wire.hpp"
#include "drivers/ptu/ptu_driver.hpp"
#include "drivers/simulation/head_wire.hpp"
#include "drivers/simulation/simulated_camera.hpp"
#include "lisp/nearest.hpp"

namespace pizarra::launcher {

namespace {

class WithoutDevice : public BuiltAgent {
 public:
  explicit WithoutDevice(std::unique_ptr<runtime::Agent> agent) : agent_(std::move(agent)) {}

 private:
  runtime::Agent& agent() override { return *agent_; }
  std::unique_ptr<runtime::Agent> agent_;
};

class BuiltRobot : public BuiltAgent {
 public:
  BuiltRobot(runtime::AgentContext context, const forms::ArmLine& line, const arm::ArmModel& model,
             robot::RobotOptions options, simulation::Link& link, std::string_view simulated)
      : device_(make_cell_arm(context.executor, line, model, link, simulated)),
        agent_(std::move(context), device_->driver(), model, options) {}
  Task<void> stand_still() override { return agent_.stand_still(); }

 private:
  runtime::Agent& agent() override { return agent_; }
  std::unique_ptr<CellArm> device_;
  robot::RobotAgent agent_;
};

// The agent, its driver, and the line to its unit: the simulated one's where the cell names no other.
class BuiltPanTilt : public BuiltAgent {
 public:
  BuiltPanTilt(runtime::AgentContext context, const forms::CellDescription& description, simulation::Link& link)
      : wire_(make_wire(context.executor, description.pan_tilt, link)),
        driver_(context.executor, *wire_, {description.pan_tilt.pan_reversed, description.pan_tilt.tilt_reversed}),
        agent_(std::move(context), driver_, description.camera.pose) {}

 private:
  static std::unique_ptr<line::ByteWire> make_wire(Executor& executor, const forms::PanTiltLine& line,
                                                   simulation::Link& link) {
    if (line.kind == "serial") return std::make_unique<line::SerialWire>(executor, line.where, line.number);
    if (line.kind == "tcp") {
      return std::make_unique<line::TcpWire>(executor, line.where, static_cast<std::uint16_t>(line.number));
    }
    return std::make_unique<simulation::HeadWire>(executor, link);
  }
  runtime::Agent& agent() override { return agent_; }

  std::unique_ptr<line::ByteWire> wire_;
  ptu::PtuDriver driver_;
  pan_tilt::PanTiltAgent agent_;
};

// The agent, and the eyes that it looks through.
class BuiltVision : public BuiltAgent {
 public:
  BuiltVision(runtime::AgentContext context, std::unique_ptr<camera::StereoCamera> camera, Streams* streams,
              vision::VisionOptions options)
      : camera_(std::move(camera)), agent_(std::move(context), *camera_, streams, std::move(options)) {}

 private:
  runtime::Agent& agent() override { return agent_; }

  std::unique_ptr<camera::StereoCamera> camera_;
  vision::VisionAgent agent_;
};

coordinator::CoordinatorOptions coordinator_options(const forms::CellDescription& description) {
  coordinator::CoordinatorOptions options;
  options.domain_file = description.domain_file;
  options.camera = description.camera;
  options.gripper.mark_before_grip_mm = description.camera.mark_mm[0];
  options.gripper.mark_above_grip_mm = -description.camera.mark_mm[2];
  options.head = has_pan_tilt(description);
  options.cube_mm = description.cube_mm;
  options.edges_mm = description.edges_mm();
  options.gripper.openings = description.openings;
  options.row = description.row;
  options.open_loop = description.open_loop;
  return options;
}

std::optional<robot::Room> room_from(const std::optional<forms::CellRoom>& given) {
  if (!given) return {};
  const auto& [low, high] = *given;
  return robot::Room{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

// The second arm's robot agent, or the one that has it follow the first.
Result<std::unique_ptr<BuiltAgent>> build_second(const std::string& kind, runtime::AgentContext context,
                                                 const forms::CellSlave& slave, simulation::Link& link) {
  if (kind == "follower") {
    const auto& [x_mm, y_mm, z_mm] = slave.offset_mm;
    const follower::FollowerOptions options{.offset_mm = {x_mm, y_mm, z_mm}, .mirrored = slave.mirrored};
    return std::make_unique<WithoutDevice>(std::make_unique<follower::FollowerAgent>(std::move(context), options));
  }
  const Result<arm::ArmModel> model = arm::read_arm_file(slave.arm_file);
  if (!model) return fail(model);
  return std::make_unique<BuiltRobot>(std::move(context), slave.line, *model,
                                      robot::RobotOptions{room_from(slave.room), slave.rate_hz, "second-arms"}, link,
                                      "second-arm");
}

scheme::SchemeOptions scheme_options(const forms::CellSchemeAgent& agent) {
  return {.file = agent.file,
          .limits = {.time = std::chrono::milliseconds(agent.time_ms), .memory_mb = agent.memory_mb},
          .messages_per_s = agent.messages_per_s,
          .log = nullptr};
}

std::unique_ptr<BuiltAgent> build_person(runtime::AgentContext context, const forms::CellDescription& description,
                                         simulation::Link& link) {
  std::vector<std::string> names;
  for (const forms::CubePlacement& cube : description.cubes) names.push_back(cube.name);
  return std::make_unique<WithoutDevice>(
      std::make_unique<person::PersonAgent>(std::move(context), link, std::move(names)));
}

bool has_agent(const forms::CellDescription& description, const std::string& kind) {
  const std::vector<std::string> named = named_agents(description);
  return std::ranges::find(named, kind) != named.end();
}

// In the order in which they are listed.
constexpr const char* usual_kinds[] = {"robot", "vision", "pan-tilt", "planner", "coordinator", "person"};
// A cell has these only where its file says so.
constexpr const char* further_kinds[] = {"speech", "slave", "follower"};

}  // namespace

std::string kind_of_agent(const std::string& name) {
  const std::size_t dash = name.rfind('-');
  const std::string_view number = std::string_view(name).substr(dash == std::string::npos ? name.size() : dash + 1);
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return !number.empty() && std::ranges::all_of(number, digit) ? name.substr(0, dash) : name;
}

std::string kind_fault(const std::string& name) {
  const std::string typed = kind_of_agent(name);
  std::vector<std::string> kinds(std::begin(usual_kinds), std::end(usual_kinds));
  kinds.insert(kinds.end(), std::begin(further_kinds), std::end(further_kinds));
  if (std::ranges::find(kinds, typed) != kinds.end()) return {};
  const std::string near = nearest_name(typed, kinds);
  return near.empty() ? fmt::format("there is no agent {}; there are {}", typed, fmt::join(kinds, ", "))
                      : fmt::format("there is no agent {}; did you mean {}?", typed, near);
}

std::vector<std::string> agent_kinds(const forms::CellDescription& description) {
  std::vector<std::string> kinds(std::begin(usual_kinds), std::end(usual_kinds));
  if (!has_pan_tilt(description)) std::erase(kinds, "pan-tilt");
  if (!description.eyes.is_simulated()) std::erase(kinds, "person");
  for (const char* kind : further_kinds) {
    if (has_agent(description, kind)) kinds.push_back(kind);
  }
  for (const std::string& name : named_agents(description)) {
    if (kind_of_agent(name) != name || forms::scheme_agent_called(description, name)) kinds.push_back(name);
  }
  return kinds;
}

std::vector<std::string> named_agents(const forms::CellDescription& description) {
  std::vector<std::string> kinds;
  for (const forms::CellHost& host : description.hosts)
    kinds.insert(kinds.end(), host.agents.begin(), host.agents.end());
  return kinds;
}

DevicePlugin plugin_of(const std::string& agent, const forms::CellDescription& description) {
  const std::string kind = kind_of_agent(agent);
  if (kind == "robot" && description.arm_line.protocol == "plugin") return {"arm", description.arm_line.places.front()};
  if (kind == "vision" && description.eyes.is_plugin()) return {"camera", description.eyes.plugin};
  return {};
}

bool has_pan_tilt(const forms::CellDescription& description) {
  return !description.head.empty() || !description.pan_tilt.kind.empty();
}

bool needs_world(const std::string& agent, const forms::CellDescription& description) {
  const std::string kind = kind_of_agent(agent);
  if (!plugin_of(kind, description).library.empty()) return true;
  if (kind == "robot") return description.arm_line.protocol.empty();
  if (kind == "slave") return description.slave && description.slave->line.protocol.empty();
  if (kind == "pan-tilt") return description.pan_tilt.kind.empty();
  if (kind == "vision") return description.eyes.is_simulated();
  return kind == "person";
}

Result<simulation::WorldConfig> world_config(const forms::CellDescription& description, std::uint64_t seed) {
  simulation::WorldConfig config;
  Result<arm::ArmModel> arm = arm::read_arm_file(description.arm_file);
  if (!arm) return fail(arm);
  config.arm = std::move(*arm);
  if (description.slave) {
    Result<arm::ArmModel> second = arm::read_arm_file(description.slave->arm_file);
    if (!second) return fail(second);
    config.second_arm = std::move(*second);
  }
  config.seed = seed;
  config.cube_mm = description.cube_mm;
  simulation::CameraConfig& camera = config.camera;
  camera.pose = description.world_camera;
  camera.head = description.head;
  camera.frames_per_s = description.frames_per_s;
  camera.noise_sigma = description.noise.sensor_grey;
  camera.blur_sigma_px = description.noise.blur_px;
  camera.light_gradient = description.noise.gradient;
  for (const forms::CubePlacement& cube : description.cubes) {
    const simulation::Mark mark = simulation::mark_from_name(cube.mark).value_or(simulation::Mark::circle);
    config.cubes.push_back({cube.name, mark, cube.x_mm, cube.y_mm, cube.yaw_deg, cube.on, cube.edge_mm});
  }
  const Result<void> sound = simulation::check(config);
  if (!sound) return fail(sound);
  return config;
}

Task<void> BuiltAgent::run() {
  Result<void> ended = co_await agent().run();
  ended_ = std::move(ended);
}

Result<std::unique_ptr<BuiltAgent>> build_agent(const std::string& agent, runtime::AgentContext context,
                                                const forms::CellDescription& description, simulation::Link& link,
                                                Streams* streams) {
  const std::string kind = kind_of_agent(agent);
  if (kind == "robot") {
    Result<arm::ArmModel> model = arm::read_arm_file(description.arm_file);
    if (!model) return fail(model);
    return std::make_unique<BuiltRobot>(std::move(context), description.arm_line, *model,
                                        robot::RobotOptions{room_from(description.arm_room), description.arm_rate_hz},
                                        link, "arm");
  }
  if (kind == "slave" || kind == "follower") {
    if (!description.slave) return fail("unknown-agent", "the cell has no second arm", Datum::symbol(kind));
    return build_second(kind, std::move(context), *description.slave, link);
  }
  if (kind == "vision") {
    std::unique_ptr<camera::StereoCamera> camera;
    if (description.eyes.is_simulated() || description.eyes.is_plugin()) {
      camera = std::make_unique<simulation::SimulatedCamera>(context.executor, link);
    } else {
      camera = std::make_unique<camera::VideoCamera>(context.executor, description.eyes);
    }
    vision::VisionOptions options{.objects_directory = description.objects_directory};
    for (const auto& [family, side_mm] : description.tags) options.tags.push_back({family, side_mm});
    return std::make_unique<BuiltVision>(std::move(context), std::move(camera), streams, std::move(options));
  }
  if (kind == "pan-tilt") {
    if (!has_pan_tilt(description)) return fail("unknown-agent", "the cell has no pan-tilt unit", Datum::symbol(kind));
    return std::make_unique<BuiltPanTilt>(std::move(context), description, link);
  }
  if (kind == "planner") {
    return std::make_unique<WithoutDevice>(std::make_unique<planner::PlannerAgent>(std::move(context)));
  }
  if (kind == "coordinator") {
    return std::make_unique<WithoutDevice>(
        std::make_unique<coordinator::CoordinatorAgent>(std::move(context), coordinator_options(description)));
  }
  if (kind == "speech") {
    return std::make_unique<WithoutDevice>(std::make_unique<speech::SpeechAgent>(std::move(context)));
  }
  if (kind == "person") return build_person(std::move(context), description, link);
  if (const forms::CellSchemeAgent* file = forms::scheme_agent_called(description, agent)) {
    return std::make_unique<WithoutDevice>(
        std::make_unique<scheme::SchemeAgent>(std::move(context), scheme_options(*file)));
  }
  return fail("unknown-agent", fmt::format("there is no agent {}", kind), Datum::symbol(kind));
}

}  // namespace pizarra::launcher
