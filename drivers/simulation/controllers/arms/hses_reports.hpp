#pragma once

// What the controller tells of itself and its arm over the High Speed Ethernet Server. The arm has no weight, so that
// its torques and what it strays from its way are 0. There is no clock, so that management times begin at no date.
//
//   const HsesReports reports(controller, cabinet, jobs);
//   const HsesOutcome outcome = co_await reports.position(request);

#include "drivers/simulation/controllers/arms/hses_jobs.hpp"
#include "drivers/simulation/controllers/arms/hses_outcome.hpp"
#include "drivers/simulation/controllers/arms/motoman_controller.hpp"

namespace pizarra::simulation {

class HsesReports {
 public:
  // All outlive it.
  HsesReports(MotomanController& controller, const ArmCabinet& cabinet, const HsesJobs& jobs)
      : controller_(controller), cabinet_(cabinet), jobs_(jobs) {}

  Task<HsesOutcome> status(arm::HsesRequest request) const;
  Task<HsesOutcome> position(arm::HsesRequest request) const;
  HsesOutcome alarm(const arm::HsesRequest& request) const;
  // The job, the names of the axes, the system, torques and errors of position.
  HsesOutcome report(const arm::HsesRequest& request) const;
  // How long the controller and its arm have been at work.
  HsesOutcome management_time(const arm::HsesRequest& request) const;

 private:
  MotomanController& controller_;
  const ArmCabinet& cabinet_;
  const HsesJobs& jobs_;
};

}  // namespace pizarra::simulation
