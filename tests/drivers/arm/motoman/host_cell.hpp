#pragma once

// A Motoman arm driven by the host control of an emulated controller in virtual time, over either of its lines.
//
//   EthernetCell cell;      // TCP
//   BscCell cell;           // serial

#include "drivers/arm/motoman/bsc_line.hpp"
#include "drivers/arm/motoman/ethernet_line.hpp"
#include "drivers/arm/motoman/host_link.hpp"
#include "drivers/arm/motoman/motoman_arm.hpp"
#include "drivers/simulation/controllers/arms/host_control.hpp"
#include "drivers/simulation/controllers/arms/moving_arm.hpp"
#include "tests/drivers/arm/driven_arm.hpp"
#include "tests/drivers/arm/motoman/hses_cell.hpp"
#include "tests/drivers/line/wire_pair.hpp"

namespace pizarra::arm {

template <class Line, auto serve>
struct HostCell : DrivenArm<HostCell<Line, serve>> {
  VirtualExecutor executor;
  simulation::MovingArm body{executor, up6()};
  simulation::ArmCabinet cabinet{executor, body, up6()};
  simulation::HostControl control{cabinet};
  line::WirePair wire{executor};
  Job serving{executor.spawn(serve(executor, control, wire.far))};
  Line line{executor, wire.near};
  HostLink link{line};
  MotomanArm arm{executor, link, up6()};
};

using EthernetCell = HostCell<EthernetLine, &simulation::serve_ethernet_server>;
using BscCell = HostCell<BscLine, &simulation::serve_bsc>;

}  // namespace pizarra::arm
