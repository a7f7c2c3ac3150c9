#pragma once

// The facts about the head, each told when it changed, under the agent's presence, so that they go with it.
//
//   facts.set_state("ready", "");
//   facts.set_pose(reading, moving);
//   Result<void> told = co_await facts.tell();      // one transaction, none where nothing changed

#include <array>
#include <optional>

#include "agents/runtime/service.hpp"
#include "drivers/ptu/pan_tilt_driver.hpp"

namespace pizarra::pan_tilt {

class HeadFacts {
 public:
  HeadFacts(runtime::AgentContext& context, const runtime::Service& service) : context_(context), service_(service) {}

  // STATE closed, connecting, ready, resetting or lost.
  void set_state(std::string_view state, const std::string& trouble);
  void set_unit(const ptu::PanTiltRange& range);
  void set_pose(const ptu::PanTiltReading& reading, bool moving);
  // Nobody knows where it looks.
  void set_no_pose() { facts_[pose].now.reset(); }
  void set_target(const std::optional<std::string>& name);

  Task<Result<void>> tell();

 private:
  struct Told {
    std::optional<Datum> now;
    std::optional<Datum> told;
  };
  enum : std::size_t { state, unit, pose, target, kinds };

  runtime::AgentContext& context_;
  const runtime::Service& service_;
  std::array<Told, kinds> facts_;
  LeaseId told_under_ = 0;
};

}  // namespace pizarra::pan_tilt
