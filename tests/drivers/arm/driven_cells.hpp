#pragma once

// Every arm driver over its emulated controller in virtual time, with the same handles on the line between them: what
// all drivers must do is tested on all of these.
//
//   template <class Cell> class EveryArm : public testing::Test, protected Cell {};
//   TYPED_TEST_SUITE(EveryArm, DrivenCells);
//
// A cell has `executor`, `arm`, `cabinet`, model(), and
//   cut(true)            the line is cut, or mended
//   spoil(f)             what becomes of what the controller says; nullptr: nothing
//   begin_anew()         the driver is another, as in a process that was started again
//   orders()             how many octets or datagrams the controller was sent

#include <gtest/gtest.h>
#include <memory>

#include "drivers/arm/simple_message/motoros_arm.hpp"
#include "drivers/arm/simple_message/simple_arm.hpp"
#include "drivers/arm/universal/universal_arm.hpp"
#include "drivers/simulation/controllers/arms/motoros_emulator.hpp"
#include "drivers/simulation/controllers/arms/simple_emulator.hpp"
#include "drivers/simulation/controllers/arms/ur_emulator.hpp"
#include "tests/drivers/arm/motoman/host_cell.hpp"

namespace pizarra::arm {

using Spoil = std::function<std::string(std::string)>;

template <class Driver, class... Given>
void replace(Driver& driver, Given&&... given) {
  std::destroy_at(&driver);
  std::construct_at(&driver, std::forward<Given>(given)...);
}

struct DrivenHses : HsesCell {
  static constexpr const char* name = "Hses";
  static const ArmModel& model() { return up6(); }
  void cut(bool now) { line.pulled = now; }
  void spoil(Spoil how) { line.from_device = std::move(how); }
  std::size_t orders() const { return line.sent; }
  void begin_anew() { replace(arm, executor, link, model()); }
};

template <class Cell>
struct DrivenHost : Cell {
  static constexpr const char* name = std::is_same_v<Cell, BscCell> ? "Bsc" : "EthernetServer";
  static const ArmModel& model() { return up6(); }
  void cut(bool now) { Cell::wire.cut(now); }
  void spoil(Spoil how) { Cell::wire.far.spoil = std::move(how); }
  std::size_t orders() const { return Cell::wire.near.written.size(); }
  void begin_anew() { replace(Cell::arm, Cell::executor, Cell::link, model()); }
};

// Several lines, all cut and spoilt together.
template <class Cell>
struct DrivenLines : DrivenArm<Cell> {
  void cut(bool now) {
    for (line::WirePair* line : lines()) line->cut(now);
  }
  void spoil(const Spoil& how) {
    for (line::WirePair* line : lines()) line->far.spoil = how;
  }
  std::size_t orders() {
    std::size_t octets = 0;
    for (line::WirePair* line : lines()) octets += line->near.written.size();
    return octets;
  }

 private:
  std::vector<line::WirePair*> lines() { return static_cast<Cell&>(*this).all_lines(); }
};

struct DrivenUniversal : DrivenLines<DrivenUniversal> {
  static constexpr const char* name = "Universal";
  static const ArmModel& model() {
    static const ArmModel ur5e = shipped_arm("ur5e").value();
    return ur5e;
  }
  std::vector<line::WirePair*> all_lines() { return {&rtde_line, &script_line, &dashboard_line}; }

  VirtualExecutor executor;
  simulation::MovingArm body{executor, model()};
  simulation::ArmCabinet cabinet{executor, body, model()};
  simulation::UrEmulator emulator{cabinet};
  line::WirePair rtde_line{executor};
  line::WirePair script_line{executor};
  line::WirePair dashboard_line{executor};
  Job telling{executor.spawn(simulation::serve_rtde(executor, emulator, rtde_line.far))};
  Job running{executor.spawn(
      simulation::serve_interface(executor, emulator, simulation::UrInterface::secondary, script_line.far))};
  Job answering{executor.spawn(simulation::serve_dashboard(executor, emulator, dashboard_line.far))};
  UniversalWires wires{rtde_line.near, script_line.near, dashboard_line.near};
  UniversalArm arm{executor, wires, model()};
  void begin_anew() { replace(arm, executor, wires, model()); }
};

struct SimpleCell : DrivenLines<SimpleCell> {
  // Until its drives are on.
  explicit SimpleCell(const simulation::SimpleKind& kind_of_line) : kind(kind_of_line) { executor.run_for(300ms); }
  static const ArmModel& model() { return crs_f3(); }
  std::vector<line::WirePair*> all_lines() { return {&motion, &state}; }

  const simulation::SimpleKind kind;
  VirtualExecutor executor;
  simulation::MovingArm body{executor, crs_f3()};
  simulation::ArmCabinet cabinet{executor, body, crs_f3()};
  simulation::SimpleEmulator emulator{cabinet, kind};
  line::WirePair motion{executor};
  line::WirePair state{executor};
  Job moving{executor.spawn(simulation::serve_motion(executor, emulator, motion.far))};
  Job telling{executor.spawn(simulation::serve_state(executor, emulator, state.far))};
  SimpleWires wires{motion.near, state.near, kind.serial, kind.order, kind.sign, kind.track};
  SimpleArm arm{executor, wires, crs_f3()};
  void begin_anew() { replace(arm, executor, wires, crs_f3()); }
};

template <bool serial>
struct DrivenSimple : SimpleCell {
  static constexpr const char* name = serial ? "C500c" : "SimpleMessage";
  DrivenSimple() : SimpleCell({.serial = serial}) {}
};

template <line::ByteOrder order>
struct DrivenMotoros : DrivenLines<DrivenMotoros<order>> {
  static constexpr const char* name = order == line::ByteOrder::little ? "Motoros" : "MotorosBigEndian";
  static const ArmModel& model() { return up6(); }
  std::vector<line::WirePair*> all_lines() { return {&motion, &state}; }

  VirtualExecutor executor;
  simulation::MovingArm body{executor, model()};
  simulation::ArmCabinet cabinet{executor, body, model()};
  simulation::MotorosEmulator emulator{executor, cabinet, order};
  line::WirePair motion{executor};
  line::WirePair state{executor};
  Job moving{executor.spawn(simulation::serve_motion(executor, emulator, motion.far))};
  Job telling{executor.spawn(simulation::serve_state(executor, emulator, state.far))};
  SimpleWires wires{.motion = motion.near, .state = state.near, .order = order};
  MotorosArm arm{executor, wires, model()};
  void begin_anew() { replace(arm, executor, wires, model()); }
};

using DrivenCells =
    testing::Types<DrivenHses, DrivenHost<EthernetCell>, DrivenHost<BscCell>, DrivenUniversal, DrivenSimple<false>,
                   DrivenSimple<true>, DrivenMotoros<line::ByteOrder::little>, DrivenMotoros<line::ByteOrder::big>>;

struct DrivenCellNames {
  template <class Cell>
  static std::string GetName(int) {
    return Cell::name;
  }
};

}  // namespace pizarra::arm
