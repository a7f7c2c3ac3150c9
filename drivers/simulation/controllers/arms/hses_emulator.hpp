#pragma once

// The controller of a Motoman arm as its High Speed Ethernet Server shows it; what it refuses it refuses with Yaskawa's
// codes.
//
//   HsesEmulator emulator(cabinet);
//   const std::string reply = co_await emulator.answer(datagram);       // empty: it says nothing
//   const Job serving = executor.spawn(serve(executor, emulator, *port));
//   const Job filing = executor.spawn(serve_files(executor, emulator, *file_port));
//
// It carries out every datagram that comes, also one that it has had: the manual does not promise more. What it has and
// does is the MotomanController's. A request is carried out only with a service and an attribute that its command has.
// Its jobs are the files that were sent to it (hses_files.hpp, hses_jobs.cpp); it has no clock, so that management
// times begin at no date. The arm has no weight, so that its torques and what it strays from its way are 0.
//
// How far it is proven: with the driver of drivers/arm/motoman/; public clients are named in docs/write-a-driver.md.

#include <map>
#include <vector>

#include "drivers/arm/motoman/hses_packet.hpp"
#include "drivers/line/datagram_wire.hpp"
#include "drivers/simulation/controllers/arms/hses_codes.hpp"
#include "drivers/simulation/controllers/arms/hses_files.hpp"
#include "drivers/simulation/controllers/arms/motoman_controller.hpp"

namespace pizarra::simulation {

class HsesEmulator {
 public:
  // The cabinet outlives it.
  explicit HsesEmulator(ArmCabinet& cabinet) : controller_(cabinet), cabinet_(cabinet) {}
  Task<std::string> answer(std::string datagram);
  // The same of the file control.
  std::string answer_about_files(std::string_view datagram);

 private:
  // The outcome of a request: data, or why not.
  struct Outcome {
    std::uint16_t refusal = 0;
    std::string data = {};
  };
  static Task<Outcome> at_once(Outcome outcome);
  // All of these, or the one whose number is the attribute.
  static Outcome of_elements(const arm::HsesRequest& request, const std::vector<std::string>& elements);
  // Why a request is none that sets this many octets; 0 where it is.
  static std::uint16_t wrong_setting(const arm::HsesRequest& request, std::size_t octets);

  Task<Outcome> carry_out(arm::HsesRequest request);
  Task<Outcome> status(arm::HsesRequest request);
  Task<Outcome> position(arm::HsesRequest request);
  Outcome alarm(const arm::HsesRequest& request) const;
  Outcome report(const arm::HsesRequest& request) const;
  Task<Outcome> variable(arm::HsesRequest request, HsesVariable kind);
  Task<Outcome> variables(arm::HsesRequest request, HsesVariable kind);
  Task<std::string> value(HsesVariable kind, std::uint16_t number);
  Task<std::uint16_t> set_value(HsesVariable kind, std::uint16_t number, std::string octets);
  Outcome turn(const arm::HsesRequest& request);
  Outcome select_job(const arm::HsesRequest& request);
  std::uint16_t start_job();
  Task<void> run_job(std::vector<Duration> lines, std::size_t from);
  Outcome management_time(const arm::HsesRequest& request) const;
  std::uint16_t turn_power(std::uint16_t instance, std::uint32_t wanted);
  Task<Outcome> move_pulses(arm::HsesRequest request);
  Task<Outcome> move_cartesian(arm::HsesRequest request);

  MotomanController controller_;
  ArmCabinet& cabinet_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::string> values_;  // by command and number
  HsesFiles files_;
  std::string job_;  // that is selected, or runs; empty: none was
  std::uint32_t job_line_ = 0;
  bool job_runs_ = false;
  Job running_job_;
};

// Until destroyed. All three outlive it.
Task<void> serve(Executor& executor, HsesEmulator& emulator, line::DatagramWire& port);
Task<void> serve_files(Executor& executor, HsesEmulator& emulator, line::DatagramWire& port);

}  // namespace pizarra::simulation
