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
// Its variables, jobs, reports and moves carry requests out.
//
// How far it is proven: with the driver of drivers/arm/motoman/; public clients are named in docs/write-a-driver.md.

#include "drivers/line/datagram_wire.hpp"
#include "drivers/simulation/controllers/arms/hses_reports.hpp"
#include "drivers/simulation/controllers/arms/hses_variables.hpp"
#include "drivers/simulation/controllers/arms/motoman_controller.hpp"

namespace pizarra::simulation {

class HsesEmulator {
 public:
  // The cabinet outlives it.
  explicit HsesEmulator(ArmCabinet& cabinet) : controller_(cabinet), cabinet_(cabinet) {}
  HsesEmulator(const HsesEmulator&) = delete;
  HsesEmulator& operator=(const HsesEmulator&) = delete;
  Task<std::string> answer(std::string datagram);
  // The same of the file control.
  std::string answer_about_files(std::string_view datagram);

 private:
  Task<HsesOutcome> carry_out(arm::HsesRequest request);
  HsesOutcome turn(const arm::HsesRequest& request);
  std::uint16_t turn_power(std::uint16_t instance, std::uint32_t wanted);

  MotomanController controller_;
  ArmCabinet& cabinet_;
  HsesFiles files_;
  HsesVariables variables_{controller_};
  HsesJobs jobs_{cabinet_, files_};
  HsesReports reports_{controller_, cabinet_, jobs_};
};

// Until destroyed. All three outlive it.
Task<void> serve(Executor& executor, HsesEmulator& emulator, line::DatagramWire& port);
Task<void> serve_files(Executor& executor, HsesEmulator& emulator, line::DatagramWire& port);

}  // namespace pizarra::simulation
