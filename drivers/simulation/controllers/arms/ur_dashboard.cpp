#include "drivers/simulation/controllers/arms/ur_dashboard.hpp"

#include <algorithm>
#include <cctype>

#include "drivers/arm/universal/rtde.hpp"

namespace pizarra::simulation {

namespace {

std::string yes_no(bool value) { return value ? "true" : "false"; }

// Of a UR5e too it says UR5.
std::string model_name(std::string type) {
  std::ranges::transform(type, type.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  if (type.ends_with('E')) type.pop_back();
  return type;
}

std::string software_of(std::string_view type) {
  return type.ends_with('e') ? "URSoftware 5.11.0.108249 (Jan 01 2021)" : "URSoftware 3.15.0.106331 (Jan 01 2021)";
}

std::string mode_name(std::int32_t mode) {
  return mode == arm::rtde::running_mode ? "RUNNING" : mode == UrPower::idle_mode ? "IDLE" : "POWER_OFF";
}

}  // namespace

Task<std::string> UrDashboard::answer(std::string line) {
  const bool pendant = cabinet_.pendant();
  if (line == "is in remote control") co_return yes_no(!pendant);
  if (line == "get robot model") co_return model_name(cabinet_.model().type);
  if (line == "PolyscopeVersion") co_return software_of(cabinet_.model().type);
  if (line == "robotmode") co_return "Robotmode: " + mode_name(power_.mode());
  if (line == "running") co_return "Program running: " + yes_no(programs_.phase() != UrPrograms::Phase::stopped);
  if (line == "programState") co_return program_state();
  if (line == "safetymode") co_return safety(false);
  if (line == "safetystatus") co_return safety(true);
  if (line == "get loaded program") co_return loaded_program();
  if (line == "get operational mode") co_return std::string(pendant ? "MANUAL" : "AUTOMATIC");
  if (line == "isProgramSaved") co_return std::string("true");
  if (line == "quit") co_return std::string("Disconnected");
  if (line.starts_with("addToLog ")) co_return std::string("Added log message");
  if (line.starts_with("popup ")) co_return std::string("showing popup");
  if (line == "close popup") co_return std::string("closing popup");
  if (line == "close safety popup") co_return std::string("closing safety popup");
  if (pendant) co_return "Command is not allowed due to: local control";
  if (line == "saveLog") co_return std::string("Log saved to disk");
  if (line.starts_with("load ")) co_return programs_.load(line.substr(5));
  if (line == "play") co_return std::string(programs_.play() ? "Starting program" : "Failed to execute: play");
  if (line == "pause") {
    const bool paused = co_await programs_.pause();
    co_return std::string(paused ? "Pausing program" : "Failed to execute: pause");
  }
  if (line == "power on") {
    power_.on();
    co_return std::string("Powering on");
  }
  if (line == "power off") {
    power_.off();
    co_return std::string("Powering off");
  }
  if (line == "brake release") {
    power_.release_brakes();
    co_return std::string("Brake releasing");
  }
  if (line == "unlock protective stop") {
    static_cast<void>(cabinet_.reset());
    co_return std::string("Protective stop releasing");
  }
  if (line == "stop") {
    co_await programs_.end();
    co_return std::string("Stopped");
  }
  co_return "could not understand: " + line;
}

std::string UrDashboard::loaded_program() const {
  return programs_.has_loaded() ? "Loaded program: " + programs_.name() : std::string("No program loaded");
}

std::string UrDashboard::program_state() const {
  const std::string& name = programs_.name();
  constexpr std::string_view phases[] = {"STOPPED ", "PLAYING ", "PAUSED "};
  return std::string(phases[static_cast<std::size_t>(programs_.phase())]) + (name.empty() ? "<unnamed>" : name);
}

// The mode, or the status, which names the emergency stop of the arm's own.
std::string UrDashboard::safety(bool status) const {
  const std::string what = status ? "Safetystatus: " : "Safetymode: ";
  if (cabinet_.emergency()) return what + "ROBOT_EMERGENCY_STOP";
  return what + (cabinet_.alarm() != 0 || cabinet_.pendant_hold() ? "PROTECTIVE_STOP" : "NORMAL");
}

}  // namespace pizarra::simulation
