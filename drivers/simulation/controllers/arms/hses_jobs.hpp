#pragma once

// Jobs that are selected and begun over the High Speed Ethernet Server: files that were sent to it.
//
//   HsesJobs jobs(cabinet, files);
//   const HsesOutcome selected = jobs.select(request);
//   const std::uint16_t refusal = jobs.start();      // 0: it runs
//   jobs.name(), jobs.line(), jobs.runs();

#include <vector>

#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"
#include "drivers/simulation/controllers/arms/hses_files.hpp"
#include "drivers/simulation/controllers/arms/hses_outcome.hpp"

namespace pizarra::simulation {

class HsesJobs {
 public:
  // Both outlive it.
  HsesJobs(ArmCabinet& cabinet, const HsesFiles& files) : cabinet_(cabinet), files_(files) {}
  HsesJobs(const HsesJobs&) = delete;
  HsesJobs& operator=(const HsesJobs&) = delete;

  HsesOutcome select(const arm::HsesRequest& request);
  std::uint16_t start();
  // The one that runs, where one does.
  void end();
  // Of the one that is selected, or runs; empty: none was.
  const std::string& name() const { return name_; }
  std::uint32_t line() const { return line_; }
  bool runs() const { return runs_; }

 private:
  Task<void> run(std::vector<Duration> lines, std::size_t from);

  ArmCabinet& cabinet_;
  const HsesFiles& files_;
  std::string name_;
  std::uint32_t line_ = 0;
  bool runs_ = false;
  Job running_;
};

}  // namespace pizarra::simulation
