#include "agents/launcher/agent_factory.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

#include "agents/coordinator/pursue/coordinator_agent.hpp"
#include "agents/follower/follower_agent.hpp"
#include "agents/launcher/cell_arm.hpp"
#include "agents/launcher/cell_pictures.hpp"
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

template <class Agent, class... Arguments>
std::unique_ptr<BuiltAgent> built(Parts devices, Arguments&&... arguments) {
  return std::make_unique<BuiltAgent>(std::move(devices),
                                      std::make_unique<Agent>(std::forward<Arguments>(arguments)...));
}

class BuiltRobot : public BuiltAgent {
 public:
  BuiltRobot(Parts devices, std::unique_ptr<robot::RobotAgent> agent, robot::RobotAgent& robot)
      : BuiltAgent(std::move(devices), std::move(agent)), robot_(robot) {}
  Task<void> stand_still() override { return robot_.stand_still(); }

 private:
  robot::RobotAgent& robot_;
};

Result<std::unique_ptr<BuiltAgent>> build_robot(runtime::AgentContext context, const forms::ArmLine& line,
                                                const std::string& arm_file, robot::RobotOptions options,
                                                simulation::Link& link, std::string_view simulated) {
  const Result<arm::ArmModel> model = arm::read_arm_file(arm_file);
  if (!model) return fail(model);
  Parts devices;
  arm::ArmDriver& arm = add_cell_arm(devices, context.executor, line, *model, link, simulated);
  auto agent = std::make_unique<robot::RobotAgent>(std::move(context), arm, *model, options);
  robot::RobotAgent& robot = *agent;
  return std::make_unique<BuiltRobot>(std::move(devices), std::move(agent), robot);
}

// The line to its unit: the simulated one's where the cell names no other.
line::ByteWire& add_wire(Parts& parts, Executor& executor, const forms::PanTiltLine& line, simulation::Link& link) {
  if (line.kind == "serial") return parts.add<line::SerialWire>(executor, line.where, line.number);
  if (line.kind == "tcp") {
    return parts.add<line::TcpWire>(executor, line.where, static_cast<std::uint16_t>(line.number));
  }
  return parts.add<simulation::HeadWire>(executor, link);
}

std::unique_ptr<BuiltAgent> build_pan_tilt(runtime::AgentContext context, const forms::CellDescription& description,
                                           simulation::Link& link) {
  Parts devices;
  const forms::PanTiltLine& line = description.pan_tilt;
  line::ByteWire& wire = add_wire(devices, context.executor, line, link);
  auto& driver =
      devices.add<ptu::PtuDriver>(context.executor, wire, ptu::PtuDirections{line.pan_reversed, line.tilt_reversed});
  return built<pan_tilt::PanTiltAgent>(std::move(devices), std::move(context), driver, description.camera.pose);
}

// With the eyes that it looks through.
std::unique_ptr<BuiltAgent> build_vision(runtime::AgentContext context, const forms::CellDescription& description,
                                         simulation::Link& link, Streams* streams) {
  std::unique_ptr<camera::StereoCamera> eyes;
  if (description.eyes.is_simulated() || description.eyes.is_plugin()) {
    eyes = std::make_unique<simulation::SimulatedCamera>(context.executor, link);
  } else {
    eyes = std::make_unique<camera::VideoCamera>(context.executor, description.eyes);
  }
  Parts devices;
  camera::StereoCamera& camera = devices.keep(std::move(eyes));
  vision::VisionOptions options{.objects_directory = description.objects_directory};
  for (const auto& [family, side_mm] : description.tags) options.tags.push_back({family, side_mm});
  for (const auto& [name, family, number, side_mm] : description.tagged) {
    options.tagged.push_back({name, {family, number}, side_mm});
  }
  for (const auto& [name, marks] : description.bodies) options.bodies.push_back({name, marks});
  return built<vision::VisionAgent>(std::move(devices), std::move(context), camera, streams, std::move(options));
}

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

std::optional<robot::WorkVolume> room_from(const std::optional<forms::CellRoom>& given) {
  if (!given) return {};
  const auto& [low, high] = *given;
  return robot::WorkVolume{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

// The second arm's robot agent, or the one that has it follow the first.
Result<std::unique_ptr<BuiltAgent>> build_second(const std::string& kind, runtime::AgentContext context,
                                                 const forms::CellSlave& slave, simulation::Link& link) {
  if (kind == "follower") {
    const auto& [x_mm, y_mm, z_mm] = slave.offset_mm;
    const follower::FollowerOptions options{.offset_mm = {x_mm, y_mm, z_mm}, .mirrored = slave.mirrored};
    return built<follower::FollowerAgent>({}, std::move(context), options);
  }
  return build_robot(std::move(context), slave.line, slave.arm_file,
                     {room_from(slave.room), slave.rate_hz, "second-arms"}, link, "second-arm");
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
  return built<person::PersonAgent>({}, std::move(context), link, std::move(names));
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

Result<void> put_faces(simulation::CubeConfig& config, const forms::CubePlacement& cube) {
  for (const auto& [face_name, mark_name] : cube.faces) {
    const std::optional<simulation::CubeFace> face = simulation::cube_face_from_name(face_name);
    const std::optional<simulation::FaceMark> mark = simulation::face_mark_from_name(mark_name);
    if (!face || !mark) {
      return fail("bad-cell", fmt::format("no simulated cube bears {} on its {}", mark_name, face_name),
                  Datum::string(cube.name));
    }
    config.faces[static_cast<std::size_t>(*face)] = *mark;
  }
  return {};
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
  camera.model = camera.model.with_size(description.image.width_px, description.image.height_px);
  camera.pose = description.world_camera;
  camera.head = description.head;
  camera.frames_per_s = description.frames_per_s;
  camera.noise_sigma = description.noise.sensor_grey;
  camera.blur_sigma_px = description.noise.blur_px;
  camera.light_gradient = description.noise.gradient;
  camera.lens = description.lens;
  if (description.second_lamp) {
    config.second_lamp = simulation::LampConfig{description.second_lamp->at_mm, description.second_lamp->part};
  }
  const Result<void> pictured = put_pictures(config, description);
  if (!pictured) return fail(pictured);
  for (const forms::CubePlacement& cube : description.cubes) {
    const std::optional<simulation::FaceMark> mark = simulation::face_mark_from_name(cube.mark);
    if (!mark)
      return fail("bad-cell", fmt::format("{} is no mark of the simulated world", cube.mark), Datum::string(cube.name));
    config.cubes.push_back({cube.name, *mark, cube.x_mm, cube.y_mm, cube.yaw_deg, cube.on, cube.edge_mm});
    const Result<void> faced = put_faces(config.cubes.back(), cube);
    if (!faced) return fail(faced);
  }
  for (const forms::ThingPlacement& thing : description.things) {
    const auto& [x_mm, y_mm, z_mm] = thing.size_mm;
    config.things.push_back({thing.name, {thing.is_round, {x_mm, y_mm, z_mm}}, thing.x_mm, thing.y_mm, thing.yaw_deg});
  }
  const Result<void> sound = simulation::check(config);
  if (!sound) return fail(sound);
  return config;
}

Task<void> BuiltAgent::run() {
  Result<void> ended = co_await agent_->run();
  ended_ = std::move(ended);
}

Result<std::unique_ptr<BuiltAgent>> build_agent(const std::string& agent, runtime::AgentContext context,
                                                const forms::CellDescription& description, simulation::Link& link,
                                                Streams* streams) {
  const std::string kind = kind_of_agent(agent);
  if (kind == "robot") {
    return build_robot(std::move(context), description.arm_line, description.arm_file,
                       {room_from(description.arm_room), description.arm_rate_hz}, link, "arm");
  }
  if (kind == "slave" || kind == "follower") {
    if (!description.slave) return fail("unknown-agent", "the cell has no second arm", Datum::symbol(kind));
    return build_second(kind, std::move(context), *description.slave, link);
  }
  if (kind == "vision") return build_vision(std::move(context), description, link, streams);
  if (kind == "pan-tilt") {
    if (!has_pan_tilt(description)) return fail("unknown-agent", "the cell has no pan-tilt unit", Datum::symbol(kind));
    return build_pan_tilt(std::move(context), description, link);
  }
  if (kind == "planner") return built<planner::PlannerAgent>({}, std::move(context));
  if (kind == "coordinator") {
    return built<coordinator::CoordinatorAgent>({}, std::move(context), coordinator_options(description));
  }
  if (kind == "speech") return built<speech::SpeechAgent>({}, std::move(context));
  if (kind == "person") return build_person(std::move(context), description, link);
  if (const forms::CellSchemeAgent* file = forms::scheme_agent_called(description, agent)) {
    return built<scheme::SchemeAgent>({}, std::move(context), scheme_options(*file));
  }
  return fail("unknown-agent", fmt::format("there is no agent {}", kind), Datum::symbol(kind));
}

}  // namespace pizarra::launcher
